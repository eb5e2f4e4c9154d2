// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_chart.h"

#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
constexpr int left = 64, right = 16, top = 10, bottom = 26;
constexpr double gapSign = 8;  ///< a triangle on the upper edge
constexpr int calmFrames = 60; ///< about a second: the range shrinks only after that
} // namespace

StripChart::StripChart(LiveHistory::Channel channel, double leastSpan, QWidget* parent)
    : QWidget(parent), m_channel(channel), m_leastSpan(leastSpan), m_range{0, leastSpan}
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        m_frameValid = false;
        update();
    });
}

void StripChart::setScale(double factor, double zero)
{
    m_factor = factor;
    m_zero = zero;
    m_calm = calmFrames;
}

void StripChart::setUnit(const QString& unit)
{
    if (unit == m_unit)
        return;
    m_unit = unit;
    m_frameValid = false;
    update();
}

void StripChart::setSeconds(double seconds)
{
    m_seconds = seconds;
    m_frameValid = false;
    m_calm = calmFrames;
    update();
}

void StripChart::setStretches(std::vector<LiveHistory::Stretch> stretches)
{
    m_stretches = std::move(stretches);
    followRange();
    update();
}

void StripChart::setGaps(std::vector<LiveHistory::Gap> gaps)
{
    m_gaps = std::move(gaps);
    update();
}

int StripChart::columns() const
{
    return std::max(1, static_cast<int>(plot().width()));
}

QRectF StripChart::plot() const
{
    return QRectF(rect()).adjusted(left, top, -right, -bottom);
}

void StripChart::followRange()
{
    double low = INFINITY;
    double high = -INFINITY;
    for (const LiveHistory::Stretch& stretch : m_stretches)
        for (const PlotPoint& p : stretch) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
    m_seen.reset();
    if (!(low <= high))
        return;
    const double a = low * m_factor - m_zero;
    const double b = high * m_factor - m_zero;
    m_seen = {std::min(a, b), std::max(a, b)};
    const AxisRange wanted = roundRange(m_seen->low, m_seen->high, m_leastSpan);
    const bool outside = wanted.low < m_range.low || wanted.high > m_range.high;
    const bool smaller = wanted.span() < m_range.span() * 0.999;
    m_calm = smaller && !outside ? m_calm + 1 : 0;
    if (!outside && m_calm < calmFrames)
        return;
    m_calm = 0;
    if (wanted.low != m_range.low || wanted.high != m_range.high) {
        m_range = wanted;
        m_frameValid = false;
    }
}

void StripChart::resizeEvent(QResizeEvent*)
{
    m_frameValid = false;
}

void StripChart::paintEvent(QPaintEvent*)
{
    if (!m_frameValid || m_frame.devicePixelRatio() != devicePixelRatioF())
        paintFrame();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_frame);
    paintGaps(painter);
    paintCurve(painter);
    emit painted();
}

void StripChart::paintGaps(QPainter& painter) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    QColor tint = t.notValid;
    tint.setAlphaF(t.kind == ThemeKind::HighContrast ? 0.5F : 0.16F);
    double drawnTo = area.left() - gapSign;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    for (const LiveHistory::Gap& gap : m_gaps) {
        const double from = std::max(area.left(), area.right() + gap.begin / m_seconds * area.width());
        const double to = std::min(area.right(), area.right() + gap.end / m_seconds * area.width());
        const double middle = (from + to) / 2;
        painter.setBrush(tint);
        painter.drawRect(
            QRectF(std::min(from, middle - 0.5), area.top(), std::max(1.0, to - from), area.height()));
        if (middle - drawnTo < gapSign) // signs side by side would only be a bar
            continue;
        drawnTo = middle;
        painter.setBrush(t.notValid);
        painter.drawPolygon(QPolygonF({{middle - gapSign / 2, area.top() - gapSign},
                                       {middle + gapSign / 2, area.top() - gapSign},
                                       {middle, area.top()}}));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void StripChart::paintFrame()
{
    const qreal ratio = devicePixelRatioF();
    m_frame = QPixmap((QSizeF(size()) * ratio).toSize());
    m_frame.setDevicePixelRatio(ratio);
    m_frame.fill(Qt::transparent);
    QPainter painter(&m_frame);
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    const QColor grid = t.kind == ThemeKind::HighContrast ? Theme::mix(t.surface, t.line, 0.3) : t.line;
    painter.setFont(Theme::font(metrics::fontSmall));
    const AxisTicks y =
        roundTicks(m_range.low, m_range.high, std::clamp(static_cast<int>(area.height() / 30), 2, 8));
    for (const double value : y.values) {
        const double at =
            std::round(area.bottom() - (value - m_range.low) / m_range.span() * area.height()) + 0.5;
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        painter.setPen(t.secondText);
        const bool highest = value == y.values.back();
        painter.drawText(QRectF(0, at - 9, left - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
                         highest ? y.label(value) + QChar(0x00A0) + m_unit : y.label(value));
    }
    const double unit = m_seconds > 120 ? 60 : 1;
    const AxisTicks x =
        roundTicks(-m_seconds / unit, 0, std::clamp(static_cast<int>(area.width() / 90), 2, 11));
    for (const double value : x.values) {
        const double at = std::round(area.right() + value * unit / m_seconds * area.width()) + 0.5;
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        painter.setPen(t.secondText);
        const QString text = value == 0 ? tr("now") : x.label(value) + (unit > 1 ? tr(" min") : tr(" s"));
        const double wide = painter.fontMetrics().horizontalAdvance(text) + 2;
        // At the left edge beside the line, so that it keeps clear of the other axis.
        const double from = at - area.left() < wide / 2 ? at : std::min(at - wide / 2, width() - wide);
        painter.drawText(QRectF(from, area.bottom() + 5, wide, 16), Qt::AlignHCenter | Qt::AlignTop, text);
    }
    m_frameValid = true;
}

void StripChart::paintCurve(QPainter& painter) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    const double thick = t.curveWidth > 2 ? 2 : 1.5;
    // One wide polyline over dense data would take Qt most of a second: it unites the outline of all its
    // pieces. Tall pieces are upright bars, the others single lines; both are drawn in a few milliseconds.
    QList<QRectF> bars;
    QList<QLineF> lines;
    for (const LiveHistory::Stretch& stretch : m_stretches) {
        QPointF before;
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const PlotPoint& p = stretch[i];
            const QPointF here(area.right() + p.x / m_seconds * area.width(),
                               area.bottom() -
                                   (p.y * m_factor - m_zero - m_range.low) / m_range.span() * area.height());
            const QPointF from = i == 0 ? here : before;
            if (std::abs(here.x() - from.x()) < 1.5 && std::abs(here.y() - from.y()) > 4)
                bars << QRectF(here.x() - thick / 2, std::min(here.y(), from.y()), thick,
                               std::abs(here.y() - from.y()));
            else
                lines << QLineF(from, here);
            before = here;
        }
    }
    const QColor color = m_channel == LiveHistory::Channel::Force ? t.force : t.position;
    painter.setClipRect(area.adjusted(0, -6, 1, 6)); // roundRange() lets noise stand a little outside
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRects(bars);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color, thick, Qt::SolidLine, Qt::SquareCap));
    painter.drawLines(lines);
}

} // namespace gripscope
