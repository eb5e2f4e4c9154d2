// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/recognition/types/type_model.h"
#include "ui/charts/axis_ticks.h"

#include <QPointF>
#include <QWidget>

#include <optional>
#include <vector>

namespace gripscope {

/// A small picture of stiffness against damping: an ellipse for each type (where 95 % of its squeezes lie)
/// and this part as a ringed point with its own 95 % ellipse. SI.
class TypeMap : public QWidget {
    Q_OBJECT
public:
    explicit TypeMap(QWidget* parent = nullptr);
    void setTypes(const TypeModels& models);
    /// `covariance`: of m, b, k; absent where it is not known.
    void setPart(const std::optional<MassDampingStiffness>& parameters,
                 const std::optional<Eigen::Matrix3d>& covariance);
    [[nodiscard]] QSize sizeHint() const override { return {360, 200}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 100}; }

    /// The edge of the region of k and b that holds 95 % of a type's squeezes, from its log-normal model.
    [[nodiscard]] static std::vector<QPointF> ellipse(const TypeModels& models, const TypeModel& type);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct View {
        QRectF plot;
        AxisRange k, b;
        [[nodiscard]] QPointF map(QPointF value) const;
    };
    [[nodiscard]] View view() const;
    void paintAxes(QPainter& painter, const View& view) const;
    void paintTypes(QPainter& painter, const View& view) const;
    void paintNames(QPainter& painter, const View& view, const std::vector<QRectF>& bounds) const;
    void paintPart(QPainter& painter, const View& view) const;

    struct Shape {
        QString name;
        QPointF centre; ///< k in kN/m, b in N s/m
        std::vector<QPointF> edge;
    };
    std::vector<Shape> m_shapes;
    std::optional<QPointF> m_part;
    std::vector<QPointF> m_partEdge; ///< of its 95 % ellipse
};

} // namespace gripscope
