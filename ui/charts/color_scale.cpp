// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/color_scale.h"

#include "ui/theme/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

QColor scaleColor(double share)
{
    static constexpr std::array<QRgb, 10> colors{0xff00224e, 0xff123570, 0xff3b496c, 0xff575d6d, 0xff707173,
                                                 0xff8a8678, 0xffa59c74, 0xffc3b369, 0xffe1cc55, 0xfffee838};
    const double at = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * (colors.size() - 1);
    const auto below = std::min(std::size_t(at), colors.size() - 2);
    return Theme::mix(QColor(colors[below]), QColor(colors[below + 1]), at - double(below));
}

} // namespace gripscope
