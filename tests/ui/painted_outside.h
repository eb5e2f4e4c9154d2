// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"

#include <QImage>
#include <QPainter>

namespace gripscope::test {

/// Pixels that a picture paints outside of its size, where no clip helps: SVG files have none.
[[nodiscard]] inline int paintedOutside(ExportablePlot& plot)
{
    constexpr int around = 60;
    const QSize size = plot.pictureSize();
    QImage image(size + QSize(2 * around, 2 * around), QImage::Format_RGB32);
    image.fill(Qt::magenta);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(around, around);
    plot.paintPicture(painter);
    painter.end();
    const QRect inside(QPoint(around, around), size);
    int pixels = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            pixels += !inside.contains(x, y) && image.pixelColor(x, y) != QColor(Qt::magenta) ? 1 : 0;
    return pixels;
}

} // namespace gripscope::test
