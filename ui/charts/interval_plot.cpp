// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/interval_plot.h"

#include "ui/charts/axis_ticks.h"
#include "ui/theme/elided_text.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

// Logical pixels
constexpr double intervalRowHeight = 24, intervalHead = 44, intervalFoot = 22, betweenPanels = 18;
constexpr double namesShare = 0.2, narrowestNames = 70, widestNames = 180;

class IntervalPainting {
public:
    IntervalPainting(QPainter& painter, const QRectF& area, const IntervalChart& chart,
                     const ThemeTokens& tokens)
        : m_painter(&painter), m_chart(&chart), m_tokens(&tokens), m_area(area),
          m_small(Theme::font(metrics::fontSmall)), m_letters(m_small)
    {
    }

    void paint()
    {
        paintHeading();
        if (m_chart->rows.empty() || m_chart->panels.empty()) {
            words(m_area.adjusted(16, 24, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_chart->empty,
                  m_tokens->secondText);
            return;
        }
        const double names = std::clamp(namesShare * m_area.width(), narrowestNames, widestNames);
        paintNames(names);
        const auto count = double(m_chart->panels.size());
        const double wide = (m_area.width() - names - betweenPanels * count) / count;
        for (std::size_t i = 0; i < m_chart->panels.size(); ++i)
            paintPanel(i, QRectF(m_area.left() + names + betweenPanels * double(i + 1) + wide * double(i),
                                 m_area.top() + intervalHead, wide,
                                 m_area.height() - intervalHead - intervalFoot));
    }

private:
    void words(const QRectF& box, int how, const QString& text, const QColor& color)
    {
        m_painter->setPen(color);
        m_painter->drawText(box, how, text);
    }
    void paintHeading()
    {
        const QFont strong = Theme::font(metrics::fontBase, true);
        m_painter->setFont(strong);
        const QRectF line(m_area.left(), m_area.top(), m_area.width(), 20);
        words(line, Qt::AlignLeft | Qt::AlignVCenter,
              elided(QFontMetricsF(strong), m_chart->title, line.width()), m_tokens->text);
        m_painter->setFont(m_small);
    }
    [[nodiscard]] double rowStep() const
    {
        return (m_area.height() - intervalHead - intervalFoot) / double(m_chart->rows.size());
    }
    [[nodiscard]] double rowAt(std::size_t row) const
    {
        return m_area.top() + intervalHead + (double(row) + 0.5) * rowStep();
    }
    void paintNames(double wide)
    {
        for (std::size_t i = 0; i < m_chart->rows.size(); ++i) {
            const IntervalChart::Row& row = m_chart->rows[i];
            const QFont font = Theme::font(metrics::fontSmall, row.strong);
            m_painter->setFont(font);
            words(QRectF(m_area.left(), rowAt(i) - 9, wide, 18), Qt::AlignLeft | Qt::AlignVCenter,
                  elided(QFontMetricsF(font), row.name, wide), m_tokens->text);
        }
        m_painter->setFont(m_small);
    }
    /// All of a panel's intervals, and zero, with a little air.
    [[nodiscard]] AxisRange rangeOf(std::size_t panel) const
    {
        double low = 0, high = 0;
        for (const IntervalChart::Row& row : m_chart->rows)
            if (panel < row.items.size()) {
                low = std::min(low, row.items[panel].low);
                high = std::max(high, row.items[panel].high);
            }
        const double air = 0.06 * std::max(0.1, high - low);
        return {low - air, high + air};
    }
    void paintPanel(std::size_t panel, const QRectF& box)
    {
        const AxisRange range = rangeOf(panel);
        const auto across = [&](double value) {
            return box.left() + (value - range.low) / range.span() * box.width();
        };
        words(QRectF(box.left(), m_area.top() + 22, box.width(), 18), Qt::AlignLeft | Qt::AlignVCenter,
              elided(m_letters, m_chart->panels[panel].title, box.width()), m_tokens->secondText);
        const AxisTicks ticks =
            roundTicks(range.low, range.high, int(std::clamp(box.width() / 50, 2.0, 5.0)));
        for (const double tick : ticks.values) {
            m_painter->setPen(QPen(m_tokens->line, m_tokens->lineWidth));
            m_painter->drawLine(QPointF(across(tick), box.top()), QPointF(across(tick), box.bottom()));
            const double half = m_letters.horizontalAdvance(ticks.label(tick)) / 2 + 2;
            const double x = std::clamp(across(tick), box.left() + half - 10, box.right() - half + 10);
            words(QRectF(x - half, box.bottom() + 3, 2 * half, 16), Qt::AlignCenter, ticks.label(tick),
                  m_tokens->secondText);
        }
        m_painter->setPen(QPen(m_tokens->secondText, 1.4));
        m_painter->drawLine(QPointF(across(0), box.top()), QPointF(across(0), box.bottom()));
        for (std::size_t i = 0; i < m_chart->rows.size(); ++i)
            if (panel < m_chart->rows[i].items.size())
                paintItem(m_chart->rows[i], m_chart->rows[i].items[panel], rowAt(i), across);
    }
    template <typename Across>
    void paintItem(const IntervalChart::Row& row, const IntervalChart::Item& item, double y,
                   const Across& across)
    {
        const QColor color = row.strong ? m_tokens->text : Theme::typeColor(row.place);
        m_painter->setPen(QPen(color, row.strong ? 2.4 : 1.6));
        m_painter->drawLine(QPointF(across(item.low), y), QPointF(across(item.high), y));
        for (const double end : {item.low, item.high})
            m_painter->drawLine(QPointF(across(end), y - 4), QPointF(across(end), y + 4));
        const double half = row.strong ? 5 : 4;
        const QPointF at(across(item.value), y);
        m_painter->setPen(QPen(m_tokens->surface, 1));
        m_painter->setBrush(color);
        if (row.strong)
            m_painter->drawPolygon(QPolygonF({{at.x() - 1.3 * half, y},
                                              {at.x(), y - 1.1 * half},
                                              {at.x() + 1.3 * half, y},
                                              {at.x(), y + 1.1 * half}}));
        else
            m_painter->drawEllipse(at, half, half);
        m_painter->setBrush(Qt::NoBrush);
    }

    QPainter* m_painter;
    const IntervalChart* m_chart;
    const ThemeTokens* m_tokens;
    QRectF m_area;
    QFont m_small;
    QFontMetricsF m_letters;
};

} // namespace

void paintIntervalChart(QPainter& painter, const QRectF& area, const IntervalChart& chart,
                        const ThemeTokens& tokens)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    IntervalPainting(painter, area, chart, tokens).paint();
    painter.restore();
}

IntervalPlot::IntervalPlot(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void IntervalPlot::setChart(IntervalChart chart)
{
    m_chart = std::move(chart);
    setAccessibleName(m_chart.title);
    updateGeometry();
    update();
}

QSize IntervalPlot::sizeHint() const
{
    return {560, int(intervalHead + intervalFoot +
                     intervalRowHeight * std::max<double>(2, double(m_chart.rows.size())))};
}

QSize IntervalPlot::minimumSizeHint() const
{
    return {320, sizeHint().height()};
}

QSize IntervalPlot::pictureSize() const
{
    return m_pictureSize.isValid() ? m_pictureSize : size();
}

void IntervalPlot::paintPicture(QPainter& painter)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(QRect(QPoint(), pictureSize()), tokens.surface);
    paintIntervalChart(painter, QRectF(QPointF(), pictureSize()).adjusted(4, 4, -4, -4), m_chart, tokens);
}

PlotTable IntervalPlot::numbers() const
{
    auto panels = std::make_shared<std::vector<QString>>();
    auto rows = std::make_shared<std::vector<QString>>();
    std::array<std::shared_ptr<std::vector<double>>, 3> values;
    for (auto& column : values)
        column = std::make_shared<std::vector<double>>();
    for (const IntervalChart::Row& row : m_chart.rows)
        for (std::size_t i = 0; i < std::min(row.items.size(), m_chart.panels.size()); ++i) {
            panels->push_back(m_chart.panels[i].title);
            rows->push_back(row.name);
            values[0]->push_back(row.items[i].value);
            values[1]->push_back(row.items[i].low);
            values[2]->push_back(row.items[i].high);
        }
    return {{tr("Quantity"), {}, panels},
            {tr("Of"), {}, rows},
            {m_chart.title, values[0]},
            {tr("Lower limit, 95 %"), values[1]},
            {tr("Upper limit, 95 %"), values[2]}};
}

void IntervalPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintIntervalChart(painter, QRectF(rect()), m_chart, Theme::instance().tokens());
}

} // namespace gripscope
