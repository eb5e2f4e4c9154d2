// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/axis_ticks.h"
#include "ui/charts/study_charts.h"
#include "ui/theme/elided_text.h"

#include <QFontInfo>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double markSize = 7;         // pixels across
constexpr double lineOfText = 18;      // pixels
constexpr double barsOfCategory = 0.7; // of its width

struct CategoryRange {
    double low = 0, high = 1;
};

CategoryRange rangeOf(const CategoryChart& chart)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto take = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const CategoryChart::Series& series : chart.series)
        for (const QPointF& point : series.points)
            take(point.y());
    for (const CategoryChart::Level& level : chart.levels)
        take(level.value);
    if (chart.fromZero)
        take(0);
    if (chart.top)
        return {std::min(low, 0.0), std::max(*chart.top, high)};
    if (!(high > low))
        return {low - 0.5 * std::max(1e-12, std::abs(low)), low + 0.5 * std::max(1e-12, std::abs(low))};
    const double air = 0.06 * (high - low);
    return {chart.fromZero && low >= 0 ? 0 : low - air, high + air};
}

QPainterPath markShape(QPointF at, int shape, double size)
{
    QPainterPath path;
    const double half = size / 2;
    switch (shape) {
    case 0:
        path.addEllipse(at, half, half);
        break;
    case 1:
        path.addRect(QRectF(at.x() - 0.9 * half, at.y() - 0.9 * half, 1.8 * half, 1.8 * half));
        break;
    case 2:
        path.addPolygon(QPolygonF({{at.x(), at.y() - 1.1 * half},
                                   {at.x() + 1.1 * half, at.y() + 0.9 * half},
                                   {at.x() - 1.1 * half, at.y() + 0.9 * half}}));
        path.closeSubpath();
        break;
    default:
        path.addPolygon(QPolygonF({{at.x(), at.y() - 1.3 * half},
                                   {at.x() + 1.3 * half, at.y()},
                                   {at.x(), at.y() + 1.3 * half},
                                   {at.x() - 1.3 * half, at.y()}}));
        path.closeSubpath();
    }
    return path;
}

/// One painting of a chart: where things are, and in which order they are drawn.
class CategoryPainting {
public:
    CategoryPainting(QPainter& painter, const QRectF& area, const CategoryChart& chart,
                     const ThemeTokens& tokens)
        : m_painter(&painter), m_chart(&chart), m_tokens(&tokens), m_area(area),
          m_small(Theme::font(metrics::fontSmall)), m_letters(m_small), m_range(rangeOf(chart))
    {
    }

    void paint()
    {
        double top = paintTitle();
        if (m_chart->categories.isEmpty() || m_chart->series.empty())
            return paintEmpty();
        top = paintLegend(top);
        m_plot = QRectF(m_area.left(), top + 6, m_area.width(), m_area.bottom() - top - 6);
        m_ticks = roundTicks(m_range.low, m_range.high, int(std::clamp(m_plot.height() / 40, 2.0, 6.0)));
        double widest = 0;
        for (const double tick : m_ticks.values)
            widest = std::max(widest, m_letters.horizontalAdvance(m_ticks.label(tick)));
        m_plot.setLeft(m_area.left() + std::ceil(widest) + 8);
        const bool titled = !m_chart->groups.empty() || !m_chart->categoryTitle.isEmpty() || wrapsNames();
        m_plot.setBottom(m_area.bottom() - lineOfText - (titled ? lineOfText : 0));
        m_plot.setRight(m_area.right() - levelRoom());
        paintGrid();
        paintCategories();
        paintLevels();
        for (std::size_t i = 0; i < m_chart->series.size(); ++i)
            paintSeries(m_chart->series[i]);
    }

private:
    [[nodiscard]] double step() const { return m_plot.width() / double(m_chart->categories.size()); }
    /// Nothing stands below the names, so that they may have two lines.
    [[nodiscard]] bool wrapsNames() const
    {
        return m_chart->groups.empty() && m_chart->categoryTitle.isEmpty() && m_chart->categories.size() <= 8;
    }
    [[nodiscard]] double across(double category) const { return m_plot.left() + (category + 0.5) * step(); }
    [[nodiscard]] double height(double value) const
    {
        return m_plot.bottom() - (value - m_range.low) / (m_range.high - m_range.low) * m_plot.height();
    }
    void text(const QRectF& box, int how, const QString& words, const QColor& color)
    {
        m_painter->setPen(color);
        m_painter->drawText(box, how, words);
    }
    double paintTitle()
    {
        const QFont strong = Theme::font(metrics::fontBase, true);
        m_painter->setFont(strong);
        const QRectF line(m_area.left(), m_area.top(), m_area.width(), 20);
        text(line, Qt::AlignLeft | Qt::AlignVCenter,
             elided(QFontMetricsF(strong), m_chart->title, line.width()), m_tokens->text);
        m_painter->setFont(m_small);
        return line.bottom();
    }
    void paintEmpty()
    {
        text(m_area.adjusted(16, 24, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_chart->empty,
             m_tokens->secondText);
    }
    double paintLegend(double top)
    {
        double x = m_area.left();
        double y = top + 2;
        bool any = false;
        for (const CategoryChart::Series& series : m_chart->series) {
            if (series.name.isEmpty())
                continue;
            const double wide = 16 + m_letters.horizontalAdvance(series.name) + 14;
            if (any && x + wide > m_area.right()) {
                x = m_area.left();
                y += lineOfText;
            }
            any = true;
            const QPointF sign(x + 6, y + lineOfText / 2);
            if (series.marks == CategoryChart::Marks::Bars)
                m_painter->fillRect(QRectF(sign.x() - 5, sign.y() - 5, 10, 10), barBrush(series.place));
            else
                paintMark(sign, series.place);
            text(QRectF(x + 16, y, std::min(wide, m_area.right() - x - 16), lineOfText),
                 Qt::AlignLeft | Qt::AlignVCenter, elided(m_letters, series.name, m_area.right() - x - 16),
                 m_tokens->text);
            x += wide;
        }
        return any ? y + lineOfText : top;
    }
    [[nodiscard]] double levelRoom() const
    {
        double widest = 0;
        for (const CategoryChart::Level& level : m_chart->levels)
            widest = std::max(widest, m_letters.horizontalAdvance(level.name));
        return widest > 0 ? std::ceil(widest) + 6 : 4;
    }
    void paintGrid()
    {
        for (const double tick : m_ticks.values) {
            const double y = std::round(height(tick)) + 0.5;
            m_painter->setPen(QPen(m_tokens->line, m_tokens->lineWidth));
            m_painter->drawLine(QPointF(m_plot.left(), y), QPointF(m_plot.right(), y));
            text(QRectF(m_area.left(), y - 9, m_plot.left() - m_area.left() - 6, 18),
                 Qt::AlignRight | Qt::AlignVCenter, m_ticks.label(tick), m_tokens->secondText);
        }
    }
    /// Letters as small as the longest word needs: within a word no line is broken, and none is cut.
    void paintWrappedNames(double y)
    {
        double longestWord = 1;
        for (const QString& name : m_chart->categories)
            for (const QString& word : name.split(u' '))
                longestWord = std::max(longestWord, m_letters.horizontalAdvance(word));
        const QFont usual = m_painter->font();
        if (const double room = step() + 2; longestWord > room) {
            QFont smaller = usual;
            smaller.setPixelSize(std::max(8, int(QFontInfo(usual).pixelSize() * room / longestWord)));
            m_painter->setFont(smaller);
        }
        for (int i = 0; i < m_chart->categories.size(); ++i)
            text(QRectF(across(i) - step() / 2 - 2, y, step() + 4, 2 * lineOfText),
                 Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_chart->categories[i],
                 m_tokens->secondText);
        m_painter->setFont(usual);
    }
    void paintCategories()
    {
        // Where names would run into one another, every second, third ... is written.
        double widest = 0;
        for (const QString& name : m_chart->categories)
            widest = std::max(widest, m_letters.horizontalAdvance(name));
        const bool few = m_chart->categories.size() <= 8;
        const int every = few ? 1 : std::max(1, int(std::ceil((widest + 6) / step())));
        const double y = m_plot.bottom() + 1;
        int first = 0;
        const auto name = [&](int from, int count) {
            for (int i = 0; i < count; i += every)
                text(QRectF(across(from + i) - std::max(step(), widest) / 2, y, std::max(step(), widest),
                            lineOfText),
                     Qt::AlignHCenter | Qt::AlignVCenter,
                     few ? elided(m_letters, m_chart->categories[from + i], step() - 4)
                         : m_chart->categories[from + i],
                     m_tokens->secondText);
        };
        if (wrapsNames())
            paintWrappedNames(y);
        else if (m_chart->groups.empty())
            name(0, int(m_chart->categories.size()));
        for (const CategoryChart::Group& group : m_chart->groups) {
            name(first, group.categories);
            const QRectF box(across(first) - step() / 2, y + lineOfText, group.categories * step(),
                             lineOfText);
            text(box, Qt::AlignHCenter | Qt::AlignVCenter, elided(m_letters, group.name, box.width() - 4),
                 m_tokens->text);
            if (first > 0) {
                m_painter->setPen(QPen(m_tokens->line, 1));
                m_painter->drawLine(QPointF(box.left(), m_plot.top()), box.bottomLeft());
            }
            first += group.categories;
        }
        if (m_chart->groups.empty() && !m_chart->categoryTitle.isEmpty())
            text(QRectF(m_plot.left(), y + lineOfText, m_plot.width(), lineOfText),
                 Qt::AlignHCenter | Qt::AlignVCenter,
                 elided(m_letters, m_chart->categoryTitle, m_plot.width()), m_tokens->secondText);
    }
    void paintLevels()
    {
        for (const CategoryChart::Level& level : m_chart->levels) {
            const QColor color = level.limit ? m_tokens->notValid : m_tokens->secondText;
            const double y = height(level.value);
            m_painter->setPen(QPen(color, 1.2, level.limit ? Qt::DashLine : Qt::SolidLine));
            m_painter->drawLine(QPointF(m_plot.left(), y), QPointF(m_plot.right(), y));
            text(QRectF(m_plot.right() + 4, y - 9, m_area.right() - m_plot.right() - 4, 18),
                 Qt::AlignLeft | Qt::AlignVCenter, level.name, color);
        }
    }
    [[nodiscard]] QBrush barBrush(int place) const
    {
        if (m_tokens->kind == ThemeKind::HighContrast && place % 2 == 1)
            return QBrush(m_tokens->text, Qt::BDiagPattern);
        return place % 2 == 0 ? m_tokens->accent : Theme::mix(m_tokens->accent, m_tokens->surface, 0.55);
    }
    void paintMark(QPointF at, int place)
    {
        m_painter->setPen(QPen(m_tokens->kind == ThemeKind::Light ? m_tokens->surface : m_tokens->text, 0.8));
        m_painter->setBrush(Theme::typeColor(place));
        m_painter->drawPath(markShape(at, Theme::typeShape(place), markSize));
        m_painter->setBrush(Qt::NoBrush);
    }
    void paintBars(const CategoryChart::Series& series)
    {
        int bars = 0, own = 0;
        for (const CategoryChart::Series& other : m_chart->series) {
            if (&other == &series)
                own = bars;
            bars += other.marks == CategoryChart::Marks::Bars ? 1 : 0;
        }
        const double wide = std::min(36.0, barsOfCategory * step() / bars);
        for (const QPointF& point : series.points) {
            const double left = across(point.x()) + (own - bars / 2.0) * wide;
            const QRectF bar(left, height(point.y()), wide - 1, height(0) - height(point.y()));
            m_painter->fillRect(bar, barBrush(series.place));
        }
    }
    void paintSeries(const CategoryChart::Series& series)
    {
        if (series.marks == CategoryChart::Marks::Bars)
            return paintBars(series);
        QPolygonF line;
        for (const QPointF& point : series.points)
            line << QPointF(across(point.x()), height(point.y()));
        if (series.marks == CategoryChart::Marks::Lines) {
            m_painter->setPen(QPen(series.place < 0 ? m_tokens->secondText : Theme::typeColor(series.place),
                                   m_tokens->curveWidth));
            m_painter->drawPolyline(line);
        }
        if (series.place >= 0)
            for (const QPointF& at : line)
                paintMark(at, series.place);
    }

    QPainter* m_painter;
    const CategoryChart* m_chart;
    const ThemeTokens* m_tokens;
    QRectF m_area, m_plot;
    QFont m_small;
    QFontMetricsF m_letters;
    CategoryRange m_range;
    AxisTicks m_ticks;
};

} // namespace

void paintCategoryChart(QPainter& painter, const QRectF& area, const CategoryChart& chart,
                        const ThemeTokens& tokens)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    CategoryPainting(painter, area, chart, tokens).paint();
    painter.restore();
}

CategoryPlot::CategoryPlot(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void CategoryPlot::setChart(CategoryChart chart)
{
    m_chart = std::move(chart);
    setAccessibleName(m_chart.title);
    update();
}

QSize CategoryPlot::pictureSize() const
{
    return m_pictureSize.isValid() ? m_pictureSize : size();
}

void CategoryPlot::paintPicture(QPainter& painter)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(QRect(QPoint(), pictureSize()), tokens.surface);
    paintCategoryChart(painter, QRectF(QPointF(), pictureSize()).adjusted(4, 4, -4, -4), m_chart, tokens);
}

PlotTable CategoryPlot::numbers() const
{
    auto names = std::make_shared<std::vector<QString>>();
    auto categories = std::make_shared<std::vector<QString>>();
    auto values = std::make_shared<std::vector<double>>();
    for (const CategoryChart::Series& series : m_chart.series)
        for (const QPointF& point : series.points) {
            names->push_back(series.name);
            categories->push_back(m_chart.categories.value(int(std::lround(point.x()))));
            values->push_back(point.y());
        }
    return {{tr("Series"), {}, names}, {tr("Place"), {}, categories}, {m_chart.title, values}};
}

void CategoryPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCategoryChart(painter, QRectF(rect()), m_chart, Theme::instance().tokens());
}

} // namespace gripscope
