// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll/enroll_page.h"

#include "ui/context/workbench.h"
#include "ui/pages/enroll/enroll_name_step.h"
#include "ui/pages/enroll/enroll_review_panel.h"
#include "ui/pages/enroll/enroll_squeeze_panel.h"
#include "ui/pages/part_picture.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/pages/tour_script.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/progress.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

struct EnrollPage::Private {
    StepLine* steps = nullptr;
    QPushButton *undo = nullptr, *redo = nullptr, *later = nullptr;
    QStackedWidget* stack = nullptr;
    EnrollNameStep* name = nullptr;
    EnrollRecipeForm* recipe = nullptr;
    QString recipeOf; ///< the type whose recipe the form has
    QLabel* recipeHint = nullptr;
    QPushButton* recipeNext = nullptr;
    EnrollSqueezePanel* squeezes = nullptr;
    EnrollReviewPanel* review = nullptr;
    QLabel* done = nullptr;
    PartPictureView* donePicture = nullptr;
    QPushButton *again = nullptr, *inspect = nullptr;
    EnrollSession::Step shown = EnrollSession::Step::Name;
    bool active = false;
    TourScript tour;
};

EnrollPage::EnrollPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->stack = new QStackedWidget(this);
    d->name = new EnrollNameStep(bench, this);
    d->squeezes = new EnrollSqueezePanel(bench, this);
    d->review = new EnrollReviewPanel(bench, this);
    for (QWidget* step :
         {static_cast<QWidget*>(d->name), makeRecipeStep(), static_cast<QWidget*>(d->squeezes),
          static_cast<QWidget*>(d->review), makeDoneStep()})
        d->stack->addWidget(step);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addLayout(makeTop());
    column->addWidget(d->stack, 1);
    setFocusPolicy(Qt::StrongFocus);

    connect(&bench, &Workbench::enrollmentChanged, this, &EnrollPage::refresh);
    connect(&bench, &Workbench::connectionChanged, this, &EnrollPage::refresh);
    connect(&bench, &Workbench::inspectionChanged, d->name, &EnrollNameStep::refresh);
    connect(d->name, &EnrollNameStep::named, this, &EnrollPage::submitName);
    connect(d->name, &EnrollNameStep::goOn, this, [this](const QString& name) {
        d->squeezes->leaveToPerson();
        tell(workbench().enrollment().resumeDraft(name));
    });
    connect(&d->name->drafts(), &EnrollDrafts::changed, this, &EnrollPage::refreshUndo);
    connect(d->squeezes, &EnrollSqueezePanel::changed, this, &EnrollPage::refresh);
    connect(d->review, &EnrollReviewPanel::changed, this, &EnrollPage::refresh);
    d->name->begin();
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

QLayout* EnrollPage::makeTop()
{
    d->steps = new StepLine({tr("Name"), tr("Recipe"), tr("Squeeze"), tr("Review"), tr("Approve")}, this);
    d->undo = makeButton({}, u"edit-undo"_s, "quiet", this);
    d->undo->setObjectName("undoStep");
    d->redo = makeButton({}, u"edit-redo"_s, "quiet", this);
    d->redo->setObjectName("redoStep");
    for (QPushButton* button : {d->undo, d->redo})
        button->setFixedWidth(56);
    d->later = makeButton(tr("Leave for later"), {}, "", this);
    d->later->setObjectName("leaveForLater");
    d->later->setToolTip(tr("Keeps this enrolment as it is and goes back to the first step"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(d->steps, 1);
    row->addWidget(d->undo);
    row->addWidget(d->redo);
    row->addWidget(d->later);
    connect(d->undo, &QPushButton::clicked, this, &EnrollPage::undo);
    connect(d->redo, &QPushButton::clicked, this, &EnrollPage::redo);
    connect(d->later, &QPushButton::clicked, this, &EnrollPage::startAnew);
    const auto key = [this](QKeySequence::StandardKey keys, void (EnrollPage::*action)()) {
        auto* shortcut = new QShortcut(keys, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, action);
    };
    key(QKeySequence::Undo, &EnrollPage::undo);
    key(QKeySequence::Redo, &EnrollPage::redo);
    return row;
}

QWidget* EnrollPage::makeRecipeStep()
{
    auto* step = new QWidget(this);
    QVBoxLayout* column = makeFormCard(step);
    column->addWidget(makeLabel(tr("How is it squeezed?"), "heading", step));
    d->recipeHint = makeLabel({}, "second", step);
    d->recipeHint->setObjectName("recipeHint");
    d->recipeHint->setWordWrap(true);
    column->addWidget(d->recipeHint);
    d->recipe = new EnrollRecipeForm(workbench(), EnrollRecipeForm::Gripped::Part, step);
    column->addWidget(d->recipe);
    auto* row = new QHBoxLayout;
    QPushButton* back = makeButton(tr("Back"), {}, "", step);
    back->setObjectName("recipeBack");
    d->recipeNext = makeButton(tr("Continue (Enter)"), {}, "primary", step);
    d->recipeNext->setObjectName("recipeNext");
    row->addWidget(back);
    row->addStretch(1);
    row->addWidget(d->recipeNext);
    column->addLayout(row);
    connect(back, &QPushButton::clicked, this, [this] { tell(workbench().enrollment().back()); });
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
    d->donePicture = new PartPictureView(workbench(), 104, PartPictureView::Empty::Hidden, step);
    column->addWidget(d->donePicture);
    auto* what = makeLabel(tr("Parts of this type are recognised from now on. More squeezes can be added "
                              "later under the same name."),
                           "second", step);
    what->setWordWrap(true);
    column->addWidget(what);
    auto* row = new QHBoxLayout;
    d->again = makeButton(tr("Enroll another type"), u"list-add"_s, "", step);
    d->again->setObjectName("enrollAnother");
    d->inspect = makeButton(tr("Inspect parts"), u"answer-correct"_s, "primary", step);
    d->inspect->setObjectName("inspectParts");
    row->addWidget(d->again);
    row->addStretch(1);
    row->addWidget(d->inspect);
    column->addLayout(row);
    connect(d->again, &QPushButton::clicked, this, &EnrollPage::startAnew);
    connect(d->inspect, &QPushButton::clicked, this, [this] {
        startAnew();
        workbench().navigator().showPage(u"inspect"_s);
    });
    return step;
}

void EnrollPage::startAnew()
{
    workbench().enrollment().restart();
    d->squeezes->leaveToPerson();
    d->recipeOf.clear();
    d->name->begin();
    refresh();
}

void EnrollPage::tell(const Expected<void>& done)
{
    if (!done)
        workbench().messages().report(done.error().describe());
    refresh();
}

void EnrollPage::submitName(const QString& name)
{
    tell(workbench().enrollment().setName(name));
}

void EnrollPage::showRecipe()
{
    const EnrollSession& session = workbench().enrollment();
    const TypeRecord* known = nullptr;
    for (const TypeRecord& type : workbench().inspection().types())
        if (type.name == session.typeName())
            known = &type;
    d->recipeHint->setText(
        known && known->approved ? tr("%1 is approved. With the first squeeze that is added its approval is "
                                      "void: its parts are not "
                                      "recognised until it is approved again. Its recipe stays as it is.")
                                       .arg(session.typeName())
        : known
            ? tr("%1 is known: its recipe stays as it is, so that all its squeezes can be compared.")
                  .arg(session.typeName())
            : tr("Pushes and releases about a preload; no squeeze of this type goes above the crush limit."));
    if (d->recipeOf == session.typeName() && !known)
        return; // what was typed stays
    d->recipeOf = session.typeName();
    d->recipe->setRecipe(known ? known->recipe : session.recipe(), known != nullptr);
}

void EnrollPage::submitRecipe()
{
    if (d->recipe->isValid())
        tell(workbench().enrollment().setRecipe(d->recipe->recipe()));
}

void EnrollPage::undo()
{
    if (workbench().enrollment().step() == EnrollSession::Step::Name)
        return d->name->drafts().bringBack();
    d->squeezes->leaveToPerson();
    supervised(workbench().enrollment().undoable(), [this] { tell(workbench().enrollment().undo()); });
}

void EnrollPage::supervised(const std::optional<EnrollSession::Act>& act, std::function<void()> then)
{
    // What takes a squeeze out of its type, or back into it.
    const bool counts =
        act && (act->kind == EnrollSession::Act::Kind::Accept || act->kind == EnrollSession::Act::Kind::Drop);
    if (counts)
        authorize(workbench(), this, Permission::DropSqueezes, std::move(then));
    else
        then();
}

void EnrollPage::redo()
{
    d->squeezes->leaveToPerson();
    supervised(workbench().enrollment().redoable(), [this] { tell(workbench().enrollment().redo()); });
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
    if (step == EnrollSession::Step::Approved) {
        d->done->setText(tr("%1 is enrolled with %2 squeezes.")
                             .arg(session.typeName(), QString::number(session.acceptedCount())));
        d->donePicture->setPicture(session.picture());
    }
    refreshUndo();
    if (step == d->shown)
        return;
    d->shown = step;
    if (step == EnrollSession::Step::Recipe)
        showRecipe();
    if (step == EnrollSession::Step::Review)
        d->review->load();
    if (d->active)
        focusStep();
}

void EnrollPage::refreshUndo()
{
    const EnrollSession& session = workbench().enrollment();
    const bool first = session.step() == EnrollSession::Step::Name;
    const std::optional<EnrollSession::Act> undoable = session.undoable();
    const std::optional<EnrollSession::Act> redoable = session.redoable();
    d->undo->setEnabled(first ? d->name->drafts().canBringBack() : undoable.has_value());
    d->redo->setEnabled(redoable.has_value());
    const QString undo = first      ? tr("Undo: discard an enrolment (Ctrl+Z)")
                         : undoable ? tr("Undo: %1 (Ctrl+Z)").arg(inWords(*undoable))
                                    : tr("Undo (Ctrl+Z): nothing now");
    const QString redo = redoable ? tr("Redo: %1 (Ctrl+Shift+Z)").arg(inWords(*redoable))
                                  : tr("Redo (Ctrl+Shift+Z): nothing now");
    d->undo->setToolTip(undo);
    d->undo->setAccessibleName(undo);
    d->redo->setToolTip(redo);
    d->redo->setAccessibleName(redo);
    d->later->setVisible(!first && session.step() != EnrollSession::Step::Approved);
}

QString EnrollPage::inWords(const EnrollSession::Act& act) const
{
    using Kind = EnrollSession::Act::Kind;
    const int number = act.squeeze + 1;
    switch (act.kind) {
    case Kind::Name:
        return tr("the name");
    case Kind::Recipe:
        return tr("the recipe");
    case Kind::Review:
        return tr("going to the review");
    case Kind::Squeeze:
        return tr("taking squeeze %1").arg(number);
    case Kind::Accept:
        return tr("accepting squeeze %1").arg(number);
    case Kind::Reject:
        return tr("rejecting squeeze %1").arg(number);
    case Kind::Drop:
        return tr("dropping squeeze %1").arg(number);
    }
    return {};
}

void EnrollPage::focusStep()
{
    switch (workbench().enrollment().step()) {
    case EnrollSession::Step::Name:
        d->name->focusField();
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
        d->inspect->setFocus();
        break;
    }
}

void EnrollPage::setActive(bool active)
{
    d->active = active;
    if (!active)
        return;
    if (workbench().enrollment().step() == EnrollSession::Step::Name)
        d->name->drafts().load();
    refresh();
    focusStep();
}

void EnrollPage::keyPressEvent(QKeyEvent* event)
{
    const EnrollSession::Step step = workbench().enrollment().step();
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->isAutoRepeat()) // a key that is held neither walks through the steps nor squeezes
        return Page::keyPressEvent(event);
    if (enter && step == EnrollSession::Step::Name)
        return d->name->submit();
    if (enter && step == EnrollSession::Step::Recipe)
        return submitRecipe();
    if (event->key() == Qt::Key_Space && step == EnrollSession::Step::Squeeze)
        return d->squeezes->squeezeOrAccept();
    Page::keyPressEvent(event);
}

void EnrollPage::prepareTour()
{
    TourScript& tour = d->tour;
    EnrollSession& session = workbench().enrollment();
    tour.connectTo(workbench(), u"virtual:?object=0.031,52,13500&seed=31&speed=0"_s);
    tour.add(
        [this] {
            d->squeezes->setAcceptsByItself(false); // the picture shows a decision
            submitName(tr("Cola 330 ml"));
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
