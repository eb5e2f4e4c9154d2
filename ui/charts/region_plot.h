// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "ui/charts/plot_export.h"

#include <QList>
#include <QPointF>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

namespace gripscope {

/// The joint 95 % confidence region of (m, b, k) of one estimate,
///     (theta - estimate)' C^-1 (theta - estimate) <= 3 F(95 %; 3, degrees of freedom),
/// and where the other estimators' answers lie, all in percent of the estimate (Seber and Wild 1989, section
/// 5.1). What is drawn is its shadow on a plane of two parameters: the pair (i, j) of C with the same right
/// side, larger than the joint region of that pair alone.
struct EstimateRegion {
    struct Point {
        Estimator estimator = Estimator::OutputError;
        std::array<double, 3> percent{}; ///< deviation of m, b, k
    };
    Estimator estimator = Estimator::OutputError;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of (m, b, k), percent squared
    double radius = 0;                                    ///< square root of the right side above
    std::vector<Point> others;                            ///< converged estimates, the region's own not

    [[nodiscard]] double correlation(int i, int j) const;
    /// Half the width of the region along one parameter, percent.
    [[nodiscard]] double extent(int parameter) const;
    /// The shadow's outline on the plane of two parameters (horizontal, vertical), closed, percent.
    [[nodiscard]] QList<QPointF> outline(int horizontal, int vertical, int points = 96) const;
};

/// Around the recommended estimate with its own covariance: noise alone. Nothing without parameters and a
/// covariance that is positive definite.
[[nodiscard]] std::optional<EstimateRegion> estimateRegion(const Identification& identification);
/// With the budget's covariance, in percent of its parameters (those without the empty gripper).
[[nodiscard]] std::optional<EstimateRegion> estimateRegion(const Identification& identification,
                                                           const UncertaintyBudget& budget);

/// What the largest of the three correlation coefficients does to m, b and k, in words.
[[nodiscard]] QString correlationWords(const EstimateRegion& region);

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
    void setPictureSize(QSize size) override { m_pictureSize = size; }
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
    QSize m_pictureSize; ///< valid: in place of that on the screen
    std::array<double, 3> m_half{1, 1, 1};
};

} // namespace gripscope
