// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_marks.h"
#include "ui/scene/scene_view.h"
#include "ui/theme/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <map>

namespace gripscope {

namespace {
constexpr double pairLeft = 56, pairRight = 16, pairTop = 16,
                 pairBottom = 44; // around a plot, for numbers and titles
} // namespace

PairPlots::PairPlots(QWidget* parent) : SceneView(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
}

std::vector<PairPlots::Plot> PairPlots::plots() const
{
    // m-b and b-k side by side, m-k below the first: the axes that plots share stand under or beside each
    // other.
    const double w = width() / 2.0;
    const double h = height() / 2.0;
    const auto area = [&](int column, int row) {
        return QRectF(column * w + pairLeft, row * h + pairTop, std::max(20.0, w - pairLeft - pairRight),
                      std::max(20.0, h - pairTop - pairBottom));
    };
    return {{0, 2, area(0, 0)}, {1, 2, area(1, 0)}, {0, 1, area(0, 1)}};
}

QPointF PairPlots::place(const Plot& plot, const Eigen::Vector3d& value) const
{
    const auto& axes = content().axes;
    return {plot.area.left() +
                axes[std::size_t(plot.horizontal)].unitPosition(value[plot.horizontal]) * plot.area.width(),
            plot.area.bottom() -
                axes[std::size_t(plot.vertical)].unitPosition(value[plot.vertical]) * plot.area.height()};
}

std::vector<SceneView::Spot> PairPlots::spots() const
{
    std::vector<Spot> result;
    for (const Plot& plot : plots()) {
        for (const ScenePoint& point : content().points)
            result.push_back({&point, place(plot, point.at), 0});
        if (content().highlight)
            result.push_back({&content().highlight->point, place(plot, content().highlight->point.at), 0});
    }
    return result;
}

std::vector<Eigen::Vector3d> PairPlots::outlineOf(const Ellipsoid& ellipsoid, const Plot& plot)
{
    const Eigen::Matrix2Xd shadow = ellipsoidOutline(ellipsoid, plot.horizontal, plot.vertical);
    std::vector<Eigen::Vector3d> line;
    line.reserve(std::size_t(shadow.cols()) + 1);
    for (Eigen::Index i = 0; i <= shadow.cols(); ++i) { // back to the first: closed
        Eigen::Vector3d value = ellipsoid.centre;
        value[plot.horizontal] = shadow(0, i % shadow.cols());
        value[plot.vertical] = shadow(1, i % shadow.cols());
        line.push_back(value);
    }
    return line;
}

void PairPlots::paintFrame(QPainter& painter, const Plot& plot) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const AxisScale& across = content().axes[std::size_t(plot.horizontal)];
    const AxisScale& up = content().axes[std::size_t(plot.vertical)];
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setFont(Theme::font(metrics::fontSmall));
    const QFontMetricsF metrics(painter.font(), painter.device());
    double taken = -HUGE_VAL;
    for (const double tick : across.ticks) {
        const double x = plot.area.left() + across.unitPosition(tick) * plot.area.width();
        painter.setPen(QPen(tokens.line, tokens.lineWidth));
        painter.drawLine(QPointF(x, plot.area.top()), QPointF(x, plot.area.bottom()));
        const QString text = across.tickText(tick);
        const double half = metrics.horizontalAdvance(text) / 2;
        if (x - half < taken + 6)
            continue;
        taken = x + half;
        painter.setPen(tokens.secondText);
        painter.drawText(QRectF(x - 50, plot.area.bottom() + 4, 100, 16), Qt::AlignHCenter | Qt::AlignTop,
                         text);
    }
    taken = HUGE_VAL;
    for (const double tick : up.ticks) {
        const double y = plot.area.bottom() - up.unitPosition(tick) * plot.area.height();
        painter.setPen(QPen(tokens.line, tokens.lineWidth));
        painter.drawLine(QPointF(plot.area.left(), y), QPointF(plot.area.right(), y));
        if (y + metrics.height() / 2 > taken)
            continue;
        taken = y - metrics.height() / 2;
        painter.setPen(tokens.secondText);
        painter.drawText(QRectF(plot.area.left() - pairLeft, y - 10, pairLeft - 6, 20),
                         Qt::AlignRight | Qt::AlignVCenter, up.tickText(tick));
    }
    painter.setFont(Theme::font(metrics::fontSmall, true));
    painter.setPen(tokens.text);
    painter.drawText(QRectF(plot.area.left(), plot.area.bottom() + 20, plot.area.width(), 18),
                     Qt::AlignCenter, across.title());
    painter.save();
    painter.translate(plot.area.left() - pairLeft + 8, plot.area.center().y());
    painter.rotate(-90);
    painter.drawText(QRectF(-plot.area.height() / 2, -8, plot.area.height(), 16), Qt::AlignCenter,
                     up.title());
    painter.restore();
}

void PairPlots::paintContent(QPainter& painter, const Plot& plot) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto outline = [&](const Ellipsoid& ellipsoid, const QColor& color, float opacity) {
        QPolygonF polygon;
        for (const Eigen::Vector3d& value : outlineOf(ellipsoid, plot))
            polygon << place(plot, value);
        QColor tint = color;
        tint.setAlphaF(opacity);
        painter.setBrush(tint);
        painter.setPen(QPen(color, tokens.lineWidth));
        painter.drawPolygon(polygon);
    };
    for (const SceneEllipsoid& ellipsoid : content().ellipsoids)
        outline(ellipsoid.shape, Theme::typeColor(ellipsoid.color), 0.14f);
    for (const SceneEllipsoid& error : content().errors)
        outline(error.shape, Theme::typeColor(error.color), 0);
    if (content().highlight && content().highlight->ellipsoid)
        outline(*content().highlight->ellipsoid, tokens.text, 0.14f);
    paintPoints(painter, plot);
    const ScenePlace at = [&](const Eigen::Vector3d& value) { return place(plot, value); };
    if (pickedError())
        drawOwnError(painter, outlineOf(*pickedError(), plot), at);
    if (content().net)
        drawNet(painter, *content().net, at);
    for (const SceneCentroid& centroid : content().centroids)
        drawCentroid(painter, centroid, at);
    if (content().highlight) {
        const ScenePoint& point = content().highlight->point;
        drawTypeSign(painter, place(plot, point.at), 4.5, point.shape, tokens.text, tokens.surface);
        drawHighlightRing(painter, place(plot, point.at));
    }
}

void PairPlots::paintPoints(QPainter& painter, const Plot& plot) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    if (content().points.size() > mostGlyphs) {
        std::map<int, QPolygonF> dots;
        for (const ScenePoint& point : content().points)
            dots[point.color] << place(plot, point.at);
        for (const auto& [color, places] : dots) {
            painter.setPen(QPen(Theme::typeColor(color), 3, Qt::SolidLine, Qt::RoundCap));
            painter.drawPoints(places);
        }
    }
    for (const ScenePoint& point : content().points) {
        const QPointF at = place(plot, point.at);
        if (content().points.size() <= mostGlyphs)
            drawTypeSign(painter, at, 4.5, point.shape, Theme::typeColor(point.color),
                         tokens.kind == ThemeKind::Light ? tokens.surface : tokens.text);
        if (!pickedId().isEmpty() && point.id == pickedId())
            drawPickRing(painter, at);
    }
}

void PairPlots::paintPlots(QPainter& painter) const
{
    for (const Plot& plot : plots()) {
        paintFrame(painter, plot);
        painter.save();
        painter.setClipRect(plot.area.adjusted(-8, -8, 8, 8));
        paintContent(painter, plot);
        painter.restore();
    }
}

void PairPlots::paintPicture(QPainter& painter)
{
    if (empty() || width() < 1)
        return;
    const QSizeF all = pictureSize();
    const double scale = std::min(all.width() / width(), all.height() / height());
    painter.save();
    painter.fillRect(QRectF(QPointF(), all), Theme::instance().tokens().surface);
    painter.scale(scale, scale);
    paintPlots(painter);
    painter.restore();
}

void PairPlots::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(rect(), tokens.surface);
    painter.setPen(tokens.secondText);
    painter.setFont(Theme::font(metrics::fontBase));
    if (empty()) {
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, emptyText());
        return;
    }
    paintPlots(painter);
    const std::vector<Plot> all = plots();
    painter.setPen(tokens.secondText);
    painter.setFont(Theme::font(metrics::fontSmall));
    const QRectF free(all[1].area.left(), all[2].area.top(), all[1].area.width(), all[2].area.height());
    painter.drawText(
        free, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
        tr("This computer has no OpenGL 3.2, so the space is shown as three plots instead of a scene."));
    if (hasFocus()) {
        painter.setPen(QPen(tokens.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void PairPlots::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        pickAt(event->position());
}

void PairPlots::mouseMoveEvent(QMouseEvent* event)
{
    setCursor(pointNear(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

} // namespace gripscope
