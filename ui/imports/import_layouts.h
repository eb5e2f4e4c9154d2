// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/foreign_table.h"

#include <QByteArray>

#include <optional>

namespace gripscope {

/// What a person said of tables of other programs, by layoutKey(), as a document that Settings keeps: the
/// latest of them, so that it does not grow for ever.

/// `kept` with what was said of the layout of `table`, in place of what was said of it before.
[[nodiscard]] QByteArray withLayout(const QByteArray& kept, const ForeignTable& table,
                                    const CsvReadOptions& options);
/// What was said of the layout of `table`; nothing where nothing was, or where it makes no sense any more.
/// Lines around the header are as found in this table, unless a person had to correct them.
[[nodiscard]] std::optional<CsvReadOptions> layoutIn(const QByteArray& kept, const ForeignTable& table);

} // namespace gripscope
