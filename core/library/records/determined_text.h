// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"

#include <QString>

#include <optional>

namespace gripscope {

/// DeterminedQuantities as they are stored: "m+b+k+Fc", their logarithms, and the upper triangle of the
/// covariance row by row, empty where it is not known; numbers shortest round-trip, a blank between them.
struct DeterminedText {
    QString quantities, logarithms, covariance;
};

/// Nothing where a number is not finite, or there are not as many as there are quantities.
[[nodiscard]] std::optional<DeterminedText> determinedText(const DeterminedQuantities& determined);
/// Nothing where it is none that determinedText() wrote.
[[nodiscard]] std::optional<DeterminedQuantities> determinedQuantities(const DeterminedText& text);

} // namespace gripscope
