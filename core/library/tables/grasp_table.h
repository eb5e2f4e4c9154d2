// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"
#include "core/library/sql/statement.h"
#include "core/recognition/types/type_model.h"

namespace gripscope::grasp_table {

/// Joins to squeezes `g` where they belong now (`p`) and what that type is called (`s`); none for
/// inspections.
[[nodiscard]] QString typeJoins();
/// The squeeze's own row, without recording and estimates. `version`: of the library, with which it came.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const NewGrasp& grasp,
                                    qint64 version);
[[nodiscard]] Expected<std::vector<GraspRecord>> ofType(Database& database, const QString& typeId);
[[nodiscard]] Expected<std::optional<GraspRecord>> find(Database& database, const QString& id);
enum class Of { TypesInUse, ApprovedTypes };
/// The accepted squeezes of such types that have parameters, as typeSqueeze() has them, by type and time.
[[nodiscard]] Expected<std::vector<TypeSqueeze>> enrolled(Database& database, Of which);

} // namespace gripscope::grasp_table
