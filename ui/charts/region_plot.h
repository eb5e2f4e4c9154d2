// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/plot_export.h"
#include "ui/models/estimate_region.h"

#include <QWidget>

namespace gripscope {

/// The joint confidence region of m, b and k as three shadows in a triangle (m-b; m-k and b-k below), with
/// the other estimators' answers as points, and what means what in the corner that is left. Who lies outside
/// of a frame is shown by an arrow at its border with how far off he is.
class RegionPlot : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit RegionPlot(QWidget* parent = nullptr);

    void setRegion(const std::optional<EstimateRegion>& region);
    [[nodiscard]] const std::optional<EstimateRegion>& region() const { return m_region; }
    /// Half the width of a frame along a parameter, percent.
    [[nodiscard]] double halfRange(int parameter) const { return m_half[std::size_t(parameter)]; }
    /// Whether the answer of `point` lies in all three frames.
    [[nodiscard]] bool within(const EstimateRegion::Point& point) const;

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override;
    void paintPicture(QPainter& painter) override;
    /// The three outlines in percent, then the estimators' points.
    [[nodiscard]] PlotTable numbers() const override;

    QSize sizeHint() const override { return {372, 340}; }
    QSize minimumSizeHint() const override { return {300, 216}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Frame {
        int horizontal = 0, vertical = 0; ///< parameters: 0 m, 1 b, 2 k
        QRectF area;
        bool ticksBelow = false, ticksLeft = false;
    };
    [[nodiscard]] QPointF place(const Frame& frame, QPointF percent) const;
    [[nodiscard]] QString describe() const;
    void paint(QPainter& painter, QSizeF size) const;
    void paintFrame(QPainter& painter, const Frame& frame) const;
    void paintAxes(QPainter& painter, const Frame& frame) const;
    void paintOthers(QPainter& painter, const Frame& frame) const;
    void paintOutside(QPainter& painter, const Frame& frame, const EstimateRegion::Point& point,
                      std::vector<QRectF>& taken) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;

    std::optional<EstimateRegion> m_region;
    std::array<double, 3> m_half{1, 1, 1};
};

} // namespace gripscope
