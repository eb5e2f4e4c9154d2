// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_figure.h"
#include "ui/theme/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <cmath>
#include <vector>

namespace gripscope {

namespace {

struct Edge {
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
    QPointF a, b;    ///< on the screen
    QPointF outward; ///< unit vector on the screen, away from the cube
    [[nodiscard]] double length() const { return std::hypot(b.x() - a.x(), b.y() - a.y()); }
};

Edge makeEdge(int axis, const Eigen::Vector3d& anchor, const SceneProjection& projection)
{
    Edge edge;
    edge.from = anchor;
    edge.to = anchor;
    edge.from[axis] = -0.5;
    edge.to[axis] = 0.5;
    edge.a = projection.at(edge.from);
    edge.b = projection.at(edge.to);
    const double length = edge.length();
    if (length < 1)
        return edge;
    QPointF normal(-(edge.b.y() - edge.a.y()) / length, (edge.b.x() - edge.a.x()) / length);
    const QPointF middle = (edge.a + edge.b) / 2;
    if (QPointF::dotProduct(normal, middle - projection.at(Eigen::Vector3d::Zero())) < 0)
        normal = -normal;
    edge.outward = normal;
    return edge;
}

/// m and b along the edge of the floor that is nearest to the eye; k up the edge at the left.
Edge labelledEdge(int axis, const Eigen::Vector3i& far, const SceneProjection& projection)
{
    const Eigen::Vector3d half = 0.5 * far.cast<double>();
    if (axis == 0)
        return makeEdge(0, {0, -half.y(), half.z()}, projection);
    if (axis == 1)
        return makeEdge(1, {-half.x(), 0, half.z()}, projection);
    const Edge one = makeEdge(2, {-half.x(), half.y(), 0}, projection);
    const Edge other = makeEdge(2, {half.x(), -half.y(), 0}, projection);
    return one.a.x() <= other.a.x() ? one : other;
}

QRectF textRect(const QString& text, QPointF beside, QPointF outward, double gap,
                const QFontMetricsF& metrics)
{
    const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
    // Pushed out until the box clears the edge by `gap`.
    const double reach = std::abs(outward.x()) * size.width() / 2 + std::abs(outward.y()) * size.height() / 2;
    const QPointF centre = beside + outward * (gap + reach);
    return {centre - QPointF(size.width() / 2, size.height() / 2), size};
}

QRectF moveInside(QRectF rect, QSizeF size)
{
    rect.moveLeft(std::clamp(rect.left(), 4.0, std::max(4.0, size.width() - rect.width() - 4)));
    rect.moveTop(std::clamp(rect.top(), 2.0, std::max(2.0, size.height() - rect.height() - 2)));
    return rect;
}

bool coversAny(const QRectF& rect, const std::vector<QRectF>& taken)
{
    const QRectF padded = rect.adjusted(-4, 0, 4, 0);
    return std::any_of(taken.begin(), taken.end(),
                       [&](const QRectF& other) { return padded.intersects(other); });
}

class AxisPainter {
public:
    AxisPainter(QPainter& painter, QSizeF size) : m_painter(painter), m_size(size) {}

    void paint(const AxisScale& scale, const Edge& edge)
    {
        constexpr double shortest = 48; // below that there is no room for two numbers
        if (edge.length() < shortest)
            return;
        const double reach = paintTicks(scale, edge);
        paintTitle(scale, edge, reach);
    }

private:
    double paintTicks(const AxisScale& scale, const Edge& edge)
    {
        const ThemeTokens& tokens = Theme::instance().tokens();
        m_painter.setFont(Theme::font(metrics::fontSmall));
        const QFontMetricsF metrics(m_painter.font(), m_painter.device());
        double reach = 0;
        for (const double tick : scale.ticks) {
            const double share = scale.unitPosition(tick);
            const QPointF at = edge.a + (edge.b - edge.a) * share;
            const QString text = scale.tickText(tick);
            const QRectF rect = textRect(text, at, edge.outward, 8, metrics);
            if (coversAny(rect, m_taken) || !QRectF(QPointF(), m_size).contains(rect))
                continue;
            m_painter.setPen(QPen(tokens.secondText, tokens.lineWidth));
            m_painter.drawLine(at, at + edge.outward * 4);
            m_painter.drawText(rect, Qt::AlignCenter, text);
            m_taken.push_back(rect);
            reach = std::max(reach, std::abs(edge.outward.x()) * rect.width() +
                                        std::abs(edge.outward.y()) * rect.height());
        }
        return reach;
    }

    void paintTitle(const AxisScale& scale, const Edge& edge, double reach)
    {
        m_painter.setFont(Theme::font(metrics::fontSmall, true));
        m_painter.setPen(Theme::instance().tokens().text);
        const QFontMetricsF metrics(m_painter.font(), m_painter.device());
        const QPointF along = edge.b - edge.a;
        const bool steep =
            std::abs(along.y()) > 2 * std::abs(along.x()); // the title then stands on its upper end
        const QPointF top = edge.a.y() < edge.b.y() ? edge.a : edge.b;
        const QRectF wanted =
            steep ? textRect(scale.title(), top, QPointF(0, -1), 10, metrics)
                  : textRect(scale.title(), (edge.a + edge.b) / 2, edge.outward, 14 + reach, metrics);
        const QRectF rect = moveInside(wanted, m_size);
        m_painter.drawText(rect, Qt::AlignCenter, scale.title());
        m_taken.push_back(rect);
    }

    QPainter& m_painter;
    QSizeF m_size;
    std::vector<QRectF> m_taken;
};

} // namespace

Eigen::Vector3i farSides(const SceneCamera& camera)
{
    // Seen exactly along an axis the far side is a matter of taste: the floor, and the walls that leave the
    // ticks at the left and below.
    constexpr double straight = 1e-9;
    const Eigen::Vector3d forward = SceneProjection(camera, QSizeF(100, 100)).forward;
    return {forward.x() >= -straight ? 1 : -1, forward.y() >= -straight ? 1 : -1,
            forward.z() > straight ? 1 : -1};
}

void paintSceneAxes(QPainter& painter, const SceneContent& content, const SceneCamera& camera, QSizeF size)
{
    const SceneProjection projection(camera, size);
    const Eigen::Vector3i far = farSides(camera);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    AxisPainter axes(painter, size);
    for (int axis = 0; axis < 3; ++axis)
        axes.paint(content.axes[std::size_t(axis)], labelledEdge(axis, far, projection));
    painter.restore();
}

} // namespace gripscope
