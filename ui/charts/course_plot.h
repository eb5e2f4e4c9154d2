// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

namespace gripscope {

/// Squeeze after squeeze how far each lies from its type's enrolment, and since when it lies elsewhere.
struct CourseChart {
    struct Point {
        double value = 0;
        int place = 0; ///< of its type, Theme::typeColor()
    };
    /// Behind the first `before` points; `earliest` to `latest` are shaded.
    struct Change {
        int before = 0, earliest = 0, latest = 0;
        double value = 0, low = 0, high = 0; ///< where they lie behind it
        QString name;                        ///< "since 1204"
    };
    QString title, fileName, axisTitle;
    QString empty = {};
    std::vector<Point> points;
    QStringList names; ///< of the points, below the axis: inspection numbers
    struct Legend {
        QString name;
        int place = 0;
    };
    std::vector<Legend> legend;
    std::optional<Change> change;
};

/// Paints it into `area` (logical pixels) in these colours; nothing outside. On any thread.
void paintCourseChart(QPainter& painter, const QRectF& area, const CourseChart& chart,
                      const ThemeTokens& tokens);

/// The chart on the screen.
class CoursePlot : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit CoursePlot(QWidget* parent = nullptr);
    void setChart(CourseChart chart);
    [[nodiscard]] const CourseChart& chart() const { return m_chart; }

    [[nodiscard]] QString plotName() const override { return m_chart.title; }
    [[nodiscard]] QString fileName() const override { return m_chart.fileName; }
    [[nodiscard]] QSize pictureSize() const override;
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row a point: name, type, value.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {560, 260}; }
    QSize minimumSizeHint() const override { return {280, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CourseChart m_chart;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

} // namespace gripscope
