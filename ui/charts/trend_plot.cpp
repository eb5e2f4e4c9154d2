// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_plot.h"

#include "core/math/normal_interval.h"
#include "core/signal/recording/units.h"
#include "ui/charts/axis_ticks.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int trendLeft = 66, trendRight = 14, trendTop = 24, trendBottomBare = 8,
              bottomAxis = 26; // around the plot
constexpr double trendSignSize = 8;
constexpr double trendReach = 16; ///< so near a click has to be, pixels

struct TrendWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::TrendPlot)
};

double component(const MassDampingStiffness& p, int parameter)
{
    return parameter == 0 ? p.m : parameter == 1 ? p.b : p.k;
}

QString nameOf(int parameter)
{
    return parameter == 0   ? TrendWords::tr("Mass m")
           : parameter == 1 ? TrendWords::tr("Damping b")
                            : TrendWords::tr("Stiffness k");
}

QString unitOf(int parameter)
{
    const ParameterUnits units = siParameterUnits();
    return parameter == 0 ? units.m : parameter == 1 ? units.b : units.k;
}

QPainterPath signPath(int sign, QPointF at, double size)
{
    QPainterPath path;
    const double r = size / 2;
    switch (sign % 4) {
    case 0:
        path.addEllipse(at, r, r);
        break;
    case 1:
        path.addRect(QRectF(at.x() - r * 0.9, at.y() - r * 0.9, 1.8 * r, 1.8 * r));
        break;
    case 2:
        path.addPolygon(QPolygonF{
            {at + QPointF(0, -r * 1.1), at + QPointF(r * 1.1, r * 0.9), at + QPointF(-r * 1.1, r * 0.9)}});
        break;
    default:
        path.addPolygon(QPolygonF{{at + QPointF(0, -r * 1.2), at + QPointF(r * 1.2, 0),
                                   at + QPointF(0, r * 1.2), at + QPointF(-r * 1.2, 0)}});
    }
    path.closeSubpath();
    return path;
}

QColor signColor(int sign, const ThemeTokens& tokens)
{
    return sign < 0 ? tokens.secondText : Theme::typeColor(sign);
}

/// What the points of one type span in one pixel column.
struct TrendColumn {
    double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
    int count = 0;
};

} // namespace

double TrendContent::across(std::size_t place) const
{
    return byTime ? double(points->points[place].time_ms) : double(place + 1);
}

AxisRange TrendContent::whole() const
{
    if (!points || points->points.empty())
        return {0, 1};
    const double first = across(0);
    const double last = across(points->points.size() - 1);
    const double least = byTime ? 60'000 : 1; // a minute, or one place
    const double air = std::max(least, 0.02 * (last - first));
    return {first - air, last + air};
}

std::pair<std::size_t, std::size_t> TrendContent::inView() const
{
    std::size_t first = 0, last = points ? points->points.size() : 0;
    const auto bound = [this](std::size_t from, std::size_t to, double value) {
        while (from < to) {
            const std::size_t middle = (from + to) / 2;
            if (across(middle) < value)
                from = middle + 1;
            else
                to = middle;
        }
        return from;
    };
    first = bound(first, last, low);
    return {first, bound(first, last, std::nextafter(high, INFINITY))};
}

TrendContent trendContent(std::shared_ptr<const HistoryPoints> points, const TypeModels& models, bool byTime)
{
    TrendContent content;
    content.points = std::move(points);
    content.byTime = byTime;
    int next = int(models.types.size());
    for (const QString& type : content.points->types) {
        const auto known = std::find_if(models.types.begin(), models.types.end(),
                                        [&](const TypeModel& model) { return model.name == type; });
        content.signs.push_back(known == models.types.end() ? next++ : int(known - models.types.begin()));
    }
    for (std::size_t i = 0; i < models.types.size(); ++i)
        if (content.points->si && content.points->types.contains(models.types[i].name))
            content.bands.push_back({models.types[i].name, int(i), typeIntervals(models, models.types[i])});
    const AxisRange whole = content.whole();
    content.low = whole.low;
    content.high = whole.high;
    return content;
}

void paintTypeSign(QPainter& painter, int sign, QPointF at, double size, const ThemeTokens& tokens)
{
    const QColor color = signColor(sign, tokens);
    const bool light = tokens.kind == ThemeKind::Light;
    if (sign < 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1.6));
        painter.drawEllipse(at, size / 2, size / 2);
        return;
    }
    painter.setBrush(color);
    painter.setPen(QPen(light ? tokens.surface : tokens.text, 1));
    painter.drawPath(signPath(sign, at, size));
}

void paintTypeLegend(QPainter& painter, const TrendContent& content, const QRectF& box,
                     const ThemeTokens& tokens)
{
    constexpr double sign = 16, gap = 16; // beside a name, between two entries
    painter.setFont(Theme::font(metrics::fontSmall));
    double x = box.left();
    const auto entry = [&](int which, const QString& name) {
        const double wide = painter.fontMetrics().horizontalAdvance(name);
        if (x + sign + wide > box.right())
            return;
        paintTypeSign(painter, which, QPointF(x + sign / 2 - 2, box.center().y()), 9, tokens);
        painter.setPen(tokens.text);
        painter.drawText(QRectF(x + sign, box.top(), wide + 2, box.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, name);
        x += sign + wide + gap;
    };
    for (qsizetype i = 0; i < content.points->types.size(); ++i)
        entry(content.signs[std::size_t(i)], content.points->types[i]);
    entry(-1, TrendWords::tr("of no type"));
}

TrendPlot::TrendPlot(const TrendContent& content, int parameter, const QRectF& box, bool withAxis)
    : m_content(content), m_parameter(parameter), m_box(box), m_withAxis(withAxis)
{
    m_area = box.adjusted(trendLeft, trendTop, -trendRight, withAxis ? -bottomAxis : -trendBottomBare);
    findRange();
}

void TrendPlot::findRange()
{
    double low = INFINITY, high = -INFINITY, largest = 0;
    const auto take = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
        largest = std::max(largest, std::abs(value));
    };
    const auto [first, last] = m_content.inView();
    for (std::size_t i = first; i < last; ++i)
        take(component(m_content.points->points[i].parameters, m_parameter));
    for (const TrendBand& band : m_content.bands) {
        take(band.intervals[std::size_t(m_parameter)].low);
        take(band.intervals[std::size_t(m_parameter)].high);
    }
    const bool si = !m_content.points || m_content.points->si;
    m_unit = shownUnit(si ? unitOf(m_parameter) : u"1"_s, largest);
    m_range = low <= high ? roundRange(low * m_unit.factor, high * m_unit.factor,
                                       std::max(1e-9, 1e-6 * largest * m_unit.factor))
                          : AxisRange{0, 1};
}

double TrendPlot::number(std::size_t place) const
{
    return m_unit.factor * component(m_content.points->points[place].parameters, m_parameter);
}

double TrendPlot::error(std::size_t place) const
{
    return normal95 * m_unit.factor * component(m_content.points->points[place].standardErrors, m_parameter);
}

double TrendPlot::height(double value) const
{
    return m_area.bottom() - (value - m_range.low) / m_range.span() * m_area.height();
}

QPointF TrendPlot::position(std::size_t place) const
{
    const double share = (m_content.across(place) - m_content.low) / (m_content.high - m_content.low);
    return {m_area.left() + share * m_area.width(), height(number(place))};
}

double TrendPlot::valueAt(double x) const
{
    return m_content.low + (x - m_area.left()) / m_area.width() * (m_content.high - m_content.low);
}

bool TrendPlot::crowded() const
{
    const auto [first, last] = m_content.inView();
    return double(last - first) > m_area.width() / 2;
}

void TrendPlot::paint(QPainter& painter, const ThemeTokens& tokens) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(painter, tokens);
    painter.setClipRect(m_area.adjusted(0, -1, 1, 1));
    paintBands(painter, tokens);
    if (m_content.points && crowded())
        paintColumns(painter, tokens);
    else if (m_content.points)
        paintPoints(painter, tokens);
    if (m_content.selected && *m_content.selected < m_content.points->points.size()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens.accent, 2.5));
        painter.drawEllipse(position(*m_content.selected), trendSignSize, trendSignSize);
    }
    painter.restore();
}

void TrendPlot::paintFrame(QPainter& painter, const ThemeTokens& tokens) const
{
    painter.setFont(Theme::font(metrics::fontSmall, true));
    painter.setPen(tokens.text);
    const QString unit = m_unit.unit.isEmpty() ? QString() : u" (%1)"_s.arg(m_unit.unit);
    painter.drawText(QRectF(m_area.left(), m_box.top() + 2, m_area.width(), trendTop - 6),
                     Qt::AlignLeft | Qt::AlignVCenter, nameOf(m_parameter) + unit);
    painter.setFont(Theme::font(metrics::fontSmall));
    const AxisTicks ticks = roundTicks(m_range.low, m_range.high, std::max(3, int(m_area.height() / 28)));
    for (const double tick : ticks.values) {
        const double y = height(tick);
        painter.setPen(QPen(Theme::mix(tokens.surface, tokens.line, 0.7), 1));
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        painter.setPen(tokens.secondText);
        painter.drawText(QRectF(m_box.left(), y - 9, trendLeft - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
                         ticks.label(tick));
    }
    paintAxis(painter, tokens);
    painter.setPen(QPen(tokens.line, tokens.lineWidth));
    painter.drawLine(m_area.bottomLeft(), m_area.bottomRight());
    painter.drawLine(m_area.topLeft(), m_area.bottomLeft());
}

void TrendPlot::paintAxis(QPainter& painter, const ThemeTokens& tokens) const
{
    std::vector<TimeTick> ticks;
    const int most = std::max(2, int(m_area.width() / 100));
    if (m_content.byTime) {
        ticks = timeTicks(m_content.low, m_content.high, most);
    } else {
        const AxisTicks places = roundTicks(std::max(0.0, m_content.low), m_content.high, most);
        for (const double place : places.values)
            if (place == std::floor(place))
                ticks.push_back({place, places.label(place)});
    }
    for (const TimeTick& tick : ticks) {
        const double x =
            m_area.left() + (tick.at - m_content.low) / (m_content.high - m_content.low) * m_area.width();
        if (x < m_area.left() || x > m_area.right())
            continue;
        painter.setPen(QPen(Theme::mix(tokens.surface, tokens.line, 0.7), 1));
        painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
        const double room = std::min({50.0, x - m_box.left(), m_box.right() - x});
        if (!m_withAxis || room < 24)
            continue;
        painter.setPen(tokens.secondText);
        painter.drawText(QRectF(x - room, m_area.bottom() + 5, 2 * room, 18), Qt::AlignCenter, tick.label);
    }
}

void TrendPlot::paintBands(QPainter& painter, const ThemeTokens& tokens) const
{
    for (const TrendBand& band : m_content.bands) {
        const TypeInterval& interval = band.intervals[std::size_t(m_parameter)];
        const QColor color = signColor(band.sign, tokens);
        const double high = height(interval.high * m_unit.factor), low = height(interval.low * m_unit.factor);
        const QRectF stripe(QPointF(m_area.left(), high), QPointF(m_area.right(), low));
        if (tokens.kind == ThemeKind::HighContrast)
            painter.fillRect(stripe, QBrush(color, Qt::BDiagPattern));
        else
            painter.fillRect(stripe, QColor(color.red(), color.green(), color.blue(), 36));
        painter.setPen(QPen(color, 1, Qt::DashLine));
        const double mean = height(interval.mean * m_unit.factor);
        painter.drawLine(QPointF(m_area.left(), mean), QPointF(m_area.right(), mean));
    }
}

void TrendPlot::paintPoints(QPainter& painter, const ThemeTokens& tokens) const
{
    const auto [first, last] = m_content.inView();
    for (std::size_t i = first; i < last; ++i) {
        const int type = m_content.points->points[i].type;
        const int sign = type < 0 ? -1 : m_content.signs[std::size_t(type)];
        const QPointF at = position(i);
        if (const double half = error(i); half > 0) {
            painter.setPen(QPen(signColor(sign, tokens), 1.2));
            painter.drawLine(QPointF(at.x(), height(number(i) - half)),
                             QPointF(at.x(), height(number(i) + half)));
        }
        paintTypeSign(painter, sign, at, trendSignSize, tokens);
    }
}

void TrendPlot::paintColumns(QPainter& painter, const ThemeTokens& tokens) const
{
    const auto width = std::size_t(std::max(1.0, std::floor(m_area.width())));
    const std::size_t kinds = m_content.signs.size() + 1; // the last: of no type
    std::vector<TrendColumn> columns(width * kinds);
    const auto [first, last] = m_content.inView();
    for (std::size_t i = first; i < last; ++i) {
        const double share = (m_content.across(i) - m_content.low) / (m_content.high - m_content.low);
        const std::size_t x = std::min(width - 1, std::size_t(share * double(width)));
        const int type = m_content.points->points[i].type;
        TrendColumn& column = columns[(type < 0 ? kinds - 1 : std::size_t(type)) * width + x];
        const double value = number(i);
        column.low = std::min(column.low, value);
        column.high = std::max(column.high, value);
        column.sum += value;
        ++column.count;
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const QColor color = signColor(kind + 1 == kinds ? -1 : m_content.signs[kind], tokens);
        QColor faint = color;
        faint.setAlpha(tokens.kind == ThemeKind::HighContrast ? 255 : 110);
        for (std::size_t x = 0; x < width; ++x) {
            const TrendColumn& column = columns[kind * width + x];
            if (column.count == 0)
                continue;
            const double at = m_area.left() + double(x) + 0.5;
            const double upper = height(column.high), lower = std::max(height(column.low), upper + 1);
            painter.fillRect(QRectF(at - 0.5, upper, 1, lower - upper), faint);
            painter.fillRect(QRectF(at - 1, height(column.sum / column.count) - 1, 2, 2), color);
        }
    }
}

std::optional<std::size_t> TrendPlot::pointAt(QPointF at) const
{
    std::optional<std::size_t> nearest;
    double least = trendReach * trendReach;
    const auto [first, last] = m_content.inView();
    for (std::size_t i = first; i < last; ++i) {
        const QPointF away = position(i) - at;
        const double distance = QPointF::dotProduct(away, away);
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

} // namespace gripscope
