// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/document_table.h"
#include "core/store/estimate_table.h"
#include "core/store/grasp_writer.h"
#include "core/store/history_view.h"
#include "core/store/library_private.h"
#include "core/store/recording_table.h"
#include "core/store/reidentification_table.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<HistoryKeys> Library::historyKeys(const HistoryQuery& query) const
{
    return history_view::keys(*d->database, query);
}

Expected<std::vector<HistoryEntry>> Library::historyEntries(const std::vector<QString>& graspIds) const
{
    return history_view::entries(*d->database, graspIds);
}

Expected<HistoryCounts> Library::historyCounts(const HistoryQuery& query) const
{
    return history_view::counts(*d->database, query);
}

Expected<HistoryPoints> Library::historyPoints(const HistoryQuery& query) const
{
    return history_view::points(*d->database, query);
}

Expected<HistoryChoices> Library::historyChoices() const
{
    return history_view::choices(*d->database);
}

Expected<SqueezeDetails> Library::squeezeDetails(const QString& graspId) const
{
    auto entries = history_view::entries(*d->database, {graspId});
    if (!entries)
        return tl::unexpected(entries.error());
    if (entries->empty())
        return failure(ErrorCode::NotFound, {Words::tr("squeeze with the key %1").arg(graspId)});
    SqueezeDetails details;
    details.entry = std::move(entries->front());
    auto estimates = estimate_table::ofGrasp(*d->database, graspId);
    if (!estimates)
        return tl::unexpected(estimates.error());
    details.estimates = std::move(*estimates);
    auto document = document_table::read(*d->database, graspId);
    if (!document)
        return tl::unexpected(document.error());
    details.document = std::move(*document);
    const auto recording = recording_table::read(*d->database, graspId);
    if (recording) {
        details.provenance = recording->provenance;
        details.samples = recording->size();
        details.sampleTime_s = recording->sampleTime_s;
    } else if (recording.error().code != ErrorCode::NotFound) // a row of an imported table has none
        return tl::unexpected(recording.error());
    return details;
}

Expected<void> Library::addReidentification(const QString& graspId, const Estimate& estimate,
                                            const Reidentification& how)
{
    if (auto finite = requireFinite(estimate); !finite)
        return finite;
    return d->write<void>(Words::tr("store the estimate"), [&]() -> Expected<void> {
        if (const auto grasp = requireGrasp(*d->database, graspId); !grasp)
            return tl::unexpected(grasp.error());
        const auto rank = estimate_table::nextRank(*d->database, graspId);
        if (!rank)
            return tl::unexpected(rank.error());
        const RowStamp stamp = RowStamp::now();
        if (auto done = estimate_table::insert(*d->database, stamp, graspId, *rank, estimate); !done)
            return done;
        return reidentification_table::insert(*d->database, RowStamp::now(), graspId, stamp.id, how);
    });
}

} // namespace gripscope
