// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/gaussian.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

/// A force that jumps now and then, so that a part slides, turns and sticks.
class JumpingForce {
public:
    explicit JumpingForce(double deviation) : m_deviation(deviation) {}
    [[nodiscard]] double next()
    {
        if (--m_left <= 0) {
            m_left = 5 + static_cast<int>(10 * std::abs(m_draw()));
            m_force = m_deviation * std::clamp(m_draw(), -largest, largest);
        }
        return m_force;
    }

private:
    static constexpr double largest = 1.5; ///< in deviations
    GaussianNoise m_draw{7};
    double m_deviation;
    double m_force = 0;
    int m_left = 0;
};

} // namespace gripscope
