// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/recognition/types/type_model.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/plot_export.h"

#include <QPointF>
#include <QWidget>

#include <optional>
#include <vector>

namespace gripscope {

/// A small picture of stiffness against damping: an ellipse for each type (where 95 % of its squeezes lie),
/// squeezes as points, and this part as a ringed point with its own 95 % ellipse. SI.
class TypeMap : public QWidget, public ExportablePlot {
    Q_OBJECT
public:
    explicit TypeMap(QWidget* parent = nullptr);
    /// `elsewhere`: where these are none there are types all the same, told apart without m, b and k.
    void setTypes(const TypeModels& models, bool elsewhere = false);
    /// Those of the types shown, as points in the colours of these; those of `own` stand out.
    void setSqueezes(const std::vector<TypeSqueeze>& squeezes, const QString& own);
    /// `covariance`: of m, b, k; absent where it is not known.
    void setPart(const std::optional<MassDampingStiffness>& parameters,
                 const std::optional<Eigen::Matrix3d>& covariance);

    [[nodiscard]] QString plotName() const override;
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QSize pictureSize() const override
    {
        return m_pictureSize.isValid() ? m_pictureSize : size();
    }
    void setPictureSize(QSize size) override { m_pictureSize = size; }
    void paintPicture(QPainter& painter) override;
    /// A row each mean, squeeze and corner of an edge, and this part: what it is, of which type, k and b.
    [[nodiscard]] PlotTable numbers() const override;

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
    void paint(QPainter& painter) const;
    void paintAxes(QPainter& painter, const View& view) const;
    void paintTypes(QPainter& painter, const View& view) const;
    void paintSqueezes(QPainter& painter, const View& view) const;
    void paintNames(QPainter& painter, const View& view, const std::vector<QRectF>& bounds) const;
    void paintPart(QPainter& painter, const View& view) const;

    struct Shape {
        QString name;
        int sign = 0;   ///< which colour, see Theme::typeColor()
        QPointF centre; ///< k in kN/m, b in N s/m
        std::vector<QPointF> edge;
    };
    struct Point {
        QPointF at;            ///< as a shape's centre
        std::size_t shape = 0; ///< whose it is
        bool own = false;
    };
    std::vector<Shape> m_shapes;
    std::vector<Point> m_points;
    std::optional<QPointF> m_part;
    std::vector<QPointF> m_partEdge; ///< of its 95 % ellipse
    bool m_elsewhere = false;
    QSize m_pictureSize; ///< valid: in place of that on the screen
};

} // namespace gripscope
