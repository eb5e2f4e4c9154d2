// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/table_rows.h"

namespace gripscope {

inline constexpr qsizetype digestSize = 32;

/// SHA-256.
[[nodiscard]] QByteArray digestOf(QByteArrayView bytes);

/// The digest of a row, over its columns in the order of their names: name and value, each with its length
/// before it. A value is a letter for what it is and its bytes: 'i' a 64-bit integer, 'd' the IEEE bits of a
/// number (zero has no sign), 't' text in UTF-8, 'b' bytes as they are, 'n' nothing.
/// A column that holds its default is left out, so that one that a later schema adds changes no digest.
/// `columns` and `row` in the order of columnsOf().
[[nodiscard]] QByteArray rowDigest(const std::vector<Column>& columns, const TableRows::Row& row);

} // namespace gripscope
