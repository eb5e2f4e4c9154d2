// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/types/reidentify_dialog.h"

#include "core/identification/estimators/estimator_table.h"
#include "ui/context/stepped_work.h"
#include "ui/context/workbench.h"
#include "ui/format/estimate_words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QTableView>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int twoLineHeight = 48;        // two lines
constexpr std::size_t storedAtOnce = 10; // each waits for the disk

/// Steps that store every estimate that was found.
SteppedWork::Step storing(const std::vector<ReidentifiedSqueeze>& results, const Reidentification& how)
{
    struct Storing {
        std::vector<std::pair<QString, Estimate>> estimates;
        std::size_t next = 0;
    };
    auto state = std::make_shared<Storing>();
    for (const ReidentifiedSqueeze& result : results)
        if (result.estimate && result.estimate->parameters)
            state->estimates.emplace_back(result.entry.graspId, *result.estimate);
    return [state, how](Library& library) -> Expected<SteppedWork::Progress> {
        const std::size_t end = std::min(state->next + storedAtOnce, state->estimates.size());
        for (; state->next < end; ++state->next) {
            const auto& [id, estimate] = state->estimates[state->next];
            RETURN_IF_ERROR(library.addReidentification(id, estimate, how));
        }
        return SteppedWork::Progress{end, state->estimates.size(), end < state->estimates.size()};
    };
}

const RegisteredDialog<ReidentifyDialog> reidentifyDialogRow("identify again",
                                                             [](Workbench& bench, QWidget* over) {
                                                                 return new ReidentifyDialog(bench, {}, over);
                                                             });
} // namespace

ReidentifyDialog::ReidentifyDialog(Workbench& workbench, std::vector<QString> graspIds, QWidget* parent)
    : Dialog(parent), m_workbench(&workbench), m_ids(std::move(graspIds)),
      m_job(new ReidentifyJob(workbench, this)), m_model(new ReidentifyModel(this)),
      m_progress(new QProgressBar), m_state(makeLabel({}, "second"))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("reidentifyDialog");
    setManualPage(u"history"_s);
    setWindowTitle(tr("Identify again"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 3 * metrics::step, 2 * metrics::step);
    auto* what = makeLabel(
        tr("%n squeeze(s) with another estimator. Nothing that was stored changes: what you keep is stored "
           "beside it, with your name, and verdicts stay as they were.",
           nullptr, int(m_ids.size())));
    what->setWordWrap(true);
    column->addWidget(what);
    column->addWidget(buildOptions());
    auto* table = new QTableView;
    table->setObjectName("reidentifyTable");
    table->setModel(m_model);
    table->setAccessibleName(tr("Stored and found now"));
    table->setShowGrid(false);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(twoLineHeight);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    column->addWidget(table, 1);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Squeezes done"));
    column->addWidget(m_progress);
    m_state->setWordWrap(true);
    m_state->setObjectName("reidentifyState");
    column->addWidget(m_state);
    column->addWidget(buildButtons());
    connect(m_job, &ReidentifyJob::progressed, this, [this] {
        m_model->append(m_job->results().back());
        refresh();
    });
    connect(m_job, &ReidentifyJob::ended, this, &ReidentifyDialog::refresh);
    resize(800, 560);
    refresh();
}

QWidget* ReidentifyDialog::buildOptions()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    m_estimator = new QComboBox;
    m_estimator->setObjectName("reidentifyEstimator");
    m_estimator->setAccessibleName(tr("Estimator"));
    for (const Estimator estimator : estimatorsOfTypes())
        m_estimator->addItem(estimatorName(estimator), int(estimator));
    m_estimator->setCurrentIndex(m_estimator->findData(int(Estimator::InstrumentalVariables)));
    m_hold = new QComboBox;
    m_hold->setAccessibleName(tr("Force between samples"));
    m_hold->setToolTip(m_hold->accessibleName());
    m_hold->addItem(tr("Hold as recorded"));
    m_hold->addItem(tr("Force held"), int(ForceHold::Zero));
    m_hold->addItem(tr("Force straight"), int(ForceHold::First));
    m_initial = new QComboBox;
    m_initial->setAccessibleName(tr("Start of the squeeze"));
    m_initial->setToolTip(m_initial->accessibleName());
    m_initial->addItem(tr("Free start"), int(InitialState::Free));
    m_initial->addItem(tr("Starts at rest"), int(InitialState::Rest));
    m_offset = new QCheckBox(tr("Free offset"));
    m_offset->setChecked(true);
    m_offset->setMinimumHeight(metrics::touchTarget);
    m_start = makeButton({}, u"view-refresh"_s, "primary");
    m_start->setObjectName("reidentifyStart");
    for (QWidget* widget : {static_cast<QWidget*>(m_estimator), static_cast<QWidget*>(m_hold),
                            static_cast<QWidget*>(m_initial), static_cast<QWidget*>(m_offset)})
        line->addWidget(widget);
    line->addStretch();
    line->addWidget(m_start);
    connect(m_start, &QPushButton::clicked, this, &ReidentifyDialog::start);
    return bar;
}

QWidget* ReidentifyDialog::buildButtons()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    m_close = makeButton(tr("Close"));
    m_keep = makeButton(tr("Keep these estimates"), u"document-save"_s);
    m_keep->setObjectName("reidentifyKeep");
    line->addStretch();
    line->addWidget(m_close);
    line->addWidget(m_keep);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_keep, &QPushButton::clicked, this, &ReidentifyDialog::keep);
    return bar;
}

Reidentification ReidentifyDialog::how() const
{
    Reidentification how;
    if (m_hold->currentIndex() > 0)
        how.hold = ForceHold(m_hold->currentData().toInt());
    how.initialState = InitialState(m_initial->currentData().toInt());
    how.freeOffset = m_offset->isChecked();
    how.operatorName = m_workbench->operatorName();
    return how;
}

void ReidentifyDialog::start()
{
    if (m_job->running()) {
        m_job->cancel();
        return;
    }
    m_model->clear();
    m_kept = false;
    m_used = how();
    m_job->start(m_ids, Estimator(m_estimator->currentData().toInt()), m_used);
    refresh();
}

void ReidentifyDialog::keep()
{
    m_keeping = true;
    auto* work = new SteppedWork(*m_workbench, storing(m_job->results(), m_used), this);
    connect(work, &SteppedWork::ended, this, [this](bool complete) {
        m_keeping = false;
        m_kept = complete;
        refresh();
        emit kept();
    });
    work->start();
    refresh();
}

void ReidentifyDialog::refresh()
{
    const auto found = std::count_if(
        m_job->results().begin(), m_job->results().end(),
        [](const ReidentifiedSqueeze& squeeze) { return squeeze.estimate && squeeze.estimate->parameters; });
    const int done = int(m_job->results().size());
    const bool running = m_job->running();
    for (QWidget* choice : {static_cast<QWidget*>(m_estimator), static_cast<QWidget*>(m_hold),
                            static_cast<QWidget*>(m_initial), static_cast<QWidget*>(m_offset)})
        choice->setEnabled(!running && !m_keeping);
    m_start->setText(running ? tr("Cancel") : tr("Identify"));
    m_start->setAccessibleName(m_start->text());
    m_start->setEnabled(!m_keeping);
    m_keep->setEnabled(!running && !m_keeping && !m_kept && found > 0);
    m_progress->setRange(0, std::max(1, int(m_ids.size())));
    m_progress->setValue(done);
    if (m_kept)
        m_state->setText(tr("%n estimate(s) stored beside the first ones.", nullptr, int(found)));
    else if (done > 0)
        m_state->setText(tr("%1 of %2 done, m, b and k found in %3.").arg(done).arg(m_ids.size()).arg(found));
    else
        m_state->setText(tr("The first line of a cell is what is stored, the second what is found now."));
}

} // namespace gripscope
