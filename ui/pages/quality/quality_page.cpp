// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/quality_page.h"

#include "ui/context/workbench.h"
#include "ui/pages/quality/process/process_view.h"
#include "ui/pages/quality/shift/shift_views.h"
#include "ui/pages/quality/study_views.h"
#include "ui/pages/quality/study_words.h"
#include "ui/pages/tour_script.h"
#include "ui/widgets/controls.h"

#include <QKeyEvent>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

using StudyStep = StudySession::State;

struct QualityPage::Private {
    QStackedWidget* stack = nullptr;
    StudyList* list = nullptr;
    StudyForm* form = nullptr;
    StudyLead* lead = nullptr;
    StudyOutcome* outcome = nullptr;
    DriftView* drift = nullptr;
    TransferView* transfer = nullptr;
    ProcessView* process = nullptr;
    View view = View::List;
    bool active = false;
    bool opening = false; ///< the library was asked for a study
    StudyStep step = StudyStep::Idle;
    TourScript tour;
};

QualityPage::QualityPage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->stack = new QStackedWidget(this);
    d->list = new StudyList(bench, this);
    d->form = new StudyForm(bench, this);
    d->lead = new StudyLead(bench, this);
    d->outcome = new StudyOutcome(bench, this);
    d->drift = new DriftView(bench, this);
    d->transfer = new TransferView(bench, this);
    d->process = new ProcessView(bench, this);
    for (QWidget* view : std::initializer_list<QWidget*>{d->list, d->form, d->lead, d->outcome, d->drift,
                                                         d->transfer, d->process})
        d->stack->addWidget(view);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 12);
    column->addWidget(d->stack, 1);
    setFocusPolicy(Qt::StrongFocus);
    d->lead->setFocusPolicy(Qt::StrongFocus);

    connect(&bench, &Workbench::studyChanged, this, &QualityPage::follow);
    connect(&bench, &Workbench::connectionChanged, this, [this] {
        if (d->view == View::Lead)
            d->lead->refresh();
        if (d->view == View::Transfer)
            d->transfer->refresh();
    });
    connect(d->list, &StudyList::beginAsked, this, &QualityPage::beginForm);
    connect(d->list, &StudyList::driftAsked, this, [this] {
        d->drift->load();
        show(View::Drift);
    });
    connect(d->list, &StudyList::transferAsked, this, [this] {
        workbench().study().leave();
        d->transfer->begin();
        show(View::Transfer);
    });
    connect(d->drift, &DriftView::left, this, [this] { show(View::List); });
    connect(d->transfer, &TransferView::left, this, &QualityPage::leaveStudy);
    connect(d->transfer, &TransferView::submitted, this, &QualityPage::begin);
    connect(d->list, &StudyList::openAsked, this, &QualityPage::open);
    connect(d->list, &StudyList::processAsked, this, [this] { show(View::Process); });
    connect(d->process, &ProcessView::left, this, [this] { show(View::List); });
    connect(d->process, &ProcessView::squeezeAsked, this, &QualityPage::squeezeAsked);
    connect(d->form, &StudyForm::submitted, this, &QualityPage::begin);
    connect(d->form, &StudyForm::cancelled, this, [this] { show(View::List); });
    connect(d->lead, &StudyLead::paused, this, &QualityPage::leaveStudy);
    connect(d->outcome, &StudyOutcome::left, this, &QualityPage::leaveStudy);
    auto* undo = new QShortcut(QKeySequence::Undo, this);
    undo->setContext(Qt::WidgetWithChildrenShortcut);
    connect(undo, &QShortcut::activated, this, [this] {
        if (d->view == View::Lead)
            d->lead->undo();
        if (d->view == View::Transfer)
            d->transfer->undo();
    });
    // A study that was under way when the window was built anew goes on.
    if (bench.study().study()) {
        d->opening = true;
        follow();
    }
}

QualityPage::~QualityPage() = default;

QString QualityPage::id() const
{
    return u"quality"_s;
}

QString QualityPage::title() const
{
    return tr("Quality");
}

QString QualityPage::iconName() const
{
    return u"office-chart-bar"_s;
}

void QualityPage::show(View view)
{
    d->view = view;
    d->stack->setCurrentIndex(static_cast<int>(view));
    if (view == View::List)
        d->list->load();
    d->process->setActive(d->active && view == View::Process);
    if (d->active)
        focusView();
}

void QualityPage::follow()
{
    const StudyStep step = workbench().study().state();
    const bool ended = step == StudyStep::Ended;
    if (d->opening && step != StudyStep::Storing) {
        d->opening = false;
        if (workbench().study().study())
            showStudy();
    } else if (ended && d->step != StudyStep::Ended && d->view == View::Lead) {
        show(View::Outcome);
    }
    d->step = step;
    if (d->view == View::Lead)
        d->lead->refresh();
    if (d->view == View::Outcome)
        d->outcome->refresh();
    if (d->view == View::Transfer)
        d->transfer->refresh();
}

void QualityPage::showStudy()
{
    const bool isTransfer = workbench().study().study()->plan.design.kind == StudyKind::Transfer;
    show(isTransfer                                        ? View::Transfer
         : workbench().study().state() == StudyStep::Ended ? View::Outcome
                                                           : View::Lead);
}

QString QualityPage::suggestedName(StudyKind kind) const
{
    QStringList taken;
    for (const StudyRecord& study : d->list->studies())
        taken << study.study.name;
    const QString pattern = kind == StudyKind::Gauge       ? tr("Gauge %1")
                            : kind == StudyKind::TypeOne   ? tr("Type-1 %1")
                            : kind == StudyKind::Linearity ? tr("Linearity %1")
                                                           : tr("Attributes %1");
    int number = 1;
    while (taken.contains(pattern.arg(number)))
        ++number;
    return pattern.arg(number);
}

void QualityPage::beginForm(StudyKind kind)
{
    d->form->begin(kind, suggestedName(kind));
    show(View::Form);
}

void QualityPage::begin(const StudyRequest& request)
{
    workbench().study().leave();
    const Expected<void> begun = workbench().study().begin(request);
    d->opening = begun.has_value();
    tell(begun);
}

void QualityPage::open(const QString& studyId)
{
    workbench().study().leave();
    const Expected<void> asked = workbench().study().resume(studyId);
    d->opening = asked.has_value();
    tell(asked);
}

void QualityPage::leaveStudy()
{
    workbench().study().leave();
    d->step = workbench().study().state();
    show(View::List);
}

void QualityPage::tell(const Expected<void>& done)
{
    if (!done)
        workbench().messages().report(done.error().describe());
}

void QualityPage::focusView()
{
    switch (d->view) {
    case View::List:
        setFocus();
        break;
    case View::Form:
        d->form->focusField();
        break;
    case View::Lead:
        d->lead->focusNext();
        break;
    case View::Outcome:
        d->outcome->focusFirst();
        break;
    case View::Drift:
        d->drift->focusFirst();
        break;
    case View::Transfer:
        d->transfer->focusFirst();
        break;
    case View::Process:
        d->process->focusFirst();
        break;
    }
}

void QualityPage::setActive(bool active)
{
    d->active = active;
    d->process->setActive(active && d->view == View::Process);
    if (!active)
        return;
    if (d->view == View::List)
        d->list->load();
    if (d->view == View::Drift)
        d->drift->load();
    follow();
    focusView();
}

void QualityPage::keyPressEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat() && event->key() == Qt::Key_Space && d->view == View::Lead)
        return d->lead->act();
    if (!event->isAutoRepeat() && event->key() == Qt::Key_Space && d->view == View::Transfer)
        return d->transfer->act();
    Page::keyPressEvent(event);
}

void QualityPage::prepareTour()
{
    TourScript& tour = d->tour;
    StudySession& session = workbench().study();
    tour.connectTo(workbench(), u"virtual:?object=0.031,52,13500&seed=31&speed=0"_s);
    tour.add(
        [this, &session] {
            StudyRequest request;
            request.name = tr("Cola 330 ml, tray 1");
            request.design.parts = numberedParts(3);
            request.design.operators = QStringList{u"Anna"_s, u"Ben"_s};
            request.design.trials = 2;
            request.design.seed = 7;
            request.recipe = recipeOfNewTypes();
            session.setOperator(workbench().operatorName());
            begin(request);
        },
        [&session] { return session.state() == StudyStep::Waiting; });
    tour.add([this] { d->lead->act(); },
             [this, &session] {
                 // As a person would, once more, where a busy machine starved the gripper's heartbeat.
                 if (session.state() == StudyStep::Waiting && !workbench().connection().armed())
                     workbench().arm();
                 else if (session.state() == StudyStep::Waiting && session.progress().done < 5)
                     d->lead->act();
                 return session.state() == StudyStep::Waiting && session.progress().done >= 5;
             });
    tour.wait(200);
    tour.start(workbench());
}

bool QualityPage::tourReady() const
{
    return d->tour.done();
}

} // namespace gripscope
