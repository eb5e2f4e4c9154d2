// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/control_plot.h"

#include "ui/format/number_format.h"
#include "ui/theme/elided_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double controlLeft = 66, controlRight = 62, controlTop = 24, controlBottom = 8, controlAxis = 26;
constexpr double labelHeight = 14;                ///< two labels nearer than that would touch
constexpr double signalSize = 6, pointSize = 2.2; // half of what they are across
constexpr double controlReach = 16;               ///< so near a click has to be, pixels

} // namespace

ControlPlot::ControlPlot(const ProcessPicture& picture, const ControlPanel& panel, const PointsInView& view,
                         const QRectF& box, bool withAxis)
    : m_picture(picture), m_series(picture, panel), m_view(view), m_box(box), m_withAxis(withAxis)
{
    m_view.last = std::min(m_view.last, m_series.points());
    m_view.first = std::min(m_view.first, m_view.last);
    m_area = box.adjusted(controlLeft, controlTop, -controlRight, -(withAxis ? controlAxis : controlBottom));
    findRange();
}

void ControlPlot::findRange()
{
    if (m_view.count() == 0)
        return;
    const ControlSeries::Span span = m_series.span(m_view.first, m_view.last);
    double low = span.any ? span.low : 0, high = span.any ? span.high : 1;
    for (const std::size_t place : {m_view.first, m_view.last - 1}) {
        low = std::min(low, m_series.lower(place));
        high = std::max(high, m_series.upper(place));
    }
    m_range = roundRange(low, high, std::max(1e-12, 1e-9 * std::abs(high)));
}

double ControlPlot::height(double value) const
{
    return m_area.bottom() - (value - m_range.low) / m_range.span() * m_area.height();
}

double ControlPlot::across(double point) const
{
    return m_area.left() + (point - double(m_view.first) + 0.5) / double(m_view.count()) * m_area.width();
}

double ControlPlot::placeAt(double x) const
{
    return double(m_view.first) + (x - m_area.left()) / m_area.width() * double(m_view.count());
}

QPointF ControlPlot::position(std::size_t point) const
{
    return {across(double(point)), height(m_series.value(point).value_or(m_series.centre()))};
}

std::size_t ControlPlot::pointOf(qint64 number) const
{
    std::size_t from = m_view.first, to = m_view.last;
    while (from < to) {
        const std::size_t middle = (from + to) / 2;
        if (m_series.number(middle) < number)
            from = middle + 1;
        else
            to = middle;
    }
    return from;
}

bool ControlPlot::crowded() const
{
    return double(m_view.count()) > m_area.width() / 2;
}

std::size_t ControlPlot::columns() const
{
    return std::size_t(std::max(1.0, std::floor(m_area.width())));
}

std::size_t ControlPlot::columnBegin(std::size_t column) const
{
    return m_view.first + m_view.count() * column / columns();
}

void ControlPlot::paint(QPainter& painter, const ThemeTokens& tokens) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_view.count() > 0)
        paintGround(painter, tokens);
    paintFrame(painter, tokens);
    if (m_view.count() > 0) {
        paintLimits(painter, tokens);
        if (crowded())
            paintColumns(painter, tokens);
        else
            paintPoints(painter, tokens);
    }
    painter.restore();
}

void ControlPlot::paintGround(QPainter& painter, const ThemeTokens& tokens) const
{
    const std::optional<FixedLimits>& fixed = m_picture.options.fixed;
    if (!fixed)
        return;
    const std::size_t first = pointOf(fixed->first), last = pointOf(fixed->last + 1);
    if (first >= last)
        return;
    const QRectF stripe(QPointF(across(double(first) - 0.5), m_area.top()),
                        QPointF(across(double(last) - 0.5), m_area.bottom()));
    QColor tint = tokens.accent;
    tint.setAlpha(28);
    painter.fillRect(stripe.intersected(m_area), tokens.kind == ThemeKind::HighContrast
                                                     ? QBrush(tokens.line, Qt::Dense6Pattern)
                                                     : QBrush(tint));
}

void ControlPlot::paintFrame(QPainter& painter, const ThemeTokens& tokens) const
{
    const QFont strong = Theme::font(metrics::fontSmall, true);
    painter.setFont(strong);
    painter.setPen(tokens.text);
    const QRectF line(m_area.left(), m_box.top() + 2, m_area.width(), controlTop - 6);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     elided(QFontMetricsF(strong), m_series.title(), line.width()));
    painter.setFont(Theme::font(metrics::fontSmall));
    const AxisTicks ticks = roundTicks(m_range.low, m_range.high, std::max(2, int(m_area.height() / 28)));
    for (const double tick : ticks.values) {
        const double y = height(tick);
        painter.setPen(QPen(Theme::mix(tokens.surface, tokens.line, 0.7), 1));
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        painter.setPen(tokens.secondText);
        painter.drawText(QRectF(m_box.left(), y - 9, controlLeft - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
                         ticks.label(tick));
    }
    if (m_view.count() > 0) {
        paintLimitValues(painter, tokens, ticks.step);
        if (m_withAxis)
            paintNumbers(painter, tokens);
    }
    painter.setPen(QPen(tokens.line, tokens.lineWidth));
    painter.drawLine(m_area.bottomLeft(), m_area.bottomRight());
    painter.drawLine(m_area.topLeft(), m_area.bottomLeft());
}

std::vector<std::size_t> ControlPlot::numberedPoints(std::size_t most) const
{
    std::vector<std::size_t> points;
    if (m_view.count() <= most) {
        for (std::size_t point = m_view.first; point < m_view.last; ++point)
            points.push_back(point);
        return points;
    }
    const auto lowest = double(m_series.number(m_view.first));
    const auto highest = double(m_series.number(m_view.last - 1));
    for (const double tick : roundTicks(lowest, highest, int(most)).values)
        if (tick == std::floor(tick) && tick >= lowest)
            points.push_back(pointOf(qint64(tick)));
    return points;
}

/// The numbers of inspections, round ones where not each has room.
void ControlPlot::paintNumbers(QPainter& painter, const ThemeTokens& tokens) const
{
    const QFontMetricsF letters(painter.font());
    const double wide = letters.horizontalAdvance(formatCount(m_series.number(m_view.last - 1))) + 24;
    const auto most = std::clamp<std::size_t>(std::size_t(m_area.width() / wide), 1, 12);
    painter.setPen(tokens.secondText);
    double free = m_box.left();
    for (const std::size_t point : numberedPoints(most)) {
        const double x = across(double(point));
        const QString label = formatCount(m_series.number(point));
        const double half = letters.horizontalAdvance(label) / 2 + 2;
        if (x - half < free || x + half > m_box.right())
            continue;
        free = x + half + 8;
        painter.drawText(QRectF(x - half, m_area.bottom() + 5, 2 * half, 18), Qt::AlignCenter, label);
    }
}

/// Beside the last point: what the limits are, and the centre where it has room between them.
void ControlPlot::paintLimitValues(QPainter& painter, const ThemeTokens& tokens, double step) const
{
    const std::size_t last = m_view.last - 1;
    const std::size_t at = m_series.limitsAreLevel() ? m_view.first : last;
    const AxisTicks digits{{}, step / 10};
    painter.setFont(Theme::font(metrics::fontSmall));
    std::vector<double> taken;
    const auto put = [&](double value, const QColor& color) {
        const double y = height(value);
        const bool free = std::all_of(taken.begin(), taken.end(),
                                      [y](double other) { return std::abs(other - y) >= labelHeight; });
        if (value < m_range.low || value > m_range.high || !free)
            return;
        taken.push_back(y);
        painter.setPen(color);
        painter.drawText(QRectF(m_area.right() + 6, y - 9, m_box.right() - m_area.right() - 6, 18),
                         Qt::AlignLeft | Qt::AlignVCenter, digits.label(value));
    };
    put(m_series.upper(at), tokens.notValid);
    put(m_series.lower(at), tokens.notValid);
    put(m_series.centre(), tokens.secondText);
}

void ControlPlot::paintLimits(QPainter& painter, const ThemeTokens& tokens) const
{
    const QPen limit(tokens.notValid, 1.3, Qt::DashLine);
    const auto inside = [this](double y) { return std::clamp(y, m_area.top(), m_area.bottom()); };
    if (m_series.centre() >= m_range.low && m_series.centre() <= m_range.high) {
        painter.setPen(QPen(tokens.secondText, 1.2));
        const double y = height(m_series.centre());
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
    }
    painter.setPen(limit);
    QPolygonF upper, lower;
    const std::size_t stops = m_series.limitsAreLevel() ? std::min<std::size_t>(2, m_view.count())
                                                        : std::min(m_view.count(), columns());
    for (std::size_t i = 0; i < stops; ++i) {
        const std::size_t place =
            stops == 1 ? m_view.first : m_view.first + (m_view.count() - 1) * i / (stops - 1);
        // A level line goes by the point before the end, which may be a smaller subgroup.
        const std::size_t level = m_series.limitsAreLevel() ? m_view.first : place;
        const double x =
            m_series.limitsAreLevel() ? (i == 0 ? m_area.left() : m_area.right()) : across(double(place));
        upper << QPointF(x, inside(height(m_series.upper(level))));
        lower << QPointF(x, inside(height(m_series.lower(level))));
    }
    painter.drawPolyline(upper);
    painter.drawPolyline(lower);
}

void ControlPlot::paintSignal(QPainter& painter, QPointF at, const ThemeTokens& tokens) const
{
    painter.setPen(QPen(tokens.surface, 1));
    painter.setBrush(tokens.notValid);
    painter.drawPolygon(QPolygonF{{at + QPointF(0, -signalSize), at + QPointF(signalSize, 0),
                                   at + QPointF(0, signalSize), at + QPointF(-signalSize, 0)}});
}

void ControlPlot::paintPoints(QPainter& painter, const ThemeTokens& tokens) const
{
    const auto line = [&](auto value) {
        QPolygonF points;
        for (std::size_t i = m_view.first; i < m_view.last; ++i)
            if (const std::optional<double> at = value(i))
                points << QPointF(across(double(i)), height(*at));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens.model, 1.2));
        painter.drawPolyline(points);
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.model);
        for (const QPointF& at : points)
            painter.drawEllipse(at, pointSize, pointSize);
    };
    line([this](std::size_t i) { return m_series.value(i); });
    if (m_series.second(m_view.first))
        line([this](std::size_t i) { return m_series.second(i); });
    for (std::size_t i = m_view.first; i < m_view.last; ++i) {
        if (!m_series.signal(i))
            continue;
        const std::optional<double> second = m_series.second(i);
        const bool below = second && *second < m_series.lower(i);
        paintSignal(painter, below ? QPointF(across(double(i)), height(*second)) : position(i), tokens);
    }
}

void ControlPlot::paintColumns(QPainter& painter, const ThemeTokens& tokens) const
{
    for (std::size_t column = 0; column < columns(); ++column) {
        const ControlSeries::Span span = m_series.span(columnBegin(column), columnBegin(column + 1));
        if (!span.any)
            continue;
        const double x = m_area.left() + double(column);
        const double top = height(span.high), bottom = std::max(height(span.low), top + 1);
        painter.fillRect(QRectF(x, top, 1, bottom - top), tokens.model);
        if (!span.signal)
            continue;
        constexpr double tick = 7;
        painter.fillRect(QRectF(x, m_area.bottom() - tick, 1.5, tick), tokens.notValid);
    }
}

std::optional<std::size_t> ControlPlot::pointAt(QPointF at) const
{
    if (m_view.count() == 0 || !m_box.contains(at))
        return {};
    // Of what lies within reach along the axis; crowded, that is thousands: the farthest out is meant.
    const double each = m_area.width() / double(m_view.count());
    const auto middle = qint64(std::floor(placeAt(at.x())));
    const auto reach = std::min<qint64>(qint64(controlReach / each) + 1, 100'000);
    std::optional<std::size_t> nearest;
    double least = controlReach * controlReach;
    for (qint64 i = middle - reach; i <= middle + reach; ++i) {
        if (i < qint64(m_view.first) || i >= qint64(m_view.last))
            continue;
        for (const std::optional<double>& value :
             {m_series.value(std::size_t(i)), m_series.second(std::size_t(i))}) {
            if (!value)
                continue;
            const QPointF away = QPointF(across(double(i)), height(*value)) - at;
            const double distance = QPointF::dotProduct(away, away);
            if (distance < least) {
                least = distance;
                nearest = std::size_t(i);
            }
        }
    }
    return nearest;
}

} // namespace gripscope
