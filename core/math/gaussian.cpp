// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"

#include <cmath>

namespace gripscope {

double GaussianNoise::uniform()
{
    return static_cast<double>(m_engine() >> 11) * 0x1p-53;
}

double GaussianNoise::operator()()
{
    if (m_spare) {
        const double value = *m_spare;
        m_spare.reset();
        return value;
    }
    double x = 0;
    double y = 0;
    double square = 0;
    do {
        x = 2 * uniform() - 1;
        y = 2 * uniform() - 1;
        square = x * x + y * y;
    } while (square >= 1 || square == 0);
    const double scale = std::sqrt(-2 * std::log(square) / square);
    m_spare = y * scale;
    return x * scale;
}

} // namespace gripscope
