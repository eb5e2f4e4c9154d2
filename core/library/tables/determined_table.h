// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"
#include "core/recognition/types/type_model.h"

namespace gripscope::determined_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const DeterminedQuantities& determined);

/// What take() takes, of a table that is called d.
inline const QString columns = QStringLiteral("d.quantities, d.logarithms, d.covariance ");
/// The next three columns. Nothing where there is no row, or where it is none that insert() wrote.
[[nodiscard]] std::optional<DeterminedQuantities> take(Statement& row);

} // namespace gripscope::determined_table
