// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/reidentify_job.h"

#include "core/session/enrollment_storage.h"
#include "ui/workbench.h"

namespace gripscope {

namespace {

struct Stored {
    HistoryEntry entry;
    Expected<Recording> recording;
};

Expected<Stored> fetch(Library& library, const QString& graspId)
{
    auto entries = library.historyEntries({graspId});
    if (!entries)
        return tl::unexpected<Error>(entries.error());
    if (entries->empty())
        return failure(ErrorCode::NotFound, {graspId});
    return Stored{std::move(entries->front()), library.recording(graspId)};
}

/// The object alone, the empty gripper taken off, as it is stored for squeezes of the first time.
Estimate reidentify(const Recording& recording, Estimator estimator, const Reidentification& how)
{
    IdentificationOptions options;
    options.estimators = {estimator};
    options.hold = how.hold;
    options.initialState = how.initialState;
    options.freeOffset = how.freeOffset;
    options.assess = false;
    const Identification found = identify(recording, options);
    NewGrasp grasp = makeGrasp(recording, found, {}, {});
    Estimate estimate = grasp.estimates.empty() ? Estimate() : std::move(grasp.estimates.front());
    estimate.simulated.clear();
    estimate.residual.clear();
    return estimate;
}

} // namespace

ReidentifyJob::ReidentifyJob(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
}

void ReidentifyJob::start(std::vector<QString> graspIds, Estimator estimator, const Reidentification& how)
{
    m_ids = std::move(graspIds);
    m_results.clear();
    m_estimator = estimator;
    m_how = how;
    m_cancelled = false;
    m_running = true;
    next();
}

void ReidentifyJob::cancel()
{
    m_cancelled = true;
}

void ReidentifyJob::next()
{
    if (m_cancelled || m_results.size() >= m_ids.size()) {
        m_running = false;
        emit ended();
        return;
    }
    m_workbench->ask<Stored>(
        this, [id = m_ids[m_results.size()]](Library& library) { return fetch(library, id); },
        [this](Expected<Stored> stored) {
            if (!stored)
                return take({{}, {}, stored.error().describe()});
            if (!stored->recording)
                return take({stored->entry,
                             {},
                             stored->recording.error().code == ErrorCode::NotFound
                                 ? tr("no recording was stored with it")
                                 : stored->recording.error().describe()});
            m_workbench->compute<Estimate>(
                this,
                [recording = std::move(*stored->recording), estimator = m_estimator, how = m_how] {
                    return reidentify(recording, estimator, how);
                },
                [this, entry = stored->entry](Estimate estimate) {
                    const QString trouble =
                        estimate.parameters ? QString() : QString::fromStdString(estimate.message);
                    take({entry, std::move(estimate), trouble});
                });
        });
}

void ReidentifyJob::take(ReidentifiedSqueeze squeeze)
{
    m_results.push_back(std::move(squeeze));
    emit progressed();
    next();
}

} // namespace gripscope
