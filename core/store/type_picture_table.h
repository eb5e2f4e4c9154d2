// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/statement.h"

namespace gripscope::type_picture_table {

/// In force from now on; an empty `pictureId`: none.
[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& typeId,
                                    const QString& pictureId, const QString& operatorName);
/// The key of the type's picture; empty: it has none.
[[nodiscard]] Expected<QString> inForce(Database& database, const QString& typeId);

} // namespace gripscope::type_picture_table
