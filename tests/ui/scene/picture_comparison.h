// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <algorithm>
#include <cstdlib>

namespace gripscope::test {

/// Share of the cells of 8 x 8 pixels whose mean colour differs by more than a person overlooks. Text that
/// reads another number or noise that runs another way stays within a few cells; what moved, went or changed
/// its colour does not. 1 where the sizes differ.
[[nodiscard]] inline double differingShare(const QImage& one, const QImage& other)
{
    constexpr int cell = 8;
    constexpr int overlooked = 20; // of 255
    if (one.isNull() || one.size() != other.size())
        return 1;
    const auto cells = [](const QImage& picture) {
        return picture.convertToFormat(QImage::Format_RGB32)
            .scaled(picture.size() / cell, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage a = cells(one);
    const QImage b = cells(other);
    int differing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                       std::abs(qBlue(p) - qBlue(q))});
            differing += most > overlooked ? 1 : 0;
        }
    return static_cast<double>(differing) / (a.width() * a.height());
}

} // namespace gripscope::test
