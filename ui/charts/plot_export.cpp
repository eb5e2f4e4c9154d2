// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_export.h"

#include "core/base/csv.h"

#include <QBuffer>
#include <QLocale>
#include <QPainter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

QByteArray toCsv(const PlotTable& table)
{
    QByteArray csv;
    std::size_t rows = 0;
    for (const PlotColumn& column : table) {
        if (&column != &table.front())
            csv += ',';
        csv += csvCell(column.name).toUtf8();
        rows = std::max(rows, column.values ? column.values->size() : 0);
    }
    csv += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (const PlotColumn& column : table) {
            if (&column != &table.front())
                csv += ',';
            if (column.values && row < column.values->size() && std::isfinite((*column.values)[row]))
                csv += QByteArray::number((*column.values)[row], 'g', QLocale::FloatingPointShortest);
        }
        csv += '\n';
    }
    return csv;
}

QImage toImage(ExportablePlot& plot, double scale)
{
    const QSize size = plot.pictureSize();
    QImage image((QSizeF(size) * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    plot.paintPicture(painter);
    return image;
}

QByteArray toPng(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray toSvg(ExportablePlot& plot)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plot.pictureSize());
    generator.setViewBox(QRect(QPoint(), plot.pictureSize()));
    generator.setTitle(plot.plotName());
    // One logical pixel of the screen is one unit of the file.
    generator.setResolution(96);
    QPainter painter(&generator);
    plot.paintPicture(painter);
    painter.end();
    return bytes;
}

} // namespace gripscope
