// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_words.h"
#include "ui/charts/control_plot.h"

#include <QDateTime>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int leastControlDrag = 6;    ///< pixels; less is a click
constexpr std::size_t closestView = 8; ///< points
constexpr int panelHeight = 120;       ///< in a picture, logical pixels
constexpr int leastPanelHeight = 60;   ///< in the least window
constexpr double axisRoom = 18;        ///< that the lowest panel needs for its numbers

QRectF panelBox(const QRectF& room, std::size_t panel, std::size_t panels)
{
    const double each = (room.height() - axisRoom) / double(panels);
    return {room.left(), room.top() + double(panel) * each, room.width(),
            each + (panel + 1 == panels ? axisRoom : 0)};
}

std::size_t mostPoints(const ProcessPicture& picture, const std::vector<ControlPanel>& panels)
{
    std::size_t most = 0;
    for (const ControlPanel& panel : panels)
        most = std::max(most, ControlSeries(picture, panel).points());
    return most;
}

template <typename Value>
PlotColumn pointColumn(const QString& name, std::size_t points, const Value& value)
{
    auto values = std::make_shared<std::vector<double>>();
    values->reserve(points);
    for (std::size_t i = 0; i < points; ++i)
        values->push_back(value(i));
    return {name, values};
}

} // namespace

void paintControlFigure(QPainter& painter, const ProcessPicture& picture,
                        const std::vector<ControlPanel>& panels, const QRectF& room,
                        const ThemeTokens& tokens)
{
    const PointsInView all{0, mostPoints(picture, panels)};
    for (std::size_t i = 0; i < panels.size(); ++i)
        ControlPlot(picture, panels[i], all, panelBox(room, i, panels.size()), i + 1 == panels.size())
            .paint(painter, tokens);
}

PlotTable controlNumbers(const ProcessPicture& picture, const std::vector<ControlPanel>& panels)
{
    PlotTable table;
    for (const ControlPanel& panel : panels) {
        const ControlSeries series(picture, panel);
        const std::size_t points = series.points();
        if (points == 0)
            continue;
        const QString name =
            panel.what == ControlPanel::What::Joint ? u"T2"_s : processSymbol(panel.quantity);
        const QString symbol = panel.what == ControlPanel::What::Spread ? name + u" spread"_s : name;
        auto times = std::make_shared<std::vector<QString>>();
        for (std::size_t i = 0; i < points; ++i)
            times->push_back(QDateTime::fromMSecsSinceEpoch(picture.values->times_ms[series.row(i)], Qt::UTC)
                                 .toString(Qt::ISODateWithMs));
        table.push_back(pointColumn(ControlView::tr("%1: inspection").arg(symbol), points,
                                    [&](std::size_t i) { return double(series.number(i)); }));
        table.push_back({ControlView::tr("%1: time (UTC)").arg(symbol), {}, times});
        table.push_back(pointColumn(series.title(), points,
                                    [&](std::size_t i) { return series.value(i).value_or(NAN); }));
        if (series.second(0))
            table.push_back(pointColumn(ControlView::tr("%1: lower sum").arg(symbol), points,
                                        [&](std::size_t i) { return *series.second(i); }));
        table.push_back(pointColumn(ControlView::tr("%1: lower limit").arg(symbol), points,
                                    [&](std::size_t i) { return series.lower(i); }));
        table.push_back(pointColumn(ControlView::tr("%1: upper limit").arg(symbol), points,
                                    [&](std::size_t i) { return series.upper(i); }));
        table.push_back(pointColumn(ControlView::tr("%1: signal").arg(symbol), points,
                                    [&](std::size_t i) { return series.signal(i) ? 1.0 : 0.0; }));
    }
    return table;
}

ControlView::ControlView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Control charts"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

std::size_t ControlView::points() const
{
    return m_picture ? mostPoints(*m_picture, m_panels) : 0;
}

QSize ControlView::minimumSizeHint() const
{
    return {280, leastPanelHeight * std::max(1, int(m_panels.size()))};
}

bool ControlView::showsAll() const
{
    return m_view == PointsInView{0, points()};
}

void ControlView::setPicture(std::shared_ptr<const ProcessPicture> picture, std::vector<ControlPanel> panels)
{
    const bool all =
        empty() || showsAll() || m_panels != panels || !picture || picture->filter != m_picture->filter;
    const bool atEnd = m_view.last == points();
    m_picture = std::move(picture);
    m_panels = std::move(panels);
    updateGeometry();
    if (all || m_view.last > points())
        return showAll();
    if (atEnd) { // what comes is seen
        const std::size_t by = points() - m_view.last;
        m_view = {m_view.first + by, m_view.last + by};
    }
    update();
    emit viewChanged();
}

std::optional<std::pair<qint64, qint64>> ControlView::numbersInView() const
{
    if (m_panels.empty() || !m_picture)
        return {};
    const ControlSeries series(*m_picture, m_panels.front());
    const std::size_t last = std::min(m_view.last, series.points());
    if (m_view.first >= last)
        return {};
    return std::pair(series.number(m_view.first), series.number(last - 1));
}

ControlPlot ControlView::plot(std::size_t panel) const
{
    return {*m_picture, m_panels[panel], m_view, panelBox(QRectF(rect()), panel, m_panels.size()),
            panel + 1 == m_panels.size()};
}

QString ControlView::plotName() const
{
    return tr("Control charts");
}

QString ControlView::fileName() const
{
    return u"control_chart"_s;
}

QSize ControlView::pictureSize() const
{
    return m_pictureSize.isValid() ? QSize(m_pictureSize.width(), panelHeight * int(m_panels.size()) + 60)
                                   : size();
}

void ControlView::paintPicture(QPainter& painter)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter.fillRect(QRect(QPoint(), pictureSize()), tokens.surface);
    const QRectF room(QPoint(0, 0), pictureSize());
    for (std::size_t i = 0; !empty() && i < m_panels.size(); ++i)
        ControlPlot(*m_picture, m_panels[i], m_view, panelBox(room, i, m_panels.size()),
                    i + 1 == m_panels.size())
            .paint(painter, tokens);
}

PlotTable ControlView::numbers() const
{
    return m_picture ? controlNumbers(*m_picture, m_panels) : PlotTable();
}

void ControlView::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.fillRect(rect(), tokens.surface);
    for (std::size_t i = 0; !empty() && i < m_panels.size(); ++i)
        plot(i).paint(painter, tokens);
    if (m_pressed && m_dragged) {
        const int from = std::min(m_pressed->x(), m_dragged->x()),
                  to = std::max(m_pressed->x(), m_dragged->x());
        QColor tint = tokens.accent;
        tint.setAlpha(50);
        painter.fillRect(QRect(from, 0, to - from, height()), tint);
    }
    if (hasFocus()) {
        painter.setPen(QPen(tokens.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void ControlView::showAll()
{
    m_view = {0, points()};
    update();
    emit viewChanged();
}

void ControlView::show(double first, double last)
{
    const double all = double(points()), least = double(std::min(closestView, points()));
    const double from = std::clamp(std::floor(first), 0.0, all - least);
    m_view.first = std::size_t(from);
    m_view.last = std::size_t(std::clamp(std::ceil(last), from + least, all));
    update();
    emit viewChanged();
}

void ControlView::showPoint(std::size_t point)
{
    if (point >= m_view.first && point < m_view.last)
        return;
    const double half = double(m_view.count()) / 2;
    show(double(point) - half, double(point) + half);
}

void ControlView::zoom(double around, double factor)
{
    show(around - (around - double(m_view.first)) * factor, around + (double(m_view.last) - around) * factor);
}

void ControlView::click(QPoint at)
{
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const ControlPlot clicked = plot(i);
        if (const auto point = clicked.pointAt(at))
            emit rowChosen(clicked.series().row(*point));
    }
}

void ControlView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !empty())
        m_pressed = event->position().toPoint();
}

void ControlView::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_pressed)
        return;
    m_dragged = event->position().toPoint();
    update();
}

void ControlView::mouseReleaseEvent(QMouseEvent* event)
{
    if (!m_pressed || event->button() != Qt::LeftButton)
        return;
    const QPoint from = *m_pressed, to = event->position().toPoint();
    m_pressed.reset();
    m_dragged.reset();
    update();
    if (std::abs(to.x() - from.x()) < leastControlDrag)
        return click(to);
    const ControlPlot first = plot(0);
    show(first.placeAt(std::min(from.x(), to.x())), first.placeAt(std::max(from.x(), to.x())));
}

void ControlView::mouseDoubleClickEvent(QMouseEvent*)
{
    showAll();
}

void ControlView::wheelEvent(QWheelEvent* event)
{
    if (!empty())
        zoom(plot(0).placeAt(event->position().x()), std::pow(0.8, event->angleDelta().y() / 120.0));
    event->accept();
}

void ControlView::keyPressEvent(QKeyEvent* event)
{
    const double span = double(m_view.count());
    const double middle = double(m_view.first) + span / 2;
    const auto move = [&](double share) {
        const double by = std::clamp(std::round(span * share), -double(m_view.first),
                                     double(points()) - double(m_view.last));
        show(double(m_view.first) + by, double(m_view.last) + by);
    };
    if (empty())
        return QWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(middle, 0.5);
    case Qt::Key_Minus:
        return zoom(middle, 2);
    case Qt::Key_Left:
        return move(-0.2);
    case Qt::Key_Right:
        return move(0.2);
    case Qt::Key_Home:
        return showAll();
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace gripscope
