// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QWidget>

#include <vector>

namespace gripscope {

/// Values with intervals, a row for each thing and a panel for each quantity, against zero: who has moved by
/// how much, at one look.
struct IntervalChart {
    struct Item {
        double value = 0, low = 0, high = 0;
    };
    struct Row {
        QString name;
        int place = 0;           ///< of its colour and shape, Theme::typeColor()
        bool strong = false;     ///< what holds for all: bold, in the colour of the text
        std::vector<Item> items; ///< one a panel; fewer: none there
    };
    struct Panel {
        QString title; ///< "Stiffness k (%)"
    };
    QString title, fileName;
    QString empty = {}; ///< what is said where there is nothing to draw
    std::vector<Panel> panels;
    std::vector<Row> rows;
};

/// Paints it into `area` (logical pixels) in these colours; nothing outside. On any thread.
void paintIntervalChart(QPainter& painter, const QRectF& area, const IntervalChart& chart,
                        const ThemeTokens& tokens);

/// The chart on the screen, as high as its rows need.
class IntervalPlot : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit IntervalPlot(QWidget* parent = nullptr);
    void setChart(IntervalChart chart);
    [[nodiscard]] const IntervalChart& chart() const { return m_chart; }

    [[nodiscard]] QString plotName() const override { return m_chart.title; }
    [[nodiscard]] QString fileName() const override { return m_chart.fileName; }
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row an item: panel, row, value, low, high.
    [[nodiscard]] PlotTable numbers() const override;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    IntervalChart m_chart;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

} // namespace gripscope
