// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/gauge_study.h"

#include <QJsonObject>

#include <array>
#include <optional>

namespace gripscope {

/// How a study is to be evaluated and how long it holds, decided before it begins.
struct StudyOptions {
    /// Widths of the tolerance of m, b, k in the units of the measurements; none: not stated.
    std::array<std::optional<double>, 3> tolerances;
    double studyVariation = 6; ///< standard deviations
    bool pooling = true;
    int repeatAfterMonths = 12; ///< after it ends it is due again (study_due.h); 0: never
    friend bool operator==(const StudyOptions&, const StudyOptions&) = default;
};

/// As stored. What is not there, or makes no sense, is as above.
[[nodiscard]] QJsonObject toJson(const StudyOptions& options);
[[nodiscard]] StudyOptions studyOptionsFromJson(const QJsonObject& json);

} // namespace gripscope
