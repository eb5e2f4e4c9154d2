// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/recognition_study.h"

#include <QJsonObject>

namespace gripscope {

/// The document of `gripscope-cli study recognition --json`.
[[nodiscard]] QJsonObject toJson(const RecognitionStudy& study, const RecognitionStudyOptions& options);

} // namespace gripscope
