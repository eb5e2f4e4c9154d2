// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording_csv.h"

#include <QStringList>

#include <vector>

namespace gripscope {

/// Tables of force and position that other programs wrote: what they look like, so that a person can say what
/// in them is what. What was said are CsvReadOptions, by which parseRecordingCsv() reads them.

/// Bytes from the beginning of a file by which its layout is told.
inline constexpr qint64 tableHeadBytes = 65'536;

/// What the beginning of a table shows.
struct ForeignTable {
    CsvFormat format;              ///< with a delimiter and a decimal mark
    QStringList columns;           ///< their names; 1, 2, 3... where there is no header
    QStringList units;             ///< of each: behind its name or below it; empty where none is known
    std::vector<QStringList> rows; ///< the first ones, as they stand
};

/// The text in UTF-8, whatever it is in: UTF-16 where it begins with its byte order mark, Latin-1 where it is
/// no UTF-8. O(N).
[[nodiscard]] QByteArray tableText(const QByteArray& bytes);

/// Looks at the beginning of a text in UTF-8: by which delimiter and decimal mark it holds most
/// numbers, where its rows begin, which line above them has the names. `given` is believed instead. BadInput
/// where there are no two columns of numbers.
[[nodiscard]] Expected<ForeignTable> examineTable(const QByteArray& head, const QString& name,
                                                  const std::optional<CsvFormat>& given = std::nullopt);

/// Which column is what, by units, names (English and German), times that increase; in what they are, as far
/// as it is known. A proposal: units that are not known stay empty, and the sample time is missing where
/// there is no column of times. The table has two columns at least.
[[nodiscard]] CsvReadOptions proposedReading(const ForeignTable& table);

/// Tells tables of one layout from others: the same delimiter and the same names (or as many, without names).
[[nodiscard]] QString layoutKey(const ForeignTable& table);

/// Seconds in one `unit` of time: s, ms, us (µs), ns.
[[nodiscard]] std::optional<double> secondsPer(const QString& unit);
/// Those of secondsPer(), one spelling each.
[[nodiscard]] QStringList timeUnits();

/// Reads a file as readRecordingCsv() does, in any encoding of tableText().
[[nodiscard]] Expected<Recording> readForeignTable(const QString& file, const CsvReadOptions& options);
/// The beginning of a file, in UTF-8, whole lines where they are short enough; FileUnreadable.
[[nodiscard]] Expected<QByteArray> readTableHead(const QString& file);

} // namespace gripscope
