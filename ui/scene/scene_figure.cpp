// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_figure.h"

#include "ui/scene/scene_marks.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gripscope {

namespace {

constexpr int surfaceMeridians = 64, surfaceParallels = 32;
constexpr float ellipsoidTint = 0.16F;
constexpr double signRadius = 4.5;

double cross(QPointF from, QPointF one, QPointF two)
{
    return (one.x() - from.x()) * (two.y() - from.y()) - (one.y() - from.y()) * (two.x() - from.x());
}

/// Andrew's monotone chain.
QPolygonF convexHull(std::vector<QPointF> points)
{
    std::sort(points.begin(), points.end(),
              [](QPointF a, QPointF b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    QPolygonF hull;
    const auto chain = [&hull](const auto& begin, const auto& end) {
        const qsizetype base = hull.size();
        for (auto point = begin; point != end; ++point) {
            while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), *point) <= 0)
                hull.removeLast();
            hull << *point;
        }
        hull.removeLast(); // it begins the other chain
    };
    if (points.size() < 3)
        return hull;
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

void paintWalls(QPainter& painter, const SceneContent& content, const SceneCamera& camera,
                const SceneProjection& projection)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const Eigen::Vector3i far = farSides(camera);
    for (int wall = 0; wall < 3; ++wall) {
        for (const int along : {(wall + 1) % 3, (wall + 2) % 3}) {
            const int across = 3 - wall - along;
            const AxisScale& scale = content.axes[std::size_t(across)];
            std::vector<double> places{-0.5, 0.5};
            for (const double tick : scale.ticks)
                places.push_back(scale.unitPosition(tick) - 0.5);
            for (std::size_t i = 0; i < places.size(); ++i) {
                Eigen::Vector3d from;
                from[wall] = 0.5 * far[wall];
                from[across] = places[i];
                from[along] = -0.5;
                Eigen::Vector3d to = from;
                to[along] = 0.5;
                painter.setPen(
                    QPen(i < 2 ? Theme::mix(tokens.line, tokens.secondText, 0.5) : tokens.line, 1));
                painter.drawLine(projection.at(from), projection.at(to));
            }
        }
    }
}

void paintEllipsoids(QPainter& painter, const SceneContent& content, const SceneProjection& projection)
{
    const auto place = [&](const Eigen::Vector3d& value) {
        return projection.place(cubePosition(content, value));
    };
    const auto paint = [&](const Ellipsoid& shape, const QColor& color, float opacity) {
        QColor tint = color;
        tint.setAlphaF(opacity);
        painter.setPen(QPen(color, 1));
        painter.setBrush(tint);
        painter.drawPolygon(silhouette(content, shape, projection));
        painter.setPen(QPen(color, 0.5));
        for (const std::vector<Eigen::Vector3d>& ring : ellipsoidRings(shape)) {
            QPolygonF line;
            for (const Eigen::Vector3d& value : ring)
                line << place(value).at;
            painter.drawPolyline(line);
        }
    };
    std::vector<const SceneEllipsoid*> farFirst;
    for (const SceneEllipsoid& ellipsoid : content.ellipsoids)
        farFirst.push_back(&ellipsoid);
    std::sort(farFirst.begin(), farFirst.end(), [&](const SceneEllipsoid* a, const SceneEllipsoid* b) {
        return place(a->shape.centre).depth > place(b->shape.centre).depth;
    });
    for (const SceneEllipsoid* ellipsoid : farFirst)
        paint(ellipsoid->shape, Theme::typeColor(ellipsoid->color), ellipsoidTint);
    for (const SceneEllipsoid& error : content.errors) {
        painter.setPen(QPen(Theme::typeColor(error.color), 0.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(silhouette(content, error.shape, projection));
    }
    if (content.highlight && content.highlight->ellipsoid)
        paint(*content.highlight->ellipsoid, Theme::instance().tokens().text, ellipsoidTint);
}

void paintSigns(QPainter& painter, const SceneContent& content, const SceneProjection& projection)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QColor outline = tokens.kind == ThemeKind::Light ? tokens.surface : tokens.text;
    struct Placed {
        const ScenePoint* point;
        SceneProjection::Place place;
    };
    std::vector<Placed> farFirst;
    for (const ScenePoint& point : content.points)
        farFirst.push_back({&point, projection.place(cubePosition(content, point.at))});
    std::sort(farFirst.begin(), farFirst.end(),
              [](const Placed& a, const Placed& b) { return a.place.depth > b.place.depth; });
    const bool signs = farFirst.size() <= mostGlyphs;
    for (const Placed& one : farFirst) {
        const QColor color = Theme::typeColor(one.point->color);
        if (signs) {
            drawTypeSign(painter, one.place.at, signRadius, one.point->shape, color, outline);
            continue;
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawEllipse(one.place.at, 1.5, 1.5);
    }
}

} // namespace

QPolygonF silhouette(const SceneContent& content, const Ellipsoid& ellipsoid,
                     const SceneProjection& projection)
{
    std::vector<QPointF> points;
    for (int parallel = 0; parallel <= surfaceParallels; ++parallel) {
        const double polar = std::numbers::pi * parallel / surfaceParallels;
        for (int meridian = 0; meridian < surfaceMeridians; ++meridian) {
            const double angle = 2 * std::numbers::pi * meridian / surfaceMeridians;
            const Eigen::Vector3d direction(std::sin(polar) * std::cos(angle),
                                            std::sin(polar) * std::sin(angle), std::cos(polar));
            const Eigen::Vector3d value =
                ellipsoid.centre + ellipsoid.axes * ellipsoid.radii.cwiseProduct(direction);
            points.push_back(projection.at(cubePosition(content, value)));
        }
    }
    return convexHull(std::move(points));
}

void paintSceneFigure(QPainter& painter, const SceneContent& content, const SceneCamera& camera, QSizeF size)
{
    const SceneProjection projection(camera, size);
    const ScenePlace at = [&](const Eigen::Vector3d& value) {
        return projection.at(cubePosition(content, value));
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), size), Theme::instance().tokens().surface);
    paintWalls(painter, content, camera, projection);
    paintEllipsoids(painter, content, projection);
    paintSigns(painter, content, projection);
    paintSceneAxes(painter, content, camera, size);
    if (content.net)
        drawNet(painter, *content.net, at);
    for (const SceneCentroid& centroid : content.centroids)
        drawCentroid(painter, centroid, at);
    if (content.highlight) {
        const ThemeTokens& tokens = Theme::instance().tokens();
        const ScenePoint& point = content.highlight->point;
        drawTypeSign(painter, at(point.at), signRadius, point.shape, tokens.text, tokens.surface);
        drawHighlightRing(painter, at(point.at));
    }
    painter.restore();
}

} // namespace gripscope
