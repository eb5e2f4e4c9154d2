// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/histogram_plot.h"

#include "ui/charts/axis_ticks.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gripscope {

namespace {

constexpr double histogramTop = 20, histogramBottom = 22, histogramSide = 10;

/// Where everything is: along the axis in the unit shown, upwards in values a bar.
class HistogramPainting {
public:
    HistogramPainting(QPainter& painter, const ProcessCapability& capability, const ShownUnit& unit,
                      const QRectF& box, const ThemeTokens& tokens)
        : m_painter(painter), m_capability(capability), m_tokens(tokens), m_factor(unit.factor),
          m_area(box.adjusted(histogramSide, histogramTop, -histogramSide, -histogramBottom))
    {
        const ValueHistogram& bars = capability.histogram;
        m_low = m_factor * bars.first;
        m_high = m_factor * (bars.first + bars.width * double(bars.counts.size()));
        if (capability.limits)
            for (const std::optional<double>& limit : {capability.limits->lower, capability.limits->upper})
                if (limit) {
                    m_low = std::min(m_low, m_factor * *limit);
                    m_high = std::max(m_high, m_factor * *limit);
                }
        const double air = 0.04 * (m_high - m_low);
        m_low -= air;
        m_high += air;
        m_most = double(std::max<qint64>(1, std::ranges::max(bars.counts)));
    }

    void paint()
    {
        m_painter.setFont(Theme::font(metrics::fontSmall));
        paintAxis();
        paintBars();
        paintCurve();
        paintLimits();
    }

private:
    [[nodiscard]] double across(double shown) const
    {
        return m_area.left() + (shown - m_low) / (m_high - m_low) * m_area.width();
    }
    [[nodiscard]] double height(double count) const
    {
        return m_area.bottom() - count / (1.1 * m_most) * m_area.height();
    }
    void paintAxis()
    {
        m_painter.setPen(QPen(m_tokens.line, m_tokens.lineWidth));
        m_painter.drawLine(m_area.bottomLeft(), m_area.bottomRight());
        const AxisTicks ticks = roundTicks(m_low, m_high, std::max(2, int(m_area.width() / 70)));
        m_painter.setPen(m_tokens.secondText);
        for (const double tick : ticks.values) {
            const double room = std::min({30.0, across(tick) - m_area.left() + histogramSide,
                                          m_area.right() - across(tick) + histogramSide});
            m_painter.drawText(QRectF(across(tick) - room, m_area.bottom() + 3, 2 * room, 18),
                               Qt::AlignCenter, ticks.label(tick));
        }
    }
    void paintBars()
    {
        const ValueHistogram& bars = m_capability.histogram;
        for (std::size_t i = 0; i < bars.counts.size(); ++i) {
            const double left = across(m_factor * (bars.first + bars.width * double(i)));
            const double right = across(m_factor * (bars.first + bars.width * double(i + 1)));
            const double top = height(double(bars.counts[i]));
            m_painter.fillRect(QRectF(left, top, std::max(1.0, right - left - 1), m_area.bottom() - top),
                               Theme::mix(m_tokens.surface, m_tokens.model, 0.7));
        }
    }
    void paintCurve()
    {
        if (!m_capability.normal || !(m_capability.normal->overall.sigma > 0))
            return;
        const double mean = m_factor * m_capability.normal->mean;
        const double sigma = std::abs(m_factor) * m_capability.normal->overall.sigma;
        const double values = double(m_capability.normal->count);
        const double scale = values * std::abs(m_factor) * m_capability.histogram.width / sigma /
                             std::sqrt(2 * std::numbers::pi);
        QPolygonF curve;
        constexpr int steps = 80;
        for (int i = 0; i <= steps; ++i) {
            const double x = m_low + (m_high - m_low) * i / steps;
            const double z = (x - mean) / sigma;
            curve << QPointF(across(x), std::max(m_area.top(), height(scale * std::exp(-z * z / 2))));
        }
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(m_tokens.text, 1.2));
        m_painter.drawPolyline(curve);
    }
    void paintLimits()
    {
        if (!m_capability.limits)
            return;
        const auto limit = [this](const std::optional<double>& at, const QString& name) {
            if (!at)
                return;
            const double x = across(m_factor * *at);
            m_painter.setPen(QPen(m_tokens.notValid, 1.4, Qt::DashLine));
            m_painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
            m_painter.setPen(m_tokens.notValid);
            m_painter.drawText(QRectF(x - 20, m_area.top() - 18, 40, 16), Qt::AlignCenter, name);
        };
        limit(m_capability.limits->lower, QStringLiteral("L"));
        limit(m_capability.limits->upper, QStringLiteral("U"));
    }

    QPainter& m_painter;
    const ProcessCapability& m_capability;
    const ThemeTokens& m_tokens;
    double m_factor;
    QRectF m_area;
    double m_low = 0, m_high = 1, m_most = 1;
};

} // namespace

void paintHistogram(QPainter& painter, const ProcessCapability& capability, const ShownUnit& unit,
                    const QRectF& box, const ThemeTokens& tokens)
{
    if (capability.histogram.counts.empty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    HistogramPainting(painter, capability, unit, box, tokens).paint();
    painter.restore();
}

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Histogram"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void HistogramPlot::setCapability(std::optional<ProcessCapability> capability, const ShownUnit& unit)
{
    m_capability = std::move(capability);
    m_unit = unit;
    update();
}

void HistogramPlot::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    if (m_capability)
        paintHistogram(painter, *m_capability, m_unit, QRectF(rect()), tokens);
}

} // namespace gripscope
