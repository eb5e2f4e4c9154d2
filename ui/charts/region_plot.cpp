// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/region_plot.h"

#include "core/identification/estimators/estimator_table.h"
#include "ui/charts/axis_ticks.h"
#include "ui/format/estimate_words.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A regular polygon, its first corner at `turn` (radians, 0 is to the right).
QPolygonF polygon(QPointF center, double radius, int corners, double turn)
{
    QPolygonF result;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + 2 * std::numbers::pi * i / corners;
        result << center + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    return result;
}

/// The estimator's own sign, about `size` pixels across: shape and colour both tell it.
void paintEstimatorSign(QPainter& painter, Estimator estimator, QPointF at, double size)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const double radius = size / 2;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool outlined = tokens.kind != ThemeKind::Light;
    painter.setPen(outlined ? QPen(tokens.text, 1) : QPen(tokens.surface, 0.75));
    painter.setBrush(Theme::typeColor(int(estimator)));
    const EstimatorSign& sign = factsOf(estimator).sign;
    if (sign.corners == 0)
        painter.drawEllipse(at, radius, radius);
    else
        painter.drawPolygon(polygon(at, sign.size * radius, sign.corners, sign.turn));
    painter.restore();
}

// Around and between the frames, logical pixels.
constexpr double regionLeft = 54, regionRight = 10, regionTop = 26, regionBottom = 38, regionGap = 10;
constexpr double regionSignSize = 9;
/// Of a frame, in half widths of the region: room for what is told at its border.
constexpr double roomFactor = 1.5;
/// Another estimator widens the frames to be seen in them when it is no farther off than this.
constexpr double farFactor = 3;

QString parameterName(int parameter)
{
    return QString(u"mbk"_s[parameter]);
}

bool overlapsAny(const QRectF& rect, const std::vector<QRectF>& taken)
{
    return std::any_of(taken.begin(), taken.end(),
                       [&](const QRectF& other) { return other.intersects(rect); });
}

/// Round ticks, three at least: one number says nothing about the scale.
AxisTicks ticksWithin(double half, double room, double each)
{
    int most = std::max(3, int(room / each));
    AxisTicks ticks = roundTicks(-half, half, most);
    while (ticks.values.size() < 3 && ++most < 12)
        ticks = roundTicks(-half, half, most);
    return ticks;
}

void drawText(QPainter& painter, const QRectF& room, int flags, const QString& text, const QColor& color,
              bool strong = false)
{
    painter.setFont(Theme::font(metrics::fontSmall, strong));
    painter.setPen(color);
    painter.drawText(room, flags | Qt::TextDontClip, text);
}

} // namespace

RegionPlot::RegionPlot(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("95 % joint region of m, b and k"));
    connect(&Theme::instance(), &Theme::changed, this, [this] { update(); });
}

void RegionPlot::setRegion(const std::optional<EstimateRegion>& region)
{
    m_region = region;
    for (int i = 0; m_region && i < 3; ++i) {
        const auto at = std::size_t(i);
        m_half[at] = roomFactor * m_region->extent(i);
        for (const EstimateRegion::Point& point : m_region->others) {
            bool near = true;
            for (int j = 0; j < 3; ++j)
                near = near && std::abs(point.percent[std::size_t(j)]) <= farFactor * m_region->extent(j);
            if (near)
                m_half[at] = std::max(m_half[at], 1.15 * std::abs(point.percent[at]));
        }
    }
    const QString words = describe();
    setToolTip(words);
    setAccessibleDescription(words);
    update();
}

bool RegionPlot::within(const EstimateRegion::Point& point) const
{
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(point.percent[i]) <= m_half[i]))
            return false;
    return true;
}

QString RegionPlot::describe() const
{
    if (!m_region)
        return {};
    QStringList lines;
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
        lines << tr("Correlation of %1 and %2: %3")
                     .arg(parameterName(i), parameterName(j))
                     .arg(m_region->correlation(i, j), 0, 'f', 2);
    for (const EstimateRegion::Point& point : m_region->others) {
        QStringList off;
        for (int i = 0; i < 3; ++i)
            off << parameterName(i) + u' ' + deviationText(point.percent[std::size_t(i)] / 100);
        lines << u"%1: %2"_s.arg(estimatorName(point.estimator), off.join(u", "_s));
    }
    return lines.join(u'\n');
}

QPointF RegionPlot::place(const Frame& frame, QPointF percent) const
{
    const QPointF center = frame.area.center();
    return {center.x() + percent.x() / halfRange(frame.horizontal) * frame.area.width() / 2,
            center.y() - percent.y() / halfRange(frame.vertical) * frame.area.height() / 2};
}

void RegionPlot::paint(QPainter& painter, QSizeF size) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), size), tokens.surface);
    if (!m_region) {
        drawText(painter, QRectF(QPointF(), size), Qt::AlignCenter | Qt::TextWordWrap,
                 tr("No region without an estimate and its error bars"), tokens.secondText);
        return;
    }
    const double width = (size.width() - regionLeft - regionRight - regionGap) / 2;
    const double height = (size.height() - regionTop - regionBottom - regionGap) / 2;
    const double column = regionLeft + width + regionGap, row = regionTop + height + regionGap;
    drawText(painter, QRectF(12, 4, size.width() - 20, 18), Qt::AlignLeft | Qt::AlignVCenter,
             tr("95 % joint region, in % of the recommended m, b, k"), tokens.text, true);
    for (const Frame& frame : {Frame{0, 1, {regionLeft, regionTop, width, height}, false, true},
                               Frame{0, 2, {regionLeft, row, width, height}, true, true},
                               Frame{1, 2, {column, row, width, height}, true, false}})
        paintFrame(painter, frame);
    paintLegend(painter, {column + 6, regionTop, width - 6, height});
}

void RegionPlot::paintFrame(QPainter& painter, const Frame& frame) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    paintAxes(painter, frame);
    QPolygonF outline;
    for (const QPointF& point : m_region->outline(frame.horizontal, frame.vertical))
        outline << place(frame, point);
    painter.setBrush(tokens.kind == ThemeKind::HighContrast
                         ? tokens.surface
                         : Theme::mix(tokens.surface, tokens.accent, 0.16));
    painter.setPen(QPen(tokens.accent, 0.75 * tokens.curveWidth));
    painter.drawPolygon(outline);
    paintEstimatorSign(painter, m_region->estimator, frame.area.center(), regionSignSize);
    paintOthers(painter, frame);
}

void RegionPlot::paintAxes(QPainter& painter, const Frame& frame) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF& area = frame.area;
    const double across = halfRange(frame.horizontal), up = halfRange(frame.vertical);
    const QPen grid(Theme::mix(tokens.surface, tokens.line, 0.7), 1);
    const AxisTicks below = ticksWithin(across, area.width(), 48);
    for (const double tick : below.values) {
        const double x = place(frame, {tick, 0}).x();
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        if (frame.ticksBelow)
            drawText(painter, QRectF(x - 30, area.bottom() + 2, 60, 16), Qt::AlignCenter, below.label(tick),
                     tokens.secondText);
    }
    const AxisTicks beside = ticksWithin(up, area.height(), 26);
    for (const double tick : beside.values) {
        const double y = place(frame, {0, tick}).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        if (frame.ticksLeft)
            drawText(painter, QRectF(16, y - 8, area.left() - 20, 16), Qt::AlignRight | Qt::AlignVCenter,
                     beside.label(tick), tokens.secondText);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens.line, tokens.lineWidth));
    painter.drawRect(area);
    if (frame.ticksBelow)
        drawText(painter, QRectF(area.left(), area.bottom() + 18, area.width(), 16), Qt::AlignCenter,
                 tr("%1 (%)").arg(parameterName(frame.horizontal)), tokens.text);
    if (!frame.ticksLeft)
        return;
    painter.save();
    painter.translate(9, area.center().y());
    painter.rotate(-90);
    drawText(painter, QRectF(-40, -8, 80, 16), Qt::AlignCenter,
             tr("%1 (%)").arg(parameterName(frame.vertical)), tokens.text);
    painter.restore();
}

void RegionPlot::paintOthers(QPainter& painter, const Frame& frame) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    // The coefficient stands in a corner that the ellipse leaves free.
    const double r = m_region->correlation(frame.horizontal, frame.vertical);
    const double rounded = std::abs(r) < 0.005 ? 0 : r; // no negative nought
    const QString text = u"r = %L1"_s.arg(rounded, 0, 'f', 2).replace(u'-', QChar(0x2212));
    const double width = QFontMetricsF(Theme::font(metrics::fontSmall)).horizontalAdvance(text);
    const double x = r < 0 ? frame.area.right() - width - 5 : frame.area.left() + 5;
    const QRectF coefficient(x, frame.area.top() + 2, width, 15);
    drawText(painter, coefficient, Qt::AlignLeft | Qt::AlignVCenter, text, tokens.text);
    std::vector<QRectF> taken{coefficient};
    for (const EstimateRegion::Point& point : m_region->others) {
        const QPointF percent(point.percent[std::size_t(frame.horizontal)],
                              point.percent[std::size_t(frame.vertical)]);
        if (std::abs(percent.x()) <= halfRange(frame.horizontal) &&
            std::abs(percent.y()) <= halfRange(frame.vertical))
            paintEstimatorSign(painter, point.estimator, place(frame, percent), regionSignSize);
        else
            paintOutside(painter, frame, point, taken);
    }
}

void RegionPlot::paintOutside(QPainter& painter, const Frame& frame, const EstimateRegion::Point& point,
                              std::vector<QRectF>& taken) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const double x = point.percent[std::size_t(frame.horizontal)] / halfRange(frame.horizontal);
    const double y = point.percent[std::size_t(frame.vertical)] / halfRange(frame.vertical);
    const bool sideways = std::abs(x) >= std::abs(y);
    const double farthest = std::max(std::abs(x), std::abs(y));
    const int parameter = sideways ? frame.horizontal : frame.vertical;
    const QString text = deviationText(point.percent[std::size_t(parameter)] / 100);
    const double textWidth = QFontMetricsF(Theme::font(metrics::fontSmall)).horizontalAdvance(text);

    // Along the direction outwards: arrow, sign, words; along the border it moves to where there is room.
    const QPointF outwards = sideways ? QPointF(x > 0 ? 1 : -1, 0) : QPointF(0, y > 0 ? -1 : 1);
    const QPointF center = frame.area.center();
    const double halfWidth = frame.area.width() / 2, halfHeight = frame.area.height() / 2;
    const double step = sideways ? 15 : textWidth + regionSignSize + 10;
    const double reach = sideways ? halfHeight - 9 : halfWidth - (textWidth + regionSignSize) / 2 - 8;
    const double wanted = sideways ? -y / farthest * halfHeight : x / farthest * halfWidth;
    for (int attempt = 0; attempt < 12; ++attempt) {
        const double shift = (attempt % 2 == 1 ? 1 : -1) * ((attempt + 1) / 2) * step;
        const double along = std::clamp(wanted, -reach, reach) + shift;
        if (std::abs(along) > reach + 0.5)
            continue;
        const QPointF tip = center + (sideways ? QPointF(outwards.x() * (halfWidth - 2), along)
                                               : QPointF(along, outwards.y() * (halfHeight - 2)));
        const QPointF sign = sideways ? tip - outwards * (7 + regionSignSize / 2)
                                      : tip - outwards * 14 - QPointF((textWidth + 4) / 2, 0);
        const QRectF words = sideways && outwards.x() > 0
                                 ? QRectF(sign.x() - regionSignSize - textWidth, sign.y() - 8, textWidth, 16)
                                 : QRectF(sign.x() + regionSignSize, sign.y() - 8, textWidth, 16);
        const QRectF whole = words.united(QRectF(sign, QSizeF()).adjusted(-6, -6, 6, 6));
        if (overlapsAny(whole, taken))
            continue;
        taken.push_back(whole);
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.text);
        const QPointF across(outwards.y(), outwards.x());
        painter.drawPolygon(QPolygonF{tip, tip - outwards * 5 + across * 4, tip - outwards * 5 - across * 4});
        paintEstimatorSign(painter, point.estimator, sign, regionSignSize);
        QColor behind = tokens.surface; // words across an outline stay legible
        behind.setAlphaF(0.8F);
        painter.fillRect(words.adjusted(-1, 1, 1, -1), behind);
        drawText(painter, words, Qt::AlignLeft | Qt::AlignVCenter, text, tokens.text);
        return;
    }
}

void RegionPlot::paintLegend(QPainter& painter, const QRectF& area) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QFontMetricsF font(Theme::font(metrics::fontSmall));
    constexpr double line = 16;
    double y = area.top();
    const auto entry = [&](Estimator estimator, const QColor& color) {
        if (y + line > area.bottom() + 1)
            return;
        paintEstimatorSign(painter, estimator, {area.left() + 6, y + line / 2}, regionSignSize);
        drawText(painter, {area.left() + 18, y, area.width() - 18, line}, Qt::AlignLeft | Qt::AlignVCenter,
                 elided(font, estimatorName(estimator), area.width() - 18), color);
        y += line;
    };
    entry(m_region->estimator, tokens.text);
    for (const EstimateRegion::Point& point : m_region->others)
        entry(point.estimator, tokens.secondText);
}

void RegionPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, size());
    if (!hasFocus())
        return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::instance().tokens().accent, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

QString RegionPlot::plotName() const
{
    return tr("Joint region");
}

QString RegionPlot::fileName() const
{
    return u"joint-region"_s;
}

QSize RegionPlot::pictureSize() const
{
    if (m_pictureSize.isValid()) // three frames in a triangle are higher than a curve
        return m_pictureSize.expandedTo({m_pictureSize.width(), m_pictureSize.width() * 4 / 5});
    return size().expandedTo({480, 400}); // a narrow panel is no reason for a cramped picture
}

void RegionPlot::paintPicture(QPainter& painter)
{
    paint(painter, pictureSize());
}

PlotTable RegionPlot::numbers() const
{
    using Values = std::vector<double>;
    PlotTable table;
    if (!m_region)
        return table;
    const auto add = [&](const QString& name, auto&& take, const auto& from) {
        auto values = std::make_shared<Values>();
        for (const auto& one : from)
            values->push_back(take(one));
        table.push_back({name, values});
    };
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        const QString pair = u"%1-%2"_s.arg(parameterName(i), parameterName(j));
        const QList<QPointF> outline = m_region->outline(i, j);
        add(
            tr("%1 outline: %2 (%)").arg(pair, parameterName(i)), [](QPointF p) { return p.x(); }, outline);
        add(
            tr("%1 outline: %2 (%)").arg(pair, parameterName(j)), [](QPointF p) { return p.y(); }, outline);
    }
    for (const EstimateRegion::Point& point : m_region->others)
        add(
            tr("%1: m, b, k (%)").arg(estimatorName(point.estimator)), [](double value) { return value; },
            point.percent);
    return table;
}

} // namespace gripscope
