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
        rows = std::max(rows, column.rows());
    }
    csv += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (const PlotColumn& column : table) {
            if (&column != &table.front())
                csv += ',';
            if (row >= column.rows())
                continue;
            if (column.texts)
                csv += csvCell((*column.texts)[row]).toUtf8();
            else if (std::isfinite((*column.values)[row]))
                csv += QByteArray::number((*column.values)[row], 'g', QLocale::FloatingPointShortest);
        }
        csv += '\n';
    }
    return csv;
}

QSize figureSize(FigureWidth width)
{
    constexpr double pixelsInMillimetre = 96 / 25.4;
    const auto sized = [](double wide_mm, double high_mm) {
        return (QSizeF(wide_mm, high_mm) * pixelsInMillimetre).toSize();
    };
    switch (width) {
    case FigureWidth::OneColumn:
        return sized(85, 57);
    case FigureWidth::TwoColumns:
        return sized(175, 88);
    case FigureWidth::Screen:
        break;
    }
    return {};
}

double figureScale(FigureWidth width)
{
    return width == FigureWidth::Screen ? 2 : 600.0 / 96;
}

FigureLayout::FigureLayout(ExportablePlot& plot, FigureWidth width)
    : m_plot(&plot), m_changed(width != FigureWidth::Screen)
{
    if (m_changed)
        m_plot->setPictureSize(figureSize(width));
}

FigureLayout::~FigureLayout()
{
    if (m_changed)
        m_plot->setPictureSize({});
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
    painter.end();                                       // it would take letters for larger ones
    const int dotsInMetre = qRound(scale * 96 / 0.0254); // so that a document places it in its own size
    image.setDotsPerMeterX(dotsInMetre);
    image.setDotsPerMeterY(dotsInMetre);
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
