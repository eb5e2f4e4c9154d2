// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace gripscope {

// Polynomials as coefficients of ascending powers, in extended precision: calibration points may lie far from
// zero and close together, and ten digits of what comes out must be right.

[[nodiscard]] long double polynomialValue(std::span<const long double> coefficients, long double x);
[[nodiscard]] std::vector<long double> polynomialDerivative(std::span<const long double> coefficients);

/// The real roots within [from, to], ascending: between two neighbouring roots of the derivative a polynomial
/// is monotonic, so that bisection finds the one root there may be. A root that only touches zero is found
/// where rounding lets it reach zero. The zero polynomial has none here.
[[nodiscard]] std::vector<long double> polynomialRoots(std::span<const long double> coefficients,
                                                       long double from, long double to);

} // namespace gripscope
