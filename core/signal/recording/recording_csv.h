// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/signal/recording/recording.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace gripscope {

/// How to read a CSV that is not Gripscope's own: which columns and which sample time.
struct CsvReadOptions {
    QString forceColumn;    ///< empty: "force"
    QString positionColumn; ///< empty: "position"
    std::optional<double>
        sampleTime_s;     ///< overrides the file's; needed when the file has neither it nor time_s
    QString forceUnit;    ///< empty: the file's, else "1"
    QString positionUnit; ///< empty: the file's, else "1"
};

/// Provenance of a recording whose file names a `force_lag_s` of zero: known to be none, where a file that
/// does not name it knows nothing.
[[nodiscard]] inline QString forceLagSourceKey()
{
    return QStringLiteral("force_lag_source");
}

/// Reads a recording (`# key: value` comments, a header, rows; UTF-8, C locale, LF or CR LF).
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
