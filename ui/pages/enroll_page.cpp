// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll_page.h"

#include "ui/pages/enroll_recipe_form.h"
#include "ui/pages/enroll_review_panel.h"
#include "ui/pages/enroll_squeeze_panel.h"
#include "ui/pages/enrolled_types_dialog.h"
#include "ui/tour_script.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/step_line.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

struct EnrollPage::Private {
    StepLine* steps = nullptr;
    QStackedWidget* stack = nullptr;
    QLineEdit* name = nullptr;
    QLabel* nameHint = nullptr;
    QPushButton* nameNext = nullptr;
    EnrollRecipeForm* recipe = nullptr;
    QLabel* recipeHint = nullptr;
    QPushButton* recipeNext = nullptr;
    EnrollSqueezePanel* squeezes = nullptr;
    EnrollReviewPanel* review = nullptr;
    QLabel* done = nullptr;
    QPushButton* again = nullptr;
    EnrollSession::Step shown = EnrollSession::Step::Name;
    bool active = false;
    TourScript tour;
};

namespace {

/// A card of readable width in the middle of the page, for the steps that are a form.
QVBoxLayout* makeFormCard(QWidget* step)
{
    QFrame* card = makeCard(step);
    card->setMaximumWidth(680);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 24, 12);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(card, 8);
    row->addStretch(1);
    auto* outer = new QVBoxLayout(step);
    setSpacing(outer, 0, 0);
    outer->addLayout(row);
    outer->addStretch(1);
    return column;
}

} // namespace

EnrollPage::EnrollPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->steps = new StepLine({tr("Name"), tr("Recipe"), tr("Squeeze"), tr("Review"), tr("Approve")}, this);
    d->stack = new QStackedWidget(this);
    d->squeezes = new EnrollSqueezePanel(bench, this);
    d->review = new EnrollReviewPanel(bench, this);
    for (QWidget* step : {makeNameStep(), makeRecipeStep(), static_cast<QWidget*>(d->squeezes),
                          static_cast<QWidget*>(d->review), makeDoneStep()})
        d->stack->addWidget(step);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addWidget(d->steps);
    column->addWidget(d->stack, 1);
    setFocusPolicy(Qt::StrongFocus);

    connect(&bench, &Workbench::enrollmentChanged, this, &EnrollPage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &EnrollPage::refresh);
    connect(&bench, &Workbench::inspectionChanged, this, &EnrollPage::refreshNameHint);
    connect(d->squeezes, &EnrollSqueezePanel::changed, this, &EnrollPage::refresh);
    connect(d->review, &EnrollReviewPanel::changed, this, &EnrollPage::refresh);
    if (bench.enrollment().step() == EnrollSession::Step::Recipe) // begun in a window before this one
        showRecipe();
    refresh();
}

EnrollPage::~EnrollPage() = default;

QString EnrollPage::id() const
{
    return u"enroll"_s;
}

QString EnrollPage::title() const
{
    return tr("Enroll");
}

QString EnrollPage::iconName() const
{
    return u"list-add"_s;
}

QWidget* EnrollPage::makeNameStep()
{
    auto* step = new QWidget(this);
    QVBoxLayout* column = makeFormCard(step);
    column->addWidget(makeLabel(tr("What is the type called?"), "heading", step));
    auto* why = makeLabel(tr("As a technician would say it, for instance “Cola 330 ml”. The name appears in "
                             "large letters when a "
                             "part of this type is inspected."),
                          "second", step);
    why->setWordWrap(true);
    column->addWidget(why);
    d->name = new QLineEdit(step);
    d->name->setObjectName("typeName");
    d->name->setMaxLength(60);
    d->name->setAccessibleName(tr("Name of the type"));
    d->name->setPlaceholderText(tr("Name of the type"));
    column->addWidget(d->name);
    d->nameHint = makeLabel({}, "second", step);
    d->nameHint->setWordWrap(true);
    column->addWidget(d->nameHint);
    d->nameNext = makeButton(tr("Continue"), {}, "primary", step);
    d->nameNext->setObjectName("nameNext");
    QPushButton* types = makeButton(tr("Enrolled types…"), {}, "quiet", step);
    types->setObjectName("enrolledTypesButton");
    types->setToolTip(tr("Rename, merge, split or retire types; undo changes"));
    auto* row = new QHBoxLayout;
    row->addWidget(types);
    row->addStretch(1);
    row->addWidget(d->nameNext);
    column->addLayout(row);
    connect(types, &QPushButton::clicked, this,
            [this] { (new EnrolledTypesDialog(workbench(), this))->open(); });
    connect(d->name, &QLineEdit::textChanged, this, &EnrollPage::refreshNameHint);
    connect(d->name, &QLineEdit::returnPressed, this, &EnrollPage::submitName);
    connect(d->nameNext, &QPushButton::clicked, this, &EnrollPage::submitName);
    refreshNameHint();
    return step;
}

QWidget* EnrollPage::makeRecipeStep()
{
    auto* step = new QWidget(this);
    QVBoxLayout* column = makeFormCard(step);
    column->addWidget(makeLabel(tr("How is it squeezed?"), "heading", step));
    d->recipeHint = makeLabel({}, "second", step);
    d->recipeHint->setWordWrap(true);
    column->addWidget(d->recipeHint);
    d->recipe = new EnrollRecipeForm(workbench(), step);
    column->addWidget(d->recipe);
    auto* row = new QHBoxLayout;
    QPushButton* back = makeButton(tr("Back"), {}, "", step);
    back->setObjectName("recipeBack");
    d->recipeNext = makeButton(tr("Continue"), {}, "primary", step);
    d->recipeNext->setObjectName("recipeNext");
    row->addWidget(back);
    row->addStretch(1);
    row->addWidget(d->recipeNext);
    column->addLayout(row);
    connect(back, &QPushButton::clicked, this, [this] {
        if (const Expected<void> done = workbench().enrollment().back(); !done)
            workbench().report(done.error().describe());
        refresh();
    });
    connect(d->recipeNext, &QPushButton::clicked, this, &EnrollPage::submitRecipe);
    connect(d->recipe, &EnrollRecipeForm::changed, this,
            [this] { d->recipeNext->setEnabled(d->recipe->isValid()); });
    return step;
}

QWidget* EnrollPage::makeDoneStep()
{
    auto* step = new QWidget(this);
    QVBoxLayout* column = makeFormCard(step);
    d->done = makeLabel({}, "heading", step);
    d->done->setObjectName("doneLabel");
    d->done->setWordWrap(true);
    column->addWidget(d->done);
    auto* what = makeLabel(tr("Parts of this type are recognised from now on. More squeezes can be added "
                              "later under the same name."),
                           "second", step);
    what->setWordWrap(true);
    column->addWidget(what);
    auto* row = new QHBoxLayout;
    d->again = makeButton(tr("Enroll another type"), u"list-add"_s, "", step);
    d->again->setObjectName("enrollAnother");
    QPushButton* inspect = makeButton(tr("Inspect parts"), u"answer-correct"_s, "primary", step);
    row->addWidget(d->again);
    row->addStretch(1);
    row->addWidget(inspect);
    column->addLayout(row);
    connect(d->again, &QPushButton::clicked, this, [this] {
        workbench().enrollment().restart();
        d->name->clear();
        refresh();
    });
    connect(inspect, &QPushButton::clicked, this, [this] {
        workbench().enrollment().restart();
        d->name->clear();
        refresh();
        workbench().showPage(u"inspect"_s);
    });
    return step;
}

void EnrollPage::refreshNameHint()
{
    const QString name = d->name->text().trimmed();
    d->nameNext->setEnabled(!name.isEmpty());
    d->nameHint->clear();
    for (const TypeRecord& type : workbench().inspection().types())
        if (type.name == name)
            d->nameHint->setText(
                tr("This type is known (squeezes so far: %1). The enrolment goes on with its own recipe.")
                    .arg(type.squeezes));
    d->nameHint->setVisible(!d->nameHint->text().isEmpty());
}

void EnrollPage::submitName()
{
    if (d->name->text().trimmed().isEmpty())
        return;
    if (const Expected<void> done = workbench().enrollment().setName(d->name->text()); !done) {
        workbench().report(done.error().describe());
        return;
    }
    showRecipe();
    refresh();
}

void EnrollPage::showRecipe()
{
    Recipe recipe;
    bool known = false;
    for (const TypeRecord& type : workbench().inspection().types())
        if (type.name == workbench().enrollment().typeName()) {
            recipe = type.recipe;
            known = true;
        }
    d->recipe->setRecipe(recipe, known);
    d->recipeHint->setText(
        known ? tr("%1 is known: its recipe stays as it is, so that all its squeezes can be compared.")
                    .arg(workbench().enrollment().typeName())
              : tr("A preload, and on it a push and a release that follow one another at random. The limits "
                   "hold "
                   "for every squeeze of this type."));
}

void EnrollPage::submitRecipe()
{
    if (const Expected<void> done = workbench().enrollment().setRecipe(d->recipe->recipe()); !done)
        workbench().report(done.error().describe());
    refresh();
}

void EnrollPage::refresh()
{
    const EnrollSession& session = workbench().enrollment();
    const EnrollSession::Step step = session.step();
    const int index = static_cast<int>(step);
    d->steps->setCurrent(step == EnrollSession::Step::Approved ? 5 : index);
    d->stack->setCurrentIndex(index);
    if (step == EnrollSession::Step::Recipe)
        d->recipeNext->setEnabled(d->recipe->isValid() &&
                                  session.activity() == EnrollSession::Activity::Waiting);
    if (step == EnrollSession::Step::Squeeze)
        d->squeezes->refresh();
    if (step == EnrollSession::Step::Approved)
        d->done->setText(
            tr("%1 is enrolled with %2 squeezes.").arg(session.typeName()).arg(session.acceptedCount()));
    if (step != d->shown) {
        d->shown = step;
        if (step == EnrollSession::Step::Review)
            d->review->load();
        if (d->active)
            focusStep();
    }
}

void EnrollPage::focusStep()
{
    switch (workbench().enrollment().step()) {
    case EnrollSession::Step::Name:
        d->name->setFocus();
        break;
    case EnrollSession::Step::Recipe:
        d->recipe->setFocus();
        break;
    case EnrollSession::Step::Squeeze:
        d->squeezes->focusNext();
        break;
    case EnrollSession::Step::Review:
        d->review->setFocus();
        break;
    case EnrollSession::Step::Approved:
        d->again->setFocus();
        break;
    }
}

void EnrollPage::setActive(bool active)
{
    d->active = active;
    if (!active)
        return;
    refresh();
    focusStep();
}

void EnrollPage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat() &&
        workbench().enrollment().step() == EnrollSession::Step::Squeeze) {
        d->squeezes->squeezeOrAccept();
        return;
    }
    Page::keyPressEvent(event);
}

void EnrollPage::prepareTour()
{
    TourScript& tour = d->tour;
    EnrollSession& session = workbench().enrollment();
    tour.connectTo(workbench(), u"virtual:?object=0.031,52,13500&seed=31"_s);
    tour.add(
        [this] {
            d->name->setText(tr("Cola 330 ml"));
            submitName();
        },
        [&session] { return session.step() == EnrollSession::Step::Recipe; });
    tour.add([this] { submitRecipe(); },
             [&session] { return session.step() == EnrollSession::Step::Squeeze; });
    const auto squeeze = [this, &tour, &session] {
        tour.add([this] { d->squeezes->squeezeOrAccept(); },
                 [this, &session] {
                     // A busy machine may have starved the gripper's heartbeat: as a person would, once more.
                     if (session.activity() == EnrollSession::Activity::Waiting &&
                         !workbench().connection().armed())
                         workbench().arm();
                     else if (session.activity() == EnrollSession::Activity::Waiting)
                         d->squeezes->squeezeOrAccept();
                     return session.activity() == EnrollSession::Activity::Deciding;
                 });
    };
    for (int i = 1; i <= 7; ++i) {
        squeeze();
        tour.add([this] { d->squeezes->squeezeOrAccept(); },
                 [&session, i] { return session.acceptedCount() == i; });
    }
    squeeze();
    tour.wait(200);
    tour.start(workbench());
}

bool EnrollPage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
