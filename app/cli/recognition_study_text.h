// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/recognition_study.h"

#include <QString>

namespace gripscope::cli {

/// The study's rows for a person: what was counted, and the limits.
[[nodiscard]] QString recognitionText(const RecognitionStudy& study);

} // namespace gripscope::cli
