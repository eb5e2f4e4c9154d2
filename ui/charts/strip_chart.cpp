// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_chart.h"

#include "ui/theme/theme.h"

#include <QColor>
#include <QPainter>
#include <QPointF>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gripscope {

namespace {

constexpr int stripLeft = 64, stripRight = 16, stripTop = 10, stripBottom = 26, stripBottomBare = 10;
constexpr int stripNamed = 32; ///< in a picture, whose name stands above
constexpr double gapSign = 8;  ///< a triangle on the upper edge
constexpr double markSign = 18;
constexpr int calmFrames = 60; ///< about a second: the range shrinks only after that
constexpr double commandedWidth = 5;
} // namespace

StripChart::StripChart(LiveHistory::Channel channel, double leastSpan, QWidget* parent)
    : QWidget(parent), m_channel(channel), m_leastSpan(leastSpan), m_range{0, leastSpan}
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::instance(), &Theme::changed, this, &StripChart::repaintFrame);
}

void StripChart::repaintFrame()
{
    m_frameValid = false;
    update();
}

void StripChart::setScale(double factor, double zero)
{
    if (factor == m_factor && zero == m_zero)
        return;
    m_factor = factor;
    m_zero = zero;
    m_calm = calmFrames;
}

void StripChart::setUnit(const QString& unit)
{
    if (unit == m_unit)
        return;
    m_unit = unit;
    repaintFrame();
}

void StripChart::setTime(double seconds, double end_s, const QString& zero)
{
    if (seconds == m_seconds && end_s == m_end_s && zero == m_zeroWord)
        return;
    m_seconds = seconds;
    m_end_s = end_s;
    m_zeroWord = zero;
    m_calm = calmFrames;
    repaintFrame();
}

void StripChart::setTimeLabels(bool on)
{
    m_timeLabels = on;
    repaintFrame();
}

void StripChart::setStretches(std::vector<LiveHistory::Stretch> stretches)
{
    m_stretches = std::move(stretches);
    followRange();
    update();
}

void StripChart::setCommanded(std::vector<LiveHistory::Stretch> stretches)
{
    m_commanded = std::move(stretches);
    update();
}

void StripChart::setGaps(std::vector<LiveHistory::Gap> gaps)
{
    m_gaps = std::move(gaps);
    update();
}

void StripChart::setMarks(std::vector<StripMark> marks)
{
    m_marks = std::move(marks);
    update();
}

int StripChart::columns() const
{
    return std::max(1, static_cast<int>(plot().width()));
}

QRectF StripChart::plot() const
{
    const bool labels = m_timeLabels || m_inPicture;
    return QRectF(QPointF(), pictureSize())
        .adjusted(stripLeft, m_inPicture ? stripNamed : stripTop, -stripRight,
                  labels ? -stripBottom : -stripBottomBare);
}

double StripChart::shareAt(double pixel) const
{
    return (pixel - plot().left()) / std::max(1.0, plot().width());
}

double StripChart::pixelAt(double x) const
{
    return plot().right() + x / m_seconds * plot().width();
}

QColor StripChart::commandedColor()
{
    const ThemeTokens& t = Theme::instance().tokens();
    return Theme::mix(t.surface, t.text, 0.5);
}

QColor StripChart::envelopeColor(const QColor& curve)
{
    return Theme::mix(Theme::instance().tokens().surface, curve, 0.3);
}

void StripChart::followRange()
{
    const auto extremes = [](const std::vector<LiveHistory::Stretch>& stretches) {
        AxisRange found{INFINITY, -INFINITY};
        for (const LiveHistory::Stretch& stretch : stretches)
            for (const LiveHistory::Point& p : stretch) {
                found.low = std::min(found.low, p.y);
                found.high = std::max(found.high, p.y);
            }
        return found;
    };
    const AxisRange measured = extremes(m_stretches);
    m_seen.reset();
    if (!(measured.low <= measured.high))
        return;
    const double a = measured.low * m_factor - m_zero;
    const double b = measured.high * m_factor - m_zero;
    m_seen = {std::min(a, b), std::max(a, b)};
    const AxisRange asked = extremes(m_commanded);
    const AxisRange wanted = roundRange(std::min(m_seen->low, asked.low * m_factor),
                                        std::max(m_seen->high, asked.high * m_factor), m_leastSpan);
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
    paintCurves(painter);
    paintMarks(painter);
    if (hasFocus()) {
        painter.setPen(QPen(Theme::instance().tokens().accent, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(plot().adjusted(0, 0, 1, 1));
    }
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
        const double from = std::max(area.left(), pixelAt(gap.begin));
        const double to = std::min(area.right(), pixelAt(gap.end));
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
    paintAxes(painter);
    m_frameValid = true;
}

void StripChart::paintAxes(QPainter& painter) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QColor grid = t.kind == ThemeKind::HighContrast ? Theme::mix(t.surface, t.line, 0.3) : t.line;
    painter.setFont(Theme::font(metrics::fontSmall));
    paintValueAxis(painter, grid);
    paintTimeAxis(painter, grid);
}

void StripChart::paintValueAxis(QPainter& painter, const QColor& grid) const
{
    const QRectF area = plot();
    const AxisTicks y =
        roundTicks(m_range.low, m_range.high, std::clamp(static_cast<int>(area.height() / 22), 2, 8));
    for (const double value : y.values) {
        const double at =
            std::round(area.bottom() - (value - m_range.low) / m_range.span() * area.height()) + 0.5;
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        painter.setPen(Theme::instance().tokens().secondText);
        const bool highest = value == y.values.back();
        painter.drawText(QRectF(0, at - 9, stripLeft - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
                         highest ? y.label(value) + QChar(0x00A0) + m_unit : y.label(value));
    }
}

void StripChart::paintTimeAxis(QPainter& painter, const QColor& grid) const
{
    const QRectF area = plot();
    const double unit = m_seconds > 120 ? 60 : 1;
    const AxisTicks x = roundTicks((m_end_s - m_seconds) / unit, m_end_s / unit,
                                   std::clamp(static_cast<int>(area.width() / 90), 2, 11));
    for (const double value : x.values) {
        const double at = std::round(pixelAt(value * unit - m_end_s)) + 0.5;
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        if (!m_timeLabels && !m_inPicture)
            continue;
        painter.setPen(Theme::instance().tokens().secondText);
        const QString number = x.label(value);
        const bool zero = std::abs(value) < x.step / 2;
        const QString text = zero ? m_zeroWord : unit > 1 ? tr("%1 min").arg(number) : tr("%1 s").arg(number);
        const double wide = painter.fontMetrics().horizontalAdvance(text) + 2;
        // At the left edge beside the line, so that it keeps clear of the other axis.
        const double from =
            at - area.left() < wide / 2 ? at : std::min(at - wide / 2, pictureSize().width() - wide);
        painter.drawText(QRectF(from, area.bottom() + 5, wide, 16), Qt::AlignHCenter | Qt::AlignTop, text);
    }
}

void StripChart::paintCurves(QPainter& painter) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    const auto place = [&](double zero) {
        return [this, area, zero](const PlotPoint& p) {
            return QPointF(pixelAt(p.x), area.bottom() - (p.y * m_factor - zero - m_range.low) /
                                                             m_range.span() * area.height());
        };
    };
    const QColor color = m_channel == LiveHistory::Channel::Force ? t.force : t.position;
    const std::vector<StripCurve> measured = stripCurves(m_stretches, place(m_zero));
    painter.setClipRect(area.adjusted(0, -6, 1, 6)); // roundRange() lets noise stand a little outside
    paintEnvelopes(painter, measured, envelopeColor(color));
    paintCommanded(painter, stripCurves(m_commanded, place(0)), commandedColor(), commandedWidth);
    paintMeasured(painter, measured, color, t.curveWidth > 2 ? 2 : 1.5);
    painter.setClipping(false);
}

void StripChart::paintMarks(QPainter& painter) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    const auto inView = [&](const StripMark& mark) {
        return pixelAt(mark.x) >= area.left() && pixelAt(mark.x) <= area.right() + 1;
    };
    for (const StripMark& mark : m_marks) {
        if (!inView(mark))
            continue;
        const double at = std::round(pixelAt(mark.x)) + 0.5;
        const bool cursor = mark.kind != StripMark::Kind::Marker;
        const bool dashed = mark.kind == StripMark::Kind::SecondCursor;
        painter.setPen(QPen(cursor ? t.accent : t.text, cursor ? t.lineWidth + 1 : t.lineWidth,
                            dashed   ? Qt::DashLine
                            : cursor ? Qt::SolidLine
                                     : Qt::DotLine));
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
    }
    // The signs after all lines: no line goes through a number.
    double labelledTo = -markSign;
    for (const StripMark& mark : m_marks) {
        const double at = pixelAt(mark.x);
        const bool cursor = mark.kind != StripMark::Kind::Marker;
        if (!inView(mark) || (!cursor && at - labelledTo < markSign)) // nor one number over another
            continue;
        labelledTo = cursor ? labelledTo : at;
        paintSign(painter, mark.label, at, cursor);
    }
}

void StripChart::paintSign(QPainter& painter, const QString& label, double at, bool cursor) const
{
    const ThemeTokens& t = Theme::instance().tokens();
    const QRectF area = plot();
    const QColor color = cursor ? t.accent : t.text;
    painter.setFont(Theme::font(metrics::fontSmall, true));
    const double wide = std::max(markSign, painter.fontMetrics().horizontalAdvance(label) + 8.0);
    const double from = std::clamp(at - wide / 2, area.left(), area.right() - wide);
    const QRectF box(from, cursor ? area.bottom() - markSign : area.top(), wide, markSign);
    painter.fillRect(box, color);
    painter.setPen(Theme::onColor(color));
    painter.drawText(box, Qt::AlignCenter, label);
}

QString StripChart::plotName() const
{
    return m_channel == LiveHistory::Channel::Force ? tr("Force") : tr("Position");
}

QString StripChart::fileName() const
{
    return m_channel == LiveHistory::Channel::Force ? QStringLiteral("live-force")
                                                    : QStringLiteral("live-position");
}

QSize StripChart::pictureSize() const
{
    return m_pictureSize.isValid() ? m_pictureSize : size();
}

void StripChart::paintPicture(QPainter& painter)
{
    const ThemeTokens& t = Theme::instance().tokens();
    m_inPicture = true;
    painter.save();
    painter.fillRect(QRectF(QPointF(), pictureSize()), t.surface);
    paintAxes(painter);
    paintGaps(painter);
    paintCurves(painter);
    paintMarks(painter);
    painter.setFont(Theme::font(metrics::fontSmall, true));
    painter.setPen(t.text);
    painter.drawText(QRectF(stripLeft, 4, plot().width(), 18), Qt::AlignLeft | Qt::AlignVCenter, plotName());
    painter.restore();
    m_inPicture = false;
}

PlotTable StripChart::numbers() const
{
    auto times = std::make_shared<std::vector<double>>(), values = std::make_shared<std::vector<double>>();
    for (const LiveHistory::Stretch& stretch : m_stretches)
        for (const LiveHistory::Point& point : stretch) {
            times->push_back(m_end_s + point.x);
            values->push_back(point.y * m_factor - m_zero);
        }
    const QString name = m_unit.isEmpty() ? plotName() : QStringLiteral("%1 (%2)").arg(plotName(), m_unit);
    return {{tr("Time (s)"), std::move(times)}, {name, std::move(values)}};
}

} // namespace gripscope
