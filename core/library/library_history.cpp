// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/history/history_view.h"
#include "core/library/library_private.h"
#include "core/library/tables/document_table.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/grasp_writer.h"
#include "core/library/tables/recording_table.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<HistoryList> Library::historyList(const HistoryQuery& query) const
{
    return history_list::find(*d->database, query);
}

Expected<HistoryList> Library::historyStretch(HistoryList list) const
{
    RETURN_IF_ERROR(history_list::goOn(*d->database, list));
    return list;
}

Expected<std::vector<HistoryEntry>> Library::historyPage(const HistoryList& list, qint64 first,
                                                         qint64 count) const
{
    ASSIGN_OR_RETURN(const std::vector<QString> keys, history_list::keys(*d->database, list, first, count));
    return history_view::entries(*d->database, keys);
}

Expected<std::vector<QString>> Library::historyKeys(const HistoryList& list, qint64 first, qint64 count) const
{
    return history_list::keys(*d->database, list, first, count);
}

Expected<std::optional<qint64>> Library::historyRow(const HistoryList& list, const QString& graspId) const
{
    return history_list::rowOf(*d->database, list, graspId);
}

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
    ASSIGN_OR_RETURN(HistoryList list, history_list::find(*d->database, query));
    RETURN_IF_ERROR(history_list::goThrough(*d->database, list));
    return history_view::points(*d->database, list);
}

Expected<HistoryPoints> Library::historyPoints(const HistoryList& list) const
{
    return history_view::points(*d->database, list);
}

Expected<HistoryInForce> Library::historyInForce(const HistoryQuery& query) const
{
    return history_view::inForce(*d->database, query);
}

Expected<HistoryChoices> Library::historyChoices() const
{
    return history_view::choices(*d->database);
}

Expected<SqueezeDetails> Library::squeezeDetails(const QString& graspId) const
{
    ASSIGN_OR_RETURN(auto entries, history_view::entries(*d->database, {graspId}));
    if (entries.empty())
        return failure(ErrorCode::NotFound, {Words::tr("squeeze with the key %1").arg(graspId)});
    SqueezeDetails details;
    details.entry = std::move(entries.front());
    ASSIGN_OR_RETURN(auto estimates, estimate_table::ofGrasp(*d->database, graspId));
    details.estimates = std::move(estimates);
    ASSIGN_OR_RETURN(auto document, document_table::read(*d->database, graspId));
    details.document = std::move(document);
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
    RETURN_IF_ERROR(requireFinite(estimate));
    return d->write<void>(Words::tr("store the estimate"), [&]() -> Expected<void> {
        RETURN_IF_ERROR(requireGrasp(*d->database, graspId));
        ASSIGN_OR_RETURN(const auto rank, estimate_table::nextRank(*d->database, graspId));
        const RowStamp stamp = RowStamp::now();
        RETURN_IF_ERROR(estimate_table::insert(*d->database, stamp, graspId, rank, estimate,
                                               estimate_table::programOf({})));
        return reidentification_table::insert(*d->database, RowStamp::now(), graspId, stamp.id, how);
    });
}

} // namespace gripscope
