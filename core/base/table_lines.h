// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace gripscope {

/// A line of a table that holds fields.
struct TableLine {
    int number = 0; ///< in the file, from 1
    QStringList fields;
};

/// Where an error is: FILE:LINE:COLUMN, the column counted in fields from 1.
struct TablePlace {
    QString file;
    int line = 1;
    qsizetype column = 1;
    [[nodiscard]] QString text() const;
    /// BadInput.
    [[nodiscard]] tl::unexpected<Error> error(const Finding& found, const Finding& expected) const;
};

/// FileUnreadable.
[[nodiscard]] Expected<QByteArray> readTableFile(const QString& file);

/// The header and the rows of a CSV; empty lines and comments (#) are passed over. A field may stand in
/// double quotes, a quote inside it doubled (RFC 4180). BadInput for a quote that stays open and for a table
/// without a header.
[[nodiscard]] Expected<std::vector<TableLine>> splitTable(const QByteArray& text, const QString& name);

/// Columns of the header, the first of `lines`, in the order of `wanted`. BadInput for one that is not there
/// or there twice, and for a table without rows.
[[nodiscard]] Expected<std::vector<qsizetype>>
findTableColumns(const std::vector<TableLine>& lines, const QStringList& wanted, const QString& name);

} // namespace gripscope
