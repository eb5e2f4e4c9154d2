// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"

#include <QChartView>
#include <QColor>
#include <QFontMetricsF>
#include <QString>

#include <optional>
#include <vector>

class QAbstractSeries;
class QValueAxis;

namespace gripscope {

/// A range of numbers along an axis.
struct PlotRange {
    double low = 0, high = 1;
    [[nodiscard]] double span() const { return high - low; }
    friend bool operator==(const PlotRange&, const PlotRange&) = default;
};

/// The frame that all plots of a page share, so that they stand exactly below each other: a line with the
/// title and the names of the curves above, round ticks, the same left edge; a band drawn behind the curves.
/// Drag a rectangle to zoom, double click (or Home) to see everything again, + and - zoom along time, arrows
/// move.
class PlotFrame : public QChartView, public ExportablePlot {
    Q_OBJECT
public:
    explicit PlotFrame(QWidget* parent = nullptr);

    /// "Position (mm)"; also the accessible name. `brief` stands in for it where there is no room.
    void setTitle(const QString& title, const QString& brief = {});
    [[nodiscard]] QString title() const { return m_title; }
    /// What was found, behind the title: "white, p = 0.31". A doubtful one stands out.
    void setFinding(const QString& finding, bool doubtful = false);
    [[nodiscard]] QString finding() const { return m_finding; }
    [[nodiscard]] bool findingDoubtful() const { return m_findingDoubtful; }
    /// What to call the plot in a menu, and its files. A picture stands alone: where a plot below shows the
    /// numbers of the horizontal axis on the screen, it gets its own under `axis`.
    void setExportNames(const QString& plot, const QString& file, const QString& axis = {});
    /// In front of the numbers of the horizontal axis, short; empty hides those too (a plot below shows
    /// them).
    void setHorizontalTitle(const QString& title);
    /// In place of the one that it has, on the screen or in pictures alone.
    void renameHorizontal(const QString& title);
    /// A tinted stripe between `low` and `high` with its name at the right end.
    void setBand(std::optional<PlotRange> band, const QString& name = {});
    /// The axis holds decimal logarithms, and shows the numbers that they are of.
    void setLogarithmic(Qt::Orientation axis);
    /// Ticks of the vertical axis are whole multiples of it: 45 for degrees.
    void setVerticalStep(double step);
    /// What is said in the middle when there is nothing to draw.
    void setEmptyText(const QString& text);

    [[nodiscard]] PlotRange horizontal() const;
    [[nodiscard]] PlotRange vertical() const;
    void setHorizontal(PlotRange range);
    void setVertical(PlotRange range);
    /// The range that Home and a double click go back to.
    void setWhole(PlotRange range);
    [[nodiscard]] PlotRange whole() const { return m_whole; }
    void showWhole();
    /// Pixel columns of the plot.
    [[nodiscard]] int columns() const;

    [[nodiscard]] QString plotName() const override { return m_plotName; }
    [[nodiscard]] QString fileName() const override { return m_fileName; }
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override;
    void paintPicture(QPainter& painter) override;

    QSize sizeHint() const override { return {600, 160}; }
    QSize minimumSizeHint() const override { return {160, 84}; }

signals:
    void horizontalChanged(gripscope::PlotRange range); ///< by a person
    void wholeAsked();

protected:
    struct LegendEntry {
        QString name; ///< "▲ up" for points
        QColor color;
        int width = 2; ///< of a line; 0: points
    };
    void setLegend(std::vector<LegendEntry> entries);
    [[nodiscard]] QValueAxis* horizontalAxis() const { return m_horizontal; }
    [[nodiscard]] QValueAxis* verticalAxis() const { return m_vertical; }
    /// From the axes' numbers to pixels.
    [[nodiscard]] QPointF pixelOf(QPointF point) const;
    /// The horizontal range or the width changed: draw the curves anew.
    virtual void refresh() {}
    virtual void themeChanged();
    [[nodiscard]] virtual bool empty() const = 0;
    void attach(QAbstractSeries* series);

    void resizeEvent(QResizeEvent* event) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    static constexpr int headerHeight = 26; ///< above the plot, logical pixels

    void layOut();
    [[nodiscard]] int verticalSteps() const;
    void setTicks(QValueAxis* axis, int most);
    [[nodiscard]] int horizontalSteps() const;
    [[nodiscard]] bool logarithmic(const QValueAxis* axis) const;
    void paintLogarithmicGrid(QPainter* painter) const;
    void paintLogarithmicNumbers(QPainter* painter) const;
    void paintHeader(QPainter* painter) const;
    /// Left of the axis' first number, and what of its title has room there: all, or the unit alone.
    [[nodiscard]] double titleRoom(const QFontMetricsF& letters) const;
    [[nodiscard]] QString horizontalTitleIn(double room, const QFontMetricsF& letters) const;
    [[nodiscard]] double paintTitle(QPainter* painter, const QRectF& line) const;
    void describe();
    void ask(PlotRange range);

    QValueAxis* m_horizontal = nullptr;
    QValueAxis* m_vertical = nullptr;
    QString m_title, m_briefTitle, m_finding, m_horizontalTitle, m_bandName, m_emptyText;
    QString m_plotName, m_fileName, m_pictureAxis;
    bool m_logarithmicHorizontal = false, m_logarithmicVertical = false;
    double m_verticalStep = 0; ///< above 0: of the ticks
    bool m_findingDoubtful = false;
    bool m_inPicture = false; ///< no focus frame then
    QSize m_pictureSize;      ///< valid: laid out for a picture of this size
    std::optional<PlotRange> m_band;
    std::vector<LegendEntry> m_legend;
    PlotRange m_whole;
};

} // namespace gripscope
