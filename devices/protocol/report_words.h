// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report.h"

#include <QString>

#include <vector>

namespace gripscope::protocol {

/// A field of a report, as a person reads it.
struct FieldWords {
    QString name, value;
};

/// A report in words: what the inspector and the command line show.
struct ReportWords {
    QString kind;    ///< "Stream", "Upload", "unknown report 0x7f"
    QString problem; ///< empty: the report was understood
    std::vector<FieldWords> fields;
};

/// Input, output and feature reports alike, each by its report ID. Of a damaged one the kind, the problem and
/// no fields.
[[nodiscard]] ReportWords reportInWords(ReportView bytes);

/// "armed, moving"; "none" for 0; bits without a meaning as "bit 9".
[[nodiscard]] QString statusWords(std::uint16_t status);
/// The name in devices/PROTOCOL.md.
[[nodiscard]] QString reportName(std::uint8_t id);
/// "01 10 00 e8", 16 bytes a line.
[[nodiscard]] QString hexDump(ReportView bytes);

} // namespace gripscope::protocol
