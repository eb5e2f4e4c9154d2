// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_report.h"

#include <QByteArray>

namespace gripscope {

/// A result as the manual's JSON schema has it, in one line.
[[nodiscard]] QByteArray reportJson(const LineReport& report, bool historical);
/// What reportJson() made. StorageCorrupt for anything else.
[[nodiscard]] Expected<LineReport> reportFromJson(const QByteArray& bytes);

} // namespace gripscope
