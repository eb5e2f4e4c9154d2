// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/signal/recording/recording.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace gripscope {

/// How a table that another program wrote holds its numbers.
struct CsvFormat {
    char delimiter = 0;   ///< ',', ';' or a tab; 0: the one by which the columns are found in the header
    char decimalMark = 0; ///< '.' or ','; 0: the one that the first number with either has
    std::size_t skippedLines = 0; ///< of the file, in front of the header
    bool header = true;           ///< without one the columns are called 1, 2, 3...
    std::size_t linesBelow = 0;   ///< that are not blank, between the header and the rows: units
    friend bool operator==(const CsvFormat&, const CsvFormat&) = default;
};

/// Columns by their place, from 0, whatever they are called.
struct CsvColumns {
    std::size_t force = 0, position = 0;
    std::optional<std::size_t> time; ///< without one the sample time has to be given
    friend bool operator==(const CsvColumns&, const CsvColumns&) = default;
};

/// How to read a CSV that is not Gripscope's own: which columns and which sample time.
struct CsvReadOptions {
    QString forceColumn;    ///< empty: "force"
    QString positionColumn; ///< empty: "position"
    std::optional<double>
        sampleTime_s;              ///< overrides the file's; needed when the file has neither it nor time_s
    QString forceUnit;             ///< empty: the file's, else "1"
    QString positionUnit;          ///< empty: the file's, else "1"
    QString timeColumn;            ///< empty: "time_s", where there is one
    double timeUnit_s = 1;         ///< seconds in one unit of the column of times
    std::optional<ForceHold> hold; ///< overrides the file's
    CsvFormat format;
    std::optional<CsvColumns> columns; ///< in place of names; then no other column is read
    friend bool operator==(const CsvReadOptions&, const CsvReadOptions&) = default;
};

/// No unit of time has fewer or more seconds.
inline constexpr double shortestTimeUnit_s = 1e-9;
inline constexpr double longestTimeUnit_s = 3600;

/// Reads a recording (`# key: value` comments, a header, rows; UTF-8, C locale, LF or CR LF). Tables with
/// semicolons or tabs are read too, with decimal commas where their numbers have some.
/// Every number must be finite and every row whole. Errors are BadInput with the place FILE:LINE:COLUMN
/// (column counted in fields from 1), or FileUnreadable.
[[nodiscard]] Expected<Recording> readRecordingCsv(const QString& file, const CsvReadOptions& options = {});
/// The same from bytes in memory; `name` stands for the file in messages.
[[nodiscard]] Expected<Recording> parseRecordingCsv(const QByteArray& text, const QString& name,
                                                    const CsvReadOptions& options = {});

/// Writes Gripscope's own form, a lag of zero only where it is known; numbers in their shortest form that
/// reads back to the same bits.
[[nodiscard]] QByteArray toCsv(const Recording& recording);
/// Writes toCsv() to `file` through a temporary one, so that a crash leaves the old file or the new one.
[[nodiscard]] Expected<void> writeRecordingCsv(const Recording& recording, const QString& file);

} // namespace gripscope
