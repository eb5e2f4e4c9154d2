// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace gripscope {

/// mean +- k s of a normal sample holds the share `content` of all with `confidence`.
struct ToleranceInterval {
    int count = 0; ///< of the sample, at least 2
    double content = 0.95, confidence = 0.95;
    [[nodiscard]] std::optional<Error> validate() const;
};

/// mean + k s: k = t(confidence; n - 1, z sqrt(n)) / sqrt(n), t the quantile of the noncentral t (Owen 1968).
[[nodiscard]] Expected<double> oneSidedToleranceFactor(const ToleranceInterval& interval);
/// mean +- k s, exact (Odeh and Owen 1980): the k with
///     confidence = integral of sqrt(n) phi(sqrt(n) x) P(chi^2 > (n - 1) r(x)^2 / k^2) dx,
///     Phi(x + r) - Phi(x - r) = content.
[[nodiscard]] Expected<double> twoSidedToleranceFactor(const ToleranceInterval& interval);

} // namespace gripscope
