// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QPointF>
#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

namespace gripscope {

/// Values by part, by operator, by source of scatter: what stands along the horizontal axis has names, no
/// numbers.
struct CategoryChart {
    enum class Marks { Bars, Points, Lines }; ///< Lines: points that are joined
    struct Series {
        QString name;  ///< empty: not in the legend
        int place = 0; ///< of its colour and shape, Theme::typeColor()
        Marks marks = Marks::Points;
        std::vector<QPointF> points; ///< x: place of the category, from 0, with a shift to keep points apart
    };
    struct Level {
        double value = 0;
        QString name;
        bool limit = false; ///< dashed, in the colour of what is not valid; else a centre line
    };
    struct Group {
        QString name;
        int categories = 0; ///< so many of the next ones
    };
    QString title;      ///< with its unit: "Stiffness k by part (kN/m)"
    QString fileName;   ///< "study_parts"
    QString empty = {}; ///< what is said where there is nothing to draw
    QStringList categories;
    QString categoryTitle = {};
    std::vector<Group> groups = {};
    std::vector<Series> series;
    std::vector<Level> levels = {};
    bool fromZero = false;
    std::optional<double> top = {}; ///< of the axis, where it is known beforehand
};

/// Paints it into `area` (logical pixels) in these colours; nothing outside. On any thread.
void paintCategoryChart(QPainter& painter, const QRectF& area, const CategoryChart& chart,
                        const ThemeTokens& tokens);

/// The chart on the screen, in the colours of the theme.
class CategoryPlot : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit CategoryPlot(QWidget* parent = nullptr);
    void setChart(CategoryChart chart);
    [[nodiscard]] const CategoryChart& chart() const { return m_chart; }

    [[nodiscard]] QString plotName() const override { return m_chart.title; }
    [[nodiscard]] QString fileName() const override { return m_chart.fileName; }
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row a point: series, category, value.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {420, 240}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CategoryChart m_chart;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

} // namespace gripscope
