// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/process/process_view.h"

#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/session/process/process_words.h"
#include "core/signal/recording/units.h"
#include "ui/charts/control_plot.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/process/process_capability_panel.h"
#include "ui/pages/quality/process/process_controls.h"
#include "ui/pages/quality/process/process_names.h"
#include "ui/pages/quality/process/process_signal_list.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QScrollArea>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int sideWidth = 272; // logical pixels
constexpr int signalsHeight = 132;

/// Of the type in the units of the values; none for a type that is gone.
std::pair<PartLimits, double> ownLimits(const std::vector<TypeRecord>& types, const QString& name)
{
    const auto type = std::ranges::find(types, name, &TypeRecord::name);
    if (type == types.end())
        return {{}, 1};
    return {type->limits, siFactor(type->forceUnit, type->positionUnit).value_or(1)};
}

} // namespace

ProcessView::ProcessView(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_session(workbench.library())
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    column->addWidget(makeHead());
    m_controls = new ProcessControls(this);
    column->addWidget(m_controls);
    column->addWidget(makeBusy());
    m_empty = makeLabel({}, "second", this);
    m_empty->setObjectName("processEmpty");
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    column->addWidget(m_empty, 1);
    m_content = new QWidget(this);
    auto* row = new QHBoxLayout(m_content);
    setSpacing(row, 0, 8);
    row->addWidget(makeCharts(), 1);
    row->addWidget(makeSide());
    column->addWidget(m_content, 1);
    connectAll();
    m_session.setOptions(m_controls->options());
    showState();
}

ProcessView::~ProcessView() = default;

QWidget* ProcessView::makeHead()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    QPushButton* back = makeButton(tr("All studies"), u"go-previous"_s, "", box);
    back->setObjectName("processBack");
    m_facts = new ElidedLabel({}, box);
    m_facts->setObjectName("processFacts");
    setRole(m_facts, "caption");
    m_fix = makeButton(tr("Fix limits"), u"object-locked"_s, "", box);
    m_fix->setObjectName("processFix");
    m_fix->setToolTip(
        tr("From the inspections in view (drag over a stretch to bring it into view): later ones "
           "are then judged by these limits, and Inspect tells what they signal"));
    m_release = makeButton(tr("Release"), u"object-unlocked"_s, "", box);
    m_release->setObjectName("processRelease");
    m_release->setToolTip(tr("No fixed limits any more: the inspections shown settle them"));
    m_csv = makeButton(tr("CSV…"), {}, "", box);
    m_csv->setObjectName("processCsv");
    m_csv->setToolTip(tr("Every point of these charts, as a table"));
    m_report = makeButton(tr("Report (PDF)…"), {}, "primary", box);
    m_report->setObjectName("processReport");
    row->addWidget(back);
    row->addWidget(m_facts, 1);
    for (QPushButton* button : {m_fix, m_release, m_csv, m_report})
        row->addWidget(button);
    connect(back, &QPushButton::clicked, this, &ProcessView::left);
    connect(m_csv, &QPushButton::clicked, this, [this] {
        chooseFile(tr("Save the charts' points"), tr("CSV (*.csv)"), u"csv"_s, &ProcessView::writeCsv);
    });
    connect(m_report, &QPushButton::clicked, this, [this] {
        chooseFile(tr("Save the report"), tr("PDF (*.pdf)"), u"pdf"_s, &ProcessView::writeReport);
    });
    return box;
}

QWidget* ProcessView::makeBusy()
{
    m_busy = new QWidget(this);
    auto* row = new QHBoxLayout(m_busy);
    setSpacing(row, 0, 8);
    m_doing = makeLabel({}, "caption", m_busy);
    m_doing->setObjectName("processDoing");
    m_progress = new QProgressBar(m_busy);
    m_progress->setObjectName("processProgress");
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setRange(0, 100);
    m_cancel = makeButton(tr("Cancel"), {}, "", m_busy);
    m_cancel->setObjectName("processCancel");
    m_again = makeButton(tr("Read again"), u"view-refresh"_s, "", m_busy);
    m_again->setObjectName("processAgain");
    row->addWidget(m_doing);
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    row->addWidget(m_again);
    row->addStretch();
    return m_busy;
}

QWidget* ProcessView::makeCharts()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    setSpacing(column, 0, 8);
    QFrame* card = makeCard(box);
    auto* inside = new QVBoxLayout(card);
    setSpacing(inside, 8, 4);
    m_charts = new ControlView(card);
    m_charts->setObjectName("processCharts");
    m_limits = makeLabel({}, "caption", card);
    m_limits->setObjectName("processLimits");
    m_missing = makeLabel({}, "error", card);
    m_missing->setObjectName("processMissing");
    inside->addWidget(m_missing);
    inside->addWidget(m_charts, 1);
    inside->addWidget(m_limits);
    m_signals = new ProcessSignalList(box);
    m_signals->setMaximumHeight(signalsHeight);
    m_runLengths = makeLabel({}, "caption", box);
    m_runLengths->setObjectName("processRunLengths");
    for (QLabel* label : {m_limits, m_missing, m_runLengths})
        label->setWordWrap(true);
    column->addWidget(card, 1);
    column->addWidget(m_signals);
    column->addWidget(m_runLengths);
    return box;
}

QWidget* ProcessView::makeSide()
{
    m_capability = new ProcessCapabilityPanel(this);
    QScrollArea* scroll = makeScroll(m_capability, this);
    scroll->setFixedWidth(sideWidth);
    return scroll;
}

void ProcessView::connectAll()
{
    connect(m_controls, &ProcessControls::queryChanged, this, &ProcessView::takeQuery);
    connect(m_controls, &ProcessControls::filterChanged, this, [this] {
        m_session.setFilter(m_controls->filter());
        showState();
    });
    connect(m_controls, &ProcessControls::optionsChanged, this, &ProcessView::takeOptions);
    connect(m_controls, &ProcessControls::quantityChanged, this, [this] {
        if (m_controls->quantity() < ProcessNames::allQuantities)
            m_capability->choose(m_controls->quantity());
        showPicture();
    });
    connect(m_capability, &ProcessCapabilityPanel::limitsChanged, this, &ProcessView::takeOptions);
    connect(m_signals, &ProcessSignalList::pointShown, this,
            [this](qsizetype point) { m_charts->showPoint(std::size_t(point)); });
    connect(m_signals, &ProcessSignalList::rowChosen, this, &ProcessView::openRow);
    connect(m_charts, &ControlView::rowChosen, this, &ProcessView::openRow);
    connect(m_fix, &QPushButton::clicked, this, &ProcessView::fixLimits);
    connect(m_release, &QPushButton::clicked, this, [this] {
        authorize(*m_workbench, this, Permission::ChangeTypes,
                  [this] { m_session.release(m_workbench->operatorName()); });
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_session.cancel();
        showState();
    });
    connect(m_again, &QPushButton::clicked, this, [this] {
        m_session.reload();
        showState();
    });
    connect(m_workbench, &Workbench::ticked, this, &ProcessView::poll);
    connect(m_workbench, &Workbench::libraryChanged, this, [this] {
        if (!m_active)
            return;
        askChoices();
        m_session.refresh();
    });
}

void ProcessView::setActive(bool active)
{
    const bool comes = active && !m_active;
    m_active = active;
    if (!comes)
        return;
    askChoices();
    if (m_session.state() == ProcessSession::State::Idle)
        takeQuery();
    else
        m_session.refresh();
    showState();
}

void ProcessView::focusFirst()
{
    m_controls->focusType();
}

void ProcessView::askChoices()
{
    m_workbench->background().ask<HistoryChoices>(
        this,
        [](Library& library) -> Expected<HistoryChoices> {
            ASSIGN_OR_RETURN(HistoryChoices choices, library.historyChoices());
            ASSIGN_OR_RETURN(choices.types, library.typeNamesToday(choices.types));
            return choices;
        },
        [this](Expected<HistoryChoices> choices) {
            m_asked = true;
            if (!choices)
                return m_workbench->messages().report(choices.error().describe());
            m_controls->setGrippers(choices->devices);
            m_controls->setTypes(choices->types);
            showState();
        });
}

void ProcessView::takeQuery()
{
    const ProcessQuery query = m_controls->query();
    if (query.type != m_session.query().type) {
        const auto own = ownLimits(m_workbench->inspection().types(), query.type);
        m_capability->setOwnLimits(own.first, own.second);
        takeOptions();
    }
    if (m_active)
        m_session.setQuery(query);
    showState();
}

void ProcessView::takeOptions()
{
    ProcessOptions options = m_controls->options();
    options.limits = m_capability->limits();
    m_session.setOptions(options);
    showState();
}

void ProcessView::poll()
{
    if (!m_session.poll())
        return;
    const std::optional<Error>& error = m_session.error();
    if (error && (!m_told || !(m_told->describe() == error->describe())))
        m_workbench->messages().report(error->describe());
    m_told = error;
    showState();
}

void ProcessView::showState()
{
    using State = ProcessSession::State;
    const State state = m_session.state();
    const bool stopped = state == State::Cancelled || state == State::Failed;
    const bool first = m_session.busy() && !m_session.picture(); // later pictures follow in no time
    m_busy->setVisible(first || stopped);
    m_doing->setText(state == State::Reading   ? tr("Reading the inspections…")
                     : state == State::Drawing ? tr("Drawing the charts…")
                     : state == State::Failed  ? tr("The inspections could not be read.")
                                               : tr("Cancelled."));
    m_progress->setVisible(m_session.busy());
    m_progress->setValue(state == State::Drawing ? 100 : int(100 * m_session.share()));
    m_cancel->setVisible(m_session.busy());
    m_again->setVisible(stopped);
    if (m_session.picture() != m_shown) {
        m_shown = m_session.picture();
        if (m_shown)
            m_controls->setChoices(*m_shown->values);
        m_capability->show(m_shown);
        showPicture();
    }
    showEmpty();
}

void ProcessView::showEmpty()
{
    const bool anything = m_shown && !m_shown->rows.empty();
    QString words;
    if (m_asked && !m_controls->hasType())
        words =
            tr("No type is enrolled yet. Enroll one, then inspect parts of it: the charts show how their m, "
               "b and k go.");
    else if (m_shown && m_shown->values->empty())
        words = tr("No inspection has recognised a part of this type yet.");
    else if (m_shown && m_shown->rows.empty())
        words = tr("No inspection matches the filters.");
    m_empty->setText(words);
    m_empty->setVisible(!anything);
    m_content->setVisible(anything);
    for (QPushButton* button : {m_fix, m_csv, m_report})
        button->setEnabled(anything && !m_charts->panels().empty());
    m_release->setVisible(m_session.fixedLimits().has_value());
    m_facts->setFullText(m_shown ? tr("%1 inspections").arg(formatCount(qint64(m_shown->rows.size())))
                                 : QString());
}

void ProcessView::showPicture()
{
    if (!m_shown)
        return;
    const std::size_t quantity = m_controls->quantity();
    m_charts->setPicture(m_shown, ProcessNames::panels(*m_shown, quantity));
    m_signals->show(m_shown, quantity);
    m_limits->setText(ProcessNames::limits(m_session));
    m_runLengths->setText(runLengthSentence(m_shown->runLengths, m_shown->options).describe());
    QStringList missing;
    for (std::size_t i = 0; i < ProcessNames::allQuantities; ++i)
        if (quantity >= ProcessNames::allQuantities || i == quantity)
            missing << ProcessNames::missing(*m_shown, i);
    missing.removeAll(QString());
    missing.removeDuplicates();
    m_missing->setText(missing.join(u' '));
    m_missing->setVisible(!missing.isEmpty());
}

void ProcessView::fixLimits()
{
    const auto numbers = m_charts->numbersInView();
    if (!numbers)
        return;
    authorize(*m_workbench, this, Permission::ChangeTypes, [this, numbers] {
        const Expected<void> fixed =
            m_session.fix(numbers->first, numbers->second, m_workbench->operatorName());
        if (!fixed)
            m_workbench->messages().report(fixed.error().describe());
    });
}

void ProcessView::openRow(quint32 row)
{
    if (!m_shown || row >= m_shown->values->size())
        return;
    m_workbench->background().ask<QString>(
        this,
        [number = m_shown->values->numbers[row]](Library& library) {
            return library.inspectedSqueeze(number);
        },
        [this](const Expected<QString>& key) {
            if (key)
                emit squeezeAsked(*key);
            else
                m_workbench->messages().report(key.error().describe());
        });
}

} // namespace gripscope
