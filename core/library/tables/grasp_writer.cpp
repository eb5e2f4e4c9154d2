// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/grasp_writer.h"

#include "core/base/words.h"
#include "core/library/tables/determined_table.h"
#include "core/library/tables/document_table.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/recording_table.h"
#include "core/library/tables/type_writer.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Expected<void> checkGrasp(Database& database, const NewGrasp& grasp)
{
    for (const Estimate& estimate : grasp.estimates)
        RETURN_IF_ERROR(requireFinite(estimate));
    if (grasp.typeId.isEmpty())
        return {};
    if (grasp.estimates.empty())
        return failure(ErrorCode::Usage, {Words::tr("A squeeze of a type needs an estimate.")});
    ASSIGN_OR_RETURN(const auto type, requireTypeInUse(database, grasp.typeId));
    return requireComparableUnits(grasp.forceUnit, grasp.positionUnit, type.forceUnit, type.positionUnit);
}

} // namespace

Expected<void> requireFinite(const Estimate& estimate)
{
    if ((estimate.parameters && !estimate.parameters->vector().allFinite()) ||
        (estimate.covariance && !estimate.covariance->allFinite()))
        return failure(ErrorCode::Usage, {Words::tr("An estimate holds a number that is not finite.")});
    return {};
}

Expected<QString> storeGrasp(Database& database, const NewGrasp& grasp, qint64 version)
{
    RowStamp stamp = RowStamp::now();
    if (grasp.recorded.isValid())
        stamp.utc = utcText(grasp.recorded);
    auto done = checkGrasp(database, grasp);
    if (done)
        done = grasp_table::insert(database, stamp, grasp, version);
    if (done && grasp.recording)
        done = recording_table::insert(database, RowStamp::now(), stamp.id, *grasp.recording,
                                       grasp.draftSqueezeId);
    for (std::size_t rank = 0; done && rank < grasp.estimates.size(); ++rank)
        done = estimate_table::insert(database, RowStamp::now(), stamp.id, int(rank), grasp.estimates[rank],
                                      estimate_table::programOf(grasp));
    if (done && grasp.determined)
        done = determined_table::insert(database, RowStamp::now(), stamp.id, *grasp.determined);
    if (done && !grasp.identification.isEmpty())
        done = document_table::insert(database, RowStamp::now(), stamp.id, grasp.identification);
    if (!done)
        return tl::unexpected(done.error());
    return stamp.id;
}

Expected<GraspRecord> requireGrasp(Database& database, const QString& id)
{
    ASSIGN_OR_RETURN(const auto grasp, grasp_table::find(database, id));
    if (!grasp)
        return failure(ErrorCode::NotFound, {Words::tr("squeeze with the key %1").arg(id)});
    return *grasp;
}

} // namespace gripscope
