// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/course_plot.h"

#include "ui/charts/axis_ticks.h"
#include "ui/theme/elided_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double courseText = 18; // logical pixels
constexpr double narrowMark = 4, wideMark = 7;

class CoursePainting {
public:
    CoursePainting(QPainter& painter, const QRectF& area, const CourseChart& chart, const ThemeTokens& tokens)
        : m_painter(&painter), m_chart(&chart), m_tokens(&tokens), m_area(area),
          m_small(Theme::font(metrics::fontSmall)), m_letters(m_small)
    {
        double low = 0, high = 0;
        for (const CourseChart::Point& point : chart.points) {
            low = std::min(low, point.value);
            high = std::max(high, point.value);
        }
        if (chart.change) {
            low = std::min(low, chart.change->low);
            high = std::max(high, chart.change->high);
        }
        const double air = 0.06 * std::max(0.1, high - low);
        m_range = {low - air, high + air};
    }

    void paint()
    {
        const double top = paintHead();
        if (m_chart->points.empty())
            return words(m_area.adjusted(16, 24, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_chart->empty,
                         m_tokens->secondText);
        m_plot =
            QRectF(m_area.left(), top + 4, m_area.width() - 6, m_area.bottom() - top - 4 - 2 * courseText);
        m_ticks = roundTicks(m_range.low, m_range.high, int(std::clamp(m_plot.height() / 36, 2.0, 6.0)));
        double widest = 0;
        for (const double tick : m_ticks.values)
            widest = std::max(widest, m_letters.horizontalAdvance(m_ticks.label(tick)));
        m_plot.setLeft(m_area.left() + std::ceil(widest) + 8);
        paintChangeBand();
        paintGrid();
        paintNames();
        paintPoints();
        paintChange();
    }

private:
    void words(const QRectF& box, int how, const QString& text, const QColor& color)
    {
        m_painter->setPen(color);
        m_painter->drawText(box, how, text);
    }
    double paintHead()
    {
        const QFont strong = Theme::font(metrics::fontBase, true);
        m_painter->setFont(strong);
        words(QRectF(m_area.left(), m_area.top(), m_area.width(), 20), Qt::AlignLeft | Qt::AlignVCenter,
              elided(QFontMetricsF(strong), m_chart->title, m_area.width()), m_tokens->text);
        m_painter->setFont(m_small);
        double x = m_area.left();
        double y = m_area.top() + 22;
        if (m_chart->legend.empty())
            return y;
        for (const CourseChart::Legend& one : m_chart->legend) {
            const double wide = 14 + std::min(160.0, m_letters.horizontalAdvance(one.name)) + 14;
            if (x > m_area.left() && x + wide > m_area.right()) {
                x = m_area.left();
                y += courseText;
            }
            paintMark({x + 6, y + courseText / 2}, one.place, wideMark);
            words(QRectF(x + 14, y, wide - 14, courseText), Qt::AlignLeft | Qt::AlignVCenter,
                  elided(m_letters, one.name, std::min(wide - 20, m_area.right() - x - 14)), m_tokens->text);
            x += wide;
        }
        return y + courseText;
    }
    [[nodiscard]] double step() const { return m_plot.width() / double(m_chart->points.size()); }
    [[nodiscard]] double across(double place) const { return m_plot.left() + (place + 0.5) * step(); }
    [[nodiscard]] double height(double value) const
    {
        return m_plot.bottom() - (value - m_range.low) / m_range.span() * m_plot.height();
    }
    void paintGrid()
    {
        for (const double tick : m_ticks.values) {
            m_painter->setPen(QPen(m_tokens->line, m_tokens->lineWidth));
            m_painter->drawLine(QPointF(m_plot.left(), height(tick)), QPointF(m_plot.right(), height(tick)));
            words(QRectF(m_area.left(), height(tick) - 9, m_plot.left() - m_area.left() - 6, 18),
                  Qt::AlignRight | Qt::AlignVCenter, m_ticks.label(tick), m_tokens->secondText);
        }
        m_painter->setPen(QPen(m_tokens->secondText, 1.4));
        m_painter->drawLine(QPointF(m_plot.left(), height(0)), QPointF(m_plot.right(), height(0)));
    }
    void paintNames()
    {
        double widest = 1;
        for (const QString& name : m_chart->names)
            widest = std::max(widest, m_letters.horizontalAdvance(name));
        const int every = std::max(1, int(std::ceil((widest + 10) / step())));
        for (int i = 0; i < m_chart->names.size(); i += every) {
            const double x = std::clamp(across(i), m_area.left() + widest / 2, m_area.right() - widest / 2);
            words(QRectF(x - widest / 2, m_plot.bottom() + 1, widest, courseText), Qt::AlignCenter,
                  m_chart->names[i], m_tokens->secondText);
        }
        words(QRectF(m_plot.left(), m_plot.bottom() + courseText, m_plot.width(), courseText),
              Qt::AlignCenter, elided(m_letters, m_chart->axisTitle, m_plot.width()), m_tokens->secondText);
    }
    void paintMark(QPointF at, int place, double size)
    {
        m_painter->setPen(QPen(m_tokens->surface, 0.6));
        m_painter->setBrush(Theme::typeColor(place));
        m_painter->drawEllipse(at, size / 2, size / 2);
        m_painter->setBrush(Qt::NoBrush);
    }
    void paintPoints()
    {
        const double size = std::clamp(step(), narrowMark, wideMark);
        for (std::size_t i = 0; i < m_chart->points.size(); ++i)
            paintMark({across(double(i)), height(m_chart->points[i].value)}, m_chart->points[i].place, size);
    }
    /// The edge in front of a point.
    [[nodiscard]] double edge(int before) const { return m_plot.left() + before * step(); }
    void paintChangeBand()
    {
        if (!m_chart->change)
            return;
        const CourseChart::Change& change = *m_chart->change;
        const double left = edge(change.earliest), right = std::max(left + 2, edge(change.latest));
        m_painter->fillRect(QRectF(left, m_plot.top(), right - left, m_plot.height()),
                            Theme::mix(m_tokens->surface, m_tokens->notValid, 0.18));
        m_painter->fillRect(QRectF(edge(change.before), height(change.high),
                                   m_plot.right() - edge(change.before),
                                   std::max(1.0, height(change.low) - height(change.high))),
                            Theme::mix(m_tokens->surface, m_tokens->accent, 0.22));
    }
    void paintChange()
    {
        if (!m_chart->change)
            return;
        const CourseChart::Change& change = *m_chart->change;
        const double x = edge(change.before);
        m_painter->setPen(QPen(m_tokens->notValid, 1.6, Qt::DashLine));
        m_painter->drawLine(QPointF(x, m_plot.top()), QPointF(x, m_plot.bottom()));
        m_painter->setPen(QPen(m_tokens->accent, 2));
        m_painter->drawLine(QPointF(x, height(change.value)), QPointF(m_plot.right(), height(change.value)));
        const double wide = m_letters.horizontalAdvance(change.name) + 8;
        const bool isLeft = x + wide > m_plot.right();
        const QRectF box(isLeft ? x - wide : x, m_plot.top(), wide, courseText);
        m_painter->fillRect(box, m_tokens->surface);
        words(box, Qt::AlignCenter, change.name, m_tokens->notValid);
    }

    QPainter* m_painter;
    const CourseChart* m_chart;
    const ThemeTokens* m_tokens;
    QRectF m_area, m_plot;
    QFont m_small;
    QFontMetricsF m_letters;
    AxisRange m_range;
    AxisTicks m_ticks;
};

} // namespace

void paintCourseChart(QPainter& painter, const QRectF& area, const CourseChart& chart,
                      const ThemeTokens& tokens)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    CoursePainting(painter, area, chart, tokens).paint();
    painter.restore();
}

CoursePlot::CoursePlot(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void CoursePlot::setChart(CourseChart chart)
{
    m_chart = std::move(chart);
    setAccessibleName(m_chart.title);
    update();
}

QSize CoursePlot::pictureSize() const
{
    return m_pictureSize.isValid() ? m_pictureSize : size();
}

void CoursePlot::paintPicture(QPainter& painter)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(QRect(QPoint(), pictureSize()), tokens.surface);
    paintCourseChart(painter, QRectF(QPointF(), pictureSize()).adjusted(4, 4, -4, -4), m_chart, tokens);
}

PlotTable CoursePlot::numbers() const
{
    auto names = std::make_shared<std::vector<QString>>();
    auto types = std::make_shared<std::vector<QString>>();
    auto values = std::make_shared<std::vector<double>>();
    for (std::size_t i = 0; i < m_chart.points.size(); ++i) {
        names->push_back(m_chart.names.value(int(i)));
        const auto of =
            std::ranges::find(m_chart.legend, m_chart.points[i].place, &CourseChart::Legend::place);
        types->push_back(of == m_chart.legend.end() ? QString() : of->name);
        values->push_back(m_chart.points[i].value);
    }
    return {{m_chart.axisTitle, {}, names}, {tr("Type"), {}, types}, {m_chart.title, values}};
}

void CoursePlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCourseChart(painter, QRectF(rect()), m_chart, Theme::instance().tokens());
}

} // namespace gripscope
