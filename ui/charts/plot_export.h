// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>
#include <QString>

#include <memory>
#include <vector>

class QPainter;

namespace gripscope {

/// The numbers behind a plot, a column each; shared, so that a million of them can be handed to the pool.
struct PlotColumn {
    QString name; ///< with its unit: "Measured position (mm)"
    std::shared_ptr<const std::vector<double>> values;
};
using PlotTable = std::vector<PlotColumn>;

/// Comma-separated (RFC 4180, LF, C locale), a header line, every number with the digits that bring it back
/// exactly. Columns may end early; what is missing or not finite is an empty field.
[[nodiscard]] QByteArray toCsv(const PlotTable& table);

/// A plot that can leave the screen: as a picture of what is in view, and as all of its numbers.
class ExportablePlot {
public:
    virtual ~ExportablePlot() = default;
    /// What to call it in a menu: "Residuals".
    [[nodiscard]] virtual QString plotName() const = 0;
    /// What to call its files, without ending: "residuals".
    [[nodiscard]] virtual QString fileName() const = 0;
    [[nodiscard]] virtual QSize pictureSize() const = 0;
    /// Paints nothing outside of pictureSize(), also without the help of a clip: SVG files have none.
    virtual void paintPicture(QPainter& painter) = 0;
    [[nodiscard]] virtual PlotTable numbers() const = 0;

protected:
    ExportablePlot() = default;
    ExportablePlot(const ExportablePlot&) = default;
    ExportablePlot& operator=(const ExportablePlot&) = default;
};

/// The picture with `scale` pixels for each of the screen's logical ones.
[[nodiscard]] QImage toImage(ExportablePlot& plot, double scale = 2);
[[nodiscard]] QByteArray toPng(const QImage& image);
[[nodiscard]] QByteArray toSvg(ExportablePlot& plot);

} // namespace gripscope
