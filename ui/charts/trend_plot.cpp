// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_plot.h"

#include "core/math/normal_interval.h"
#include "core/signal/recording/units.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/trend_figure.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int trendLeft = 66, trendRight = 14, trendTop = 24, trendBottomBare = 8,
              bottomAxis = 26; // around the plot
constexpr double trendSignSize = 8;
constexpr double trendDoubtTick = 7; ///< height, pixels
constexpr double trendReach = 16;    ///< so near a click has to be, pixels

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

bool TrendContent::gated() const
{
    return std::any_of(bands.begin(), bands.end(),
                       [](const TrendBand& band) { return band.gate.has_value(); });
}

TrendContent trendContent(std::shared_ptr<const HistoryPoints> points, const TypeModels& models, bool byTime,
                          const std::vector<GateIntervals>& gates)
{
    TrendContent content;
    content.points = std::move(points);
    content.byTime = byTime;
    for (std::size_t i = 0; i < models.types.size(); ++i) {
        const TypeModel& model = models.types[i];
        if (!content.points->si || !content.points->types.contains(model.name))
            continue;
        TrendBand& band = content.bands.emplace_back();
        band.type = model.name;
        band.sign = model.place;
        band.intervals = typeIntervals(models, model);
        if (i < gates.size())
            band.gate = gates[i];
    }
    for (const HistoryPoint& point : content.points->points) {
        content.suspects = content.suspects || point.validity == ValidityVerdict::Suspect;
        content.invalid = content.invalid || point.validity == ValidityVerdict::Invalid;
    }
    const AxisRange whole = content.whole();
    content.low = whole.low;
    content.high = whole.high;
    return content;
}

PlotTable trendNumbers(const TrendContent& content)
{
    if (!content.points)
        return {};
    const HistoryPoints& points = *content.points;
    std::vector<QString> times, types, worth;
    for (const HistoryPoint& point : points.points) {
        times.push_back(QDateTime::fromMSecsSinceEpoch(point.time_ms, Qt::UTC).toString(Qt::ISODateWithMs));
        types.push_back(point.type < 0 ? QString() : points.types[point.type]);
        worth.push_back(point.validity ? toString(*point.validity) : QString());
    }
    const auto texts = [](std::vector<QString> values) {
        return std::make_shared<const std::vector<QString>>(std::move(values));
    };
    const auto numbers = [&points](MassDampingStiffness HistoryPoint::*which, int parameter) {
        auto values = std::make_shared<std::vector<double>>();
        for (const HistoryPoint& point : points.points)
            values->push_back(component(point.*which, parameter));
        return values;
    };
    PlotTable table{{TrendWords::tr("Time (UTC)"), {}, texts(std::move(times))}};
    for (int parameter = 0; parameter < 3; ++parameter) {
        const QString unit = points.si ? u" (%1)"_s.arg(unitOf(parameter)) : QString();
        table.push_back({nameOf(parameter) + unit, numbers(&HistoryPoint::parameters, parameter)});
        table.push_back({TrendWords::tr("%1, standard error").arg(nameOf(parameter)) + unit,
                         numbers(&HistoryPoint::standardErrors, parameter)});
    }
    table.push_back({TrendWords::tr("Type"), {}, texts(std::move(types))});
    table.push_back({TrendWords::tr("Measurement"), {}, texts(std::move(worth))});
    return table;
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
        const TypeInterval& interval = band.intervals[std::size_t(m_parameter)];
        take(interval.low);
        take(interval.high);
        // One after few squeezes is so wide that all the rest would be a line.
        constexpr double widest = 4;
        const TypeInterval gate = band.gate ? (*band.gate)[std::size_t(m_parameter)] : interval;
        if (gate.high - gate.low < widest * (interval.high - interval.low)) {
            take(gate.low);
            take(gate.high);
        }
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
    paintBands(painter, tokens);
    if (m_content.points && crowded())
        paintColumns(painter, tokens);
    else if (m_content.points)
        paintPoints(painter, tokens);
    const auto [first, last] = m_content.inView();
    if (m_content.selected && *m_content.selected >= first && *m_content.selected < last) {
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
        const QColor color = typeSignColor(band.sign, tokens);
        const double high = height(interval.high * m_unit.factor), low = height(interval.low * m_unit.factor);
        const QRectF stripe =
            QRectF(QPointF(m_area.left(), high), QPointF(m_area.right(), low)).intersected(m_area);
        if (tokens.kind == ThemeKind::HighContrast)
            painter.fillRect(stripe, QBrush(color, Qt::BDiagPattern));
        else
            painter.fillRect(stripe, QColor(color.red(), color.green(), color.blue(), 36));
        paintLevel(painter, interval.mean, QPen(color, 1, Qt::DashLine));
        if (!band.gate)
            continue;
        for (const double end :
             {(*band.gate)[std::size_t(m_parameter)].low, (*band.gate)[std::size_t(m_parameter)].high})
            paintLevel(painter, end, QPen(color, 1.2, Qt::DotLine));
    }
}

void TrendPlot::paintLevel(QPainter& painter, double value, const QPen& pen) const
{
    const double y = height(value * m_unit.factor);
    if (y < m_area.top() || y > m_area.bottom())
        return;
    painter.setPen(pen);
    painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
}

void TrendPlot::paintPoints(QPainter& painter, const ThemeTokens& tokens) const
{
    const auto [first, last] = m_content.inView();
    for (std::size_t i = first; i < last; ++i) {
        const int sign = m_content.sign(m_content.points->points[i].type);
        const QPointF at = position(i);
        if (const double half = error(i); half > 0) {
            painter.setPen(QPen(typeSignColor(sign, tokens), 1.2));
            painter.drawLine(QPointF(at.x(), std::min(height(number(i) - half), m_area.bottom())),
                             QPointF(at.x(), std::max(height(number(i) + half), m_area.top())));
        }
        paintDoubt(painter, m_content.points->points[i].validity, at, trendSignSize, tokens);
        paintTypeSign(painter, sign, at, trendSignSize, tokens);
    }
}

void TrendPlot::paintColumns(QPainter& painter, const ThemeTokens& tokens) const
{
    const auto width = std::size_t(std::max(1.0, std::floor(m_area.width())));
    const std::size_t kinds = std::size_t(m_content.points->types.size()) + 1; // the last: of no type
    std::vector<TrendColumn> columns(width * kinds);
    std::vector<char> doubts(width);
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
        const std::optional<ValidityVerdict>& validity = m_content.points->points[i].validity;
        doubts[x] = char(doubts[x] != 0 || (validity && *validity != ValidityVerdict::Valid));
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const QColor color = typeSignColor(m_content.sign(kind + 1 == kinds ? -1 : int(kind)), tokens);
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
    for (std::size_t x = 0; x < width; ++x)
        if (doubts[x] != 0)
            painter.fillRect(
                QRectF(m_area.left() + double(x), m_area.bottom() - trendDoubtTick, 2, trendDoubtTick),
                tokens.suspect);
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
