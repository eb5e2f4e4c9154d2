// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"

#include <QJsonObject>

namespace gripscope::document_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                                    const QJsonObject& document);
/// Empty when the squeeze has none.
[[nodiscard]] Expected<QJsonObject> read(Database& database, const QString& graspId);

} // namespace gripscope::document_table
