// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gauss_legendre.h"

#include <boost/math/special_functions/legendre.hpp>

#include <vector>

namespace gripscope {

QuadratureRule QuadratureRule::between(double low, double high) const
{
    const double half = (high - low) / 2;
    return {((places.array() * half) + (low + high) / 2).matrix(), weights * half};
}

QuadratureRule gaussLegendre(int points)
{
    const std::vector<double> zeros = boost::math::legendre_p_zeros<double>(points); // those from 0 on
    QuadratureRule rule{Eigen::VectorXd(points), Eigen::VectorXd(points)};
    const int half = points / 2;
    for (int i = 0; i < half; ++i) {
        const double zero = zeros[std::size_t(i)];
        const double slope = boost::math::legendre_p_prime(points, zero);
        const double weight = 2 / ((1 - zero * zero) * slope * slope);
        rule.places(half + i) = zero;
        rule.places(half - 1 - i) = -zero;
        rule.weights(half + i) = rule.weights(half - 1 - i) = weight;
    }
    return rule;
}

} // namespace gripscope
