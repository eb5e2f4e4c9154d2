// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// int f dx from `low` to `high` = sum weights_i f(places_i), exact for polynomials up to degree 2n - 1.
struct QuadratureRule {
    Eigen::VectorXd places, weights;
    [[nodiscard]] QuadratureRule between(double low, double high) const;
};

/// Gauss and Legendre's rule between -1 and 1 with `points` places, even and at least 2: the zeros of P_n,
/// weights 2/((1 - x^2) P_n'(x)^2).
[[nodiscard]] QuadratureRule gaussLegendre(int points);

} // namespace gripscope
