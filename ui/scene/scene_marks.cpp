// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_marks.h"

#include "ui/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

namespace gripscope {

namespace {

QPolygonF placed(const std::vector<Eigen::Vector3d>& values, const ScenePlace& place)
{
    QPolygonF places;
    places.reserve(qsizetype(values.size()));
    for (const Eigen::Vector3d& value : values)
        places << place(value);
    return places;
}

} // namespace

void drawTypeSign(QPainter& painter, QPointF at, double radius, int shape, const QColor& fill,
                  const QColor& outline)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(fill);
    painter.setPen(QPen(outline, 1.2));
    switch (shape % 4) {
    case 0:
        painter.drawEllipse(at, radius, radius);
        break;
    case 1:
        painter.drawRect(QRectF(at.x() - 0.85 * radius, at.y() - 0.85 * radius, 1.7 * radius, 1.7 * radius));
        break;
    case 2:
        painter.drawPolygon(QPolygonF{at + QPointF(0, -1.1 * radius),
                                      at + QPointF(1.1 * radius, 0.85 * radius),
                                      at + QPointF(-1.1 * radius, 0.85 * radius)});
        break;
    default:
        painter.drawPolygon(QPolygonF{at + QPointF(0, -1.2 * radius), at + QPointF(1.2 * radius, 0),
                                      at + QPointF(0, 1.2 * radius), at + QPointF(-1.2 * radius, 0)});
    }
    painter.restore();
}

void drawTypeSign(QPainter& painter, QPointF at, double radius, int type)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    drawTypeSign(painter, at, radius, typeShape(type), Theme::typeColor(type),
                 tokens.kind == ThemeKind::Light ? tokens.surface : tokens.text);
}

void drawHighlightRing(QPainter& painter, QPointF at)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens.surface, 5));
    painter.drawEllipse(at, 12, 12);
    painter.setPen(QPen(tokens.text, 2.5));
    painter.drawEllipse(at, 12, 12);
    painter.restore();
}

void drawPickRing(QPainter& painter, QPointF at)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens.surface, 3.5));
    painter.drawEllipse(at, 9, 9);
    painter.setPen(QPen(tokens.accent, 2));
    painter.drawEllipse(at, 9, 9);
    painter.restore();
}

void drawOwnError(QPainter& painter, const std::vector<Eigen::Vector3d>& line, const ScenePlace& place)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(tokens.accent, tokens.lineWidth));
    painter.drawPolyline(placed(line, place));
    painter.restore();
}

void drawNet(QPainter& painter, const SceneNet& net, const ScenePlace& place)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    constexpr double radius = 3.5;
    const QPolygonF places = placed(net.nodes, place);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QList<QLineF> lines;
    for (const auto& edge : net.edges)
        lines << QLineF(places[edge.first], places[edge.second]);
    painter.setPen(QPen(Theme::mix(tokens.surface, tokens.text, 0.6), tokens.lineWidth));
    painter.drawLines(lines);
    painter.setPen(QPen(tokens.surface, 1));
    for (qsizetype i = 0; i < places.size(); ++i) {
        painter.setBrush(Theme::typeColor(net.colors[std::size_t(i)]));
        painter.drawEllipse(places[i], radius, radius);
    }
    painter.restore();
}

void drawCentroid(QPainter& painter, const SceneCentroid& centroid, const ScenePlace& place)
{
    if (centroid.trail.empty())
        return;
    const QPolygonF trail = placed(centroid.trail, place);
    const QColor color = Theme::typeColor(centroid.color);
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [width, ink] : {std::pair(4.0, tokens.surface), std::pair(2.0, color)}) {
        painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(trail);
    }
    painter.setPen(QPen(tokens.surface, 1));
    painter.setBrush(color);
    for (qsizetype i = 0; i + 1 < trail.size(); ++i)
        painter.drawEllipse(trail[i], 3, 3);
    // A plus in a disc: no type has that sign.
    const QPointF at = trail.constLast();
    painter.setPen(QPen(tokens.text, 2));
    painter.setBrush(tokens.surface);
    painter.drawEllipse(at, 10, 10);
    painter.setPen(QPen(color, 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at - QPointF(6, 0), at + QPointF(6, 0));
    painter.drawLine(at - QPointF(0, 6), at + QPointF(0, 6));
    painter.restore();
}

} // namespace gripscope
