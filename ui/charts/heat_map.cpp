// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/heat_map.h"

#include "ui/format/number_format.h"
#include "ui/models/space_clustering.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString planeWord(const char* text)
{
    return QCoreApplication::translate("gripscope::MapPlanes", text);
}

MapPlane plane(const QString& title, const QString& meaning, const QString& unit,
               const Eigen::MatrixXd& values)
{
    MapPlane result;
    result.title = title;
    result.meaning = meaning;
    result.scale = axisScale(title, unit, values.minCoeff(), values.maxCoeff());
    result.scale.low = values.minCoeff();
    result.scale.high = values.maxCoeff();
    result.values = values;
    return result;
}

/// "3 squeezes: 2 of A, 1 of B" for every unit.
std::vector<QString> squeezesOfUnits(const TypeSpace& space, const SelfOrganizingMapResult& map)
{
    std::vector<std::map<int, int>> counts(map.hits.size());
    for (std::size_t i = 0; i < map.unitOfItem.size(); ++i)
        ++counts[std::size_t(map.unitOfItem[i])][space.squeezes[i].type];
    std::vector<QString> texts;
    texts.reserve(counts.size());
    for (std::size_t unit = 0; unit < counts.size(); ++unit) {
        QStringList types;
        for (const auto& [type, count] : counts[unit])
            types << planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "%1 of %2"))
                         .arg(formatCount(count), space.types[type]);
        texts.push_back(types.isEmpty()
                            ? planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "No squeezes here"))
                            : planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Squeezes: %1"))
                                  .arg(types.join(u", "_s)));
    }
    return texts;
}

} // namespace

QString MapPlanes::describe(int unit, int plane) const
{
    if (unit < 0 || unit >= rows * columns)
        return {};
    const MapPlane& one = planes[std::size_t(plane)];
    return u"%1: %2\n%3\n%4"_s.arg(
        one.title, one.scale.valueText(one.values(unit / columns, unit % columns)),
        squeezes[std::size_t(unit)],
        planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Row %1, column %2 of the map, cluster %3"))
            .arg(unit / columns + 1)
            .arg(unit % columns + 1)
            .arg(groups[std::size_t(unit)] + 1));
}

MapPlanes mapPlanes(const TypeSpace& space, const SpaceClustering& clustering)
{
    const auto* map = std::get_if<SelfOrganizingMapResult>(&clustering.outcome.details);
    if (!map || map->rows * map->columns == 0)
        return {};
    SelfOrganizingMapResult inUnits = *map;
    inUnits.weights = clustering.outcome.transform.undo(map->weights);
    MapPlanes result;
    result.rows = map->rows;
    result.columns = map->columns;
    result.hits = map->hits;
    result.groups = map->groupOfUnit;
    result.squeezes = squeezesOfUnits(space, *map);
    result.planes = {
        plane(planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "U-matrix")),
              planeWord(
                  QT_TRANSLATE_NOOP("gripscope::MapPlanes",
                                    "How far each unit is from its neighbours, in the scaled space. Bright "
                                    "ridges are borders between clusters.")),
              u"1"_s, map->uMatrix()),
        plane(planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Mass m")),
              planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The mass that each unit stands for")),
              space.units.m, inUnits.componentPlane(0)),
        plane(planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Damping b")),
              planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The damping that each unit stands for")),
              space.units.b, inUnits.componentPlane(1)),
        plane(planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "Stiffness k")),
              planeWord(QT_TRANSLATE_NOOP("gripscope::MapPlanes", "The stiffness that each unit stands for")),
              space.units.k, inUnits.componentPlane(2))};
    return result;
}

QColor scaleColor(double share)
{
    static constexpr std::array<QRgb, 10> colors{0xff00224e, 0xff123570, 0xff3b496c, 0xff575d6d, 0xff707173,
                                                 0xff8a8678, 0xffa59c74, 0xffc3b369, 0xffe1cc55, 0xfffee838};
    const double at = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * (colors.size() - 1);
    const auto below = std::min(std::size_t(at), colors.size() - 2);
    return Theme::mix(QColor(colors[below]), QColor(colors[below + 1]), at - double(below));
}

namespace {
constexpr double titleHeight = 20, colorBarHeight = 6, numbersHeight = 18, heatGap = 4;
} // namespace

HeatMap::HeatMap(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, [this] { update(); });
}

void HeatMap::setPlane(const MapPlanes& map, int plane, bool hits)
{
    m_map = map;
    m_plane = plane;
    m_hits = hits;
    m_marked = -1;
    if (!empty()) {
        const AxisScale& scale = this->plane().scale;
        setAccessibleName(this->plane().title);
        setAccessibleDescription(
            tr("%1 From %2 to %3.")
                .arg(this->plane().meaning, scale.valueText(scale.low), scale.valueText(scale.high)));
    }
    update();
}

void HeatMap::setMarked(int unit)
{
    if (unit == m_marked)
        return;
    m_marked = unit;
    update();
}

QRectF HeatMap::grid() const
{
    const QRectF area = QRectF(QPointF(), pictureSize())
                            .adjusted(2, titleHeight, -2, -(heatGap + colorBarHeight + numbersHeight));
    const double side = std::max(1.0, std::floor(std::min(area.width() / std::max(1, m_map.columns),
                                                          area.height() / std::max(1, m_map.rows))));
    QRectF grid(0, 0, side * m_map.columns, side * m_map.rows);
    grid.moveCenter(area.center());
    grid.moveTopLeft(QPointF(std::round(grid.left()), std::round(grid.top())));
    return grid;
}

QRectF HeatMap::cell(int unit) const
{
    if (empty() || unit < 0 || unit >= m_map.rows * m_map.columns)
        return {};
    const QRectF all = grid();
    const double side = all.width() / m_map.columns;
    return {all.left() + side * (unit % m_map.columns), all.top() + side * (unit / m_map.columns), side,
            side};
}

int HeatMap::unitAt(QPointF position) const
{
    const QRectF all = grid();
    if (empty() || !all.contains(position))
        return -1;
    const double side = all.width() / m_map.columns;
    const int row = std::min(int((position.y() - all.top()) / side), m_map.rows - 1);
    const int column = std::min(int((position.x() - all.left()) / side), m_map.columns - 1);
    return row * m_map.columns + column;
}

QColor HeatMap::color(int unit) const
{
    const AxisScale& scale = plane().scale;
    const double value = plane().values(unit / m_map.columns, unit % m_map.columns);
    return scaleColor(scale.high > scale.low ? scale.unitPosition(value) : 0.5);
}

QString HeatMap::tip(int unit) const
{
    return empty() ? QString() : m_map.describe(unit, m_plane);
}

void HeatMap::point(int unit)
{
    setMarked(unit);
    emit pointedAt(unit);
}

void HeatMap::mouseMoveEvent(QMouseEvent* event)
{
    const int unit = unitAt(event->position());
    if (unit != m_marked)
        point(unit);
    if (unit >= 0)
        QToolTip::showText(event->globalPosition().toPoint(), tip(unit), this, cell(unit).toRect());
}

void HeatMap::leaveEvent(QEvent*)
{
    if (!hasFocus())
        point(-1);
}

void HeatMap::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    point(-1);
}

void HeatMap::keyPressEvent(QKeyEvent* event)
{
    if (empty())
        return QWidget::keyPressEvent(event);
    int row = std::max(0, m_marked) / m_map.columns;
    int column = std::max(0, m_marked) % m_map.columns;
    switch (event->key()) {
    case Qt::Key_Left:
        --column;
        break;
    case Qt::Key_Right:
        ++column;
        break;
    case Qt::Key_Up:
        --row;
        break;
    case Qt::Key_Down:
        ++row;
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    if (m_marked < 0)
        row = column = 0;
    point(std::clamp(row, 0, m_map.rows - 1) * m_map.columns + std::clamp(column, 0, m_map.columns - 1));
    QToolTip::showText(mapToGlobal(cell(m_marked).bottomRight().toPoint()), tip(m_marked), this);
}

void HeatMap::paintCells(QPainter& painter) const
{
    for (int unit = 0; unit < m_map.rows * m_map.columns; ++unit)
        painter.fillRect(cell(unit), color(unit));
}

void HeatMap::paintBorders(QPainter& painter) const
{
    QList<QLineF> lines;
    for (int unit = 0; unit < m_map.rows * m_map.columns; ++unit) {
        const QRectF here = cell(unit);
        const int group = m_map.groups[std::size_t(unit)];
        if ((unit + 1) % m_map.columns != 0 && m_map.groups[std::size_t(unit) + 1] != group)
            lines << QLineF(here.topRight(), here.bottomRight());
        if (unit + m_map.columns < m_map.rows * m_map.columns &&
            m_map.groups[std::size_t(unit + m_map.columns)] != group)
            lines << QLineF(here.bottomLeft(), here.bottomRight());
    }
    // Black about white: it stands out from every colour of the scale.
    for (const auto& [width, ink] : {std::pair(3.0, QColor(Qt::black)), std::pair(1.0, QColor(Qt::white))}) {
        painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::SquareCap));
        painter.drawLines(lines);
    }
}

void HeatMap::paintHits(QPainter& painter) const
{
    const int most = *std::max_element(m_map.hits.begin(), m_map.hits.end());
    painter.setPen(QPen(Qt::black, 1));
    painter.setBrush(Qt::white);
    for (int unit = 0; unit < m_map.rows * m_map.columns; ++unit) {
        const int hits = m_map.hits[std::size_t(unit)];
        const QRectF here = cell(unit);
        const double radius = 0.38 * here.width() * std::sqrt(double(hits) / most);
        if (hits > 0)
            painter.drawEllipse(here.center(), std::max(1.5, radius), std::max(1.5, radius));
    }
}

void HeatMap::paintBar(QPainter& painter) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const AxisScale& scale = plane().scale;
    const QSizeF all = pictureSize();
    const QRectF bar(2, all.height() - numbersHeight - colorBarHeight, all.width() - 4, colorBarHeight);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (int stop = 0; stop <= 9; ++stop)
        gradient.setColorAt(stop / 9.0, scaleColor(stop / 9.0));
    painter.fillRect(bar, gradient);
    painter.setPen(tokens.secondText);
    painter.setFont(Theme::font(metrics::fontSmall));
    const QRectF numbers(2, bar.bottom(), all.width() - 4, numbersHeight);
    painter.drawText(numbers, Qt::AlignLeft | Qt::AlignVCenter, scale.numberText(scale.low));
    painter.drawText(numbers, Qt::AlignHCenter | Qt::AlignVCenter, scale.unit);
    painter.drawText(numbers, Qt::AlignRight | Qt::AlignVCenter, scale.numberText(scale.high));
}

void HeatMap::paint(QPainter& painter) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const int wide = pictureSize().width() - 4;
    painter.setPen(tokens.text);
    painter.setFont(Theme::font(metrics::fontSmall, true));
    painter.drawText(QRectF(2, 0, wide, titleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     elided(painter.fontMetrics(), plane().title, wide));
    paintCells(painter);
    paintBorders(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_hits)
        paintHits(painter);
    paintBar(painter);
}

void HeatMap::paintEvent(QPaintEvent*)
{
    if (empty())
        return;
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    paint(painter);
    if (m_marked >= 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens.surface, 4));
        painter.drawRect(cell(m_marked));
        painter.setPen(QPen(tokens.accent, 2));
        painter.drawRect(cell(m_marked));
    }
}

QString HeatMap::plotName() const
{
    return empty() ? tr("Map") : plane().title;
}

QString HeatMap::fileName() const
{
    return u"map-%1"_s.arg(m_plane + 1);
}

QSize HeatMap::pictureSize() const
{
    return m_pictureSize.isValid() ? m_pictureSize : size();
}

void HeatMap::paintPicture(QPainter& painter)
{
    painter.save();
    painter.fillRect(QRectF(QPointF(), pictureSize()), Theme::instance().tokens().surface);
    if (!empty())
        paint(painter);
    painter.restore();
}

PlotTable HeatMap::numbers() const
{
    if (empty())
        return {};
    using Values = std::vector<double>;
    auto rows = std::make_shared<Values>(), columns = std::make_shared<Values>(),
         values = std::make_shared<Values>(), hits = std::make_shared<Values>(),
         groups = std::make_shared<Values>();
    for (int unit = 0; unit < m_map.rows * m_map.columns; ++unit) {
        const int row = unit / m_map.columns, column = unit % m_map.columns;
        rows->push_back(row + 1);
        columns->push_back(column + 1);
        values->push_back(plane().values(row, column) * plane().scale.factor);
        hits->push_back(m_map.hits[std::size_t(unit)]);
        groups->push_back(m_map.groups[std::size_t(unit)] + 1);
    }
    const QString unit = plane().scale.unit;
    return {{tr("Row"), rows},
            {tr("Column"), columns},
            {unit.isEmpty() ? plane().title : u"%1 (%2)"_s.arg(plane().title, unit), values},
            {tr("Squeezes"), hits},
            {tr("Cluster"), groups}};
}

} // namespace gripscope
