// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"
#include "core/library/sql/statement.h"

#include <QHash>

namespace gripscope::type_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& name);
/// The places (see TypeRecord) of all types there ever were, by their keys.
[[nodiscard]] Expected<QHash<QString, int>> places(Database& database);
/// Every type that is not gone, retired ones too, as it is now, by name.
[[nodiscard]] Expected<std::vector<TypeRecord>> all(Database& database);
[[nodiscard]] Expected<std::optional<TypeRecord>> findByName(Database& database, const QString& name);
[[nodiscard]] Expected<std::optional<TypeRecord>> findById(Database& database, const QString& id);

} // namespace gripscope::type_table

namespace gripscope::type_version_table {

/// Appends the next version of a type.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                                    const Recipe& recipe, const QString& forceUnit,
                                    const QString& positionUnit);
[[nodiscard]] Expected<int> newest(Database& database, const QString& typeId); ///< 0: none

} // namespace gripscope::type_version_table

namespace gripscope::type_picture_table {

/// In force from now on; an empty `pictureId`: none.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                                    const QString& pictureId, const QString& operatorName);
/// The key of the type's picture; empty: it has none.
[[nodiscard]] Expected<QString> inForce(Database& database, const QString& typeId);

} // namespace gripscope::type_picture_table
