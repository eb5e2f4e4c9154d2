// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_lines.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <string_view>
#include <vector>

namespace gripscope {

/// `a` - `b` of two numbers as they are written, rounded once, at the end: 1000000000000.4 and
/// 1000000000000.3 differ by 0.1, where doubles of them differ by 0.0999. Nothing where either has an
/// exponent, a sign and no digits, or more than 18 digits with the other's decimals: what doubles say is then
/// as good as anything.
[[nodiscard]] std::optional<double> decimalDifference(std::string_view a, std::string_view b);

/// A column of names as places in a list of them.
struct StudyLabels {
    QStringList names;      ///< each once, in the order of their first row
    std::vector<int> index; ///< into names, one a row; -1: an empty cell, where those are allowed
};

/// A column of numbers about its first.
struct OffsetColumn {
    double origin = 0;
    std::vector<double> offsets; ///< one a row, the first 0
};

/// The measurements of a quality study: one a row, columns by name, from a CSV or from a library.
class StudyTable {
public:
    /// Errors: BadInput with FILE:LINE:COLUMN, for rows of another length than the header too.
    [[nodiscard]] static Expected<StudyTable> parse(const QByteArray& text, const QString& name);
    /// Besides: FileUnreadable.
    [[nodiscard]] static Expected<StudyTable> read(const QString& file);
    /// Of rows that are as long as `columns`. `name`: what errors call it.
    [[nodiscard]] static StudyTable of(const QString& name, const QStringList& columns,
                                       const std::vector<QStringList>& rows);

    [[nodiscard]] std::size_t rows() const { return m_lines.size() - 1; }
    [[nodiscard]] QStringList columns() const { return m_lines.front().fields; }

    enum class EmptyCells { Refused, Missing };
    /// BadInput for a column that is not there or there twice, for a table without rows, and for a cell that
    /// is empty where those are refused.
    [[nodiscard]] Expected<StudyLabels> labels(const QString& column,
                                               EmptyCells empty = EmptyCells::Refused) const;
    /// BadInput for a cell that is no finite number too.
    [[nodiscard]] Expected<std::vector<double>> numbers(const QString& column) const;
    /// The same, subtracted as they are written (decimalDifference()): leading digits that all share cost
    /// nothing.
    [[nodiscard]] Expected<OffsetColumn> offsets(const QString& column) const;

private:
    [[nodiscard]] Expected<qsizetype> place(const QString& column) const;

    QString m_name;
    std::vector<TableLine> m_lines; ///< the header, then the rows
};

} // namespace gripscope
