// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/smooth_force.h"

#include <cstddef>

namespace gripscope {

namespace {

/// (M[n-1] + 4 M[n] + M[n+1]) / 6 = u[n-1] - 2 u[n] + u[n+1], M = 0 at both ends; Thomas' algorithm.
std::vector<double> splineCurvature(const std::vector<double>& u)
{
    const std::size_t count = u.size();
    std::vector<double> m(count, 0.0);
    if (count < 3)
        return m;
    std::vector<double> ratio(count, 0.0);
    for (std::size_t n = 1; n + 1 < count; ++n) {
        const double pivot = 4 - ratio[n - 1];
        ratio[n] = 1 / pivot;
        const double bend = (u[n - 1] - u[n]) + (u[n + 1] - u[n]);
        m[n] = (6 * bend - m[n - 1]) / pivot;
    }
    for (std::size_t n = count - 1; n-- > 1;)
        m[n] -= ratio[n] * m[n + 1];
    return m;
}

} // namespace

std::vector<double> straightAsSpline(const std::vector<double>& force)
{
    std::vector<double> out = splineCurvature(force);
    for (std::size_t n = 0; n < out.size(); ++n)
        out[n] = force[n] - out[n] / 12;
    return out;
}

} // namespace gripscope
