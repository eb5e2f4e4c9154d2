// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/library/records/squeeze_record.h"
#include "core/library/sql/statement.h"

namespace gripscope::estimate_table {

/// The next three columns as m, b and k; nothing unless all are there.
[[nodiscard]] std::optional<MassDampingStiffness> takeParameters(Statement& row);
/// The next three columns, variances, as standard errors.
[[nodiscard]] std::optional<Eigen::Vector3d> takeStandardErrors(Statement& row);

/// The version that worked out what comes with a squeeze: this one, where it does not say.
[[nodiscard]] QString programOf(const NewGrasp& grasp);
/// `rank` 0: the recommended one. `program`: the version that found it.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    int rank, const Estimate& estimate, const QString& program);
/// The rank of one that comes later: never 0.
[[nodiscard]] Expected<int> nextRank(Database& database, const QString& graspId);
/// By rank.
[[nodiscard]] Expected<std::vector<StoredEstimate>> ofGrasp(Database& database, const QString& graspId);

} // namespace gripscope::estimate_table

namespace gripscope::reidentification_table {

/// Who found the estimate `estimateId` of a stored squeeze later on, and how.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const QString& estimateId, const Reidentification& how);

} // namespace gripscope::reidentification_table
