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
    std::shared_ptr<const std::vector<QString>> texts = {}; ///< in place of numbers: the name of a type
    [[nodiscard]] std::size_t rows() const { return texts ? texts->size() : values ? values->size() : 0; }
};
using PlotTable = std::vector<PlotColumn>;

/// Comma-separated (RFC 4180, LF, C locale), a header line, every number with the digits that bring it back
/// exactly, a text as csvCell() has it. Columns may end early; what is missing or not finite is an empty
/// field.
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
    /// From now on pictures are laid out anew for this size; one that is not valid: as on the screen.
    virtual void setPictureSize(QSize size) = 0;
    /// Paints nothing outside of pictureSize(), also without the help of a clip: SVG files have none.
    virtual void paintPicture(QPainter& painter) = 0;
    [[nodiscard]] virtual PlotTable numbers() const = 0;

protected:
    ExportablePlot() = default;
    ExportablePlot(const ExportablePlot&) = default;
    ExportablePlot& operator=(const ExportablePlot&) = default;
};

/// How wide a picture is: as on the screen, or a figure of one or two columns of a journal (85 and 175 mm),
/// laid out for it, with letters of 9 points.
enum class FigureWidth { Screen, OneColumn, TwoColumns };
/// In logical pixels of 1/96 inch; not valid for the screen.
[[nodiscard]] QSize figureSize(FigureWidth width);
/// Pixels of an image for each of those: twice the screen's, or 600 dpi in print.
[[nodiscard]] double figureScale(FigureWidth width);

/// Gives a plot's pictures a size for a while.
class FigureLayout {
public:
    FigureLayout(ExportablePlot& plot, FigureWidth width);
    ~FigureLayout();
    FigureLayout(const FigureLayout&) = delete;
    FigureLayout& operator=(const FigureLayout&) = delete;

private:
    ExportablePlot* m_plot;
    bool m_changed;
};

/// The picture with `scale` pixels for each of the screen's logical ones.
[[nodiscard]] QImage toImage(ExportablePlot& plot, double scale = 2);
[[nodiscard]] QByteArray toPng(const QImage& image);
[[nodiscard]] QByteArray toSvg(ExportablePlot& plot);

} // namespace gripscope
