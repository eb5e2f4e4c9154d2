// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/scene_view.h"

namespace gripscope {

/// The space as three plots of two parameters each (m-b, b-k, m-k), where there is no OpenGL. Painted by
/// hand: nothing but points, ellipses and axes.
class PairPlots : public SceneView {
    Q_OBJECT
public:
    explicit PairPlots(QWidget* parent = nullptr);

    [[nodiscard]] bool threeDimensional() const override { return false; }

protected:
    [[nodiscard]] std::vector<Spot> spots() const override;
    void contentChanged() override {}
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    struct Plot {
        int horizontal = 0, vertical = 1;
        QRectF area; ///< inside the axes
    };
    [[nodiscard]] std::vector<Plot> plots() const;
    [[nodiscard]] QPointF place(const Plot& plot, const Eigen::Vector3d& value) const;
    [[nodiscard]] static std::vector<Eigen::Vector3d> outlineOf(const Ellipsoid& ellipsoid, const Plot& plot);
    void paintFrame(QPainter& painter, const Plot& plot) const;
    void paintContent(QPainter& painter, const Plot& plot) const;
    void paintPoints(QPainter& painter, const Plot& plot) const;
};

} // namespace gripscope
