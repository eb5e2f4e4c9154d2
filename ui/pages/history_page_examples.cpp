// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_page_examples.h"

#include "core/recognition/paper_appendix.h"
#include "ui/pages/fit_page_example.h"
#include "ui/workbench.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Last first: they are taken from the end.
std::vector<Recording> simulateExamples()
{
    std::vector<Recording> recordings;
    const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
    std::uint64_t seed = 1;
    for (const std::size_t row : {31, 5, 12, 25, 2, 38, 17})
        recordings.push_back(simulatedSqueeze(squeezes[row].parameters, seed++));
    recordings.push_back(simulatedSqueeze({0.06, 70, 15000}, seed)); // none of the types
    return recordings;
}

} // namespace

ExampleInspections::ExampleInspections(Workbench& workbench, QObject* parent)
    : QObject(parent), m_workbench(&workbench)
{
    connect(m_workbench, &Workbench::ticked, this, [this] { judgeNext(); });
}

void ExampleInspections::start()
{
    m_busy = true;
    m_workbench->ask<InspectionCounts>(
        this, [](Library& library) { return library.inspectionCounts(); },
        [this](Expected<InspectionCounts> counts) {
            if (!counts || counts->total > 0) {
                finish();
                return;
            }
            m_workbench->compute<std::vector<Recording>>(this, simulateExamples,
                                                         [this](std::vector<Recording> recordings) {
                                                             m_waiting = std::move(recordings);
                                                             m_simulated = true;
                                                         });
        });
}

void ExampleInspections::judgeNext()
{
    InspectSession& inspection = m_workbench->inspection();
    if (!m_busy || !m_simulated || inspection.state() != InspectSession::State::Ready)
        return;
    if (inspection.storing())
        return;
    if (m_waiting.empty() || !inspection.judgeRecording(m_waiting.back(), u"simulated"_s)) {
        finish();
        return;
    }
    m_waiting.pop_back();
}

void ExampleInspections::finish()
{
    m_busy = false;
    m_waiting.clear();
    emit finished();
}

} // namespace gripscope
