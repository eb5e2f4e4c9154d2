// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_chart.h"

#include <QMouseEvent>

#include <cmath>

namespace gripscope {

namespace {
constexpr double reach = 20;       ///< pixels from a cursor that still take it: half a touch target
constexpr double wheelNotch = 120; ///< Qt's count for one notch
constexpr double notchesPerDouble = 2;
constexpr double keyPan = 0.1; ///< of the width
} // namespace

StripGestures::StripGestures(StripChart& chart) : QObject(&chart), m_chart(&chart)
{
    chart.installEventFilter(this);
    chart.setMouseTracking(true);
}

void StripGestures::setEnabled(bool on)
{
    m_enabled = on;
    m_pressed = false;
    m_chart->setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
    m_chart->setCursor(on ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

std::optional<int> StripGestures::cursorNear(double pixel) const
{
    std::optional<int> found;
    double nearest = reach;
    for (const StripMark& mark : m_chart->marks()) {
        const double distance = std::abs(m_chart->pixelAt(mark.x) - pixel);
        if (mark.kind == StripMark::Kind::Marker || distance > nearest)
            continue;
        nearest = distance;
        found = mark.kind == StripMark::Kind::FirstCursor ? 0 : 1;
    }
    return found;
}

bool StripGestures::eventFilter(QObject* watched, QEvent* event)
{
    if (!m_enabled || watched != m_chart)
        return false;
    switch (event->type()) {
    case QEvent::Wheel:
        return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::KeyPress:
        return key(*static_cast<QKeyEvent*>(event));
    case QEvent::MouseButtonPress:
        press(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseMove:
        move(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonRelease:
        m_pressed = false;
        showWhatADragDoes(static_cast<QMouseEvent*>(event)->position().x());
        return true;
    case QEvent::MouseButtonDblClick:
        emit resetAsked();
        return true;
    default:
        return false;
    }
}

bool StripGestures::wheel(const QWheelEvent& event)
{
    const double share = m_chart->shareAt(event.position().x());
    const QPoint turned = event.angleDelta();
    if (std::abs(turned.x()) > std::abs(turned.y()))
        emit panAsked(-keyPan * turned.x() / wheelNotch);
    else
        emit zoomAsked(std::exp2(turned.y() / wheelNotch / notchesPerDouble), share);
    return true;
}

bool StripGestures::key(const QKeyEvent& event)
{
    const int direction = event.key() == Qt::Key_Left ? -1 : event.key() == Qt::Key_Right ? 1 : 0;
    if (direction == 0)
        return false;
    if (event.modifiers() & Qt::ShiftModifier)
        emit cursorStepped(0, direction);
    else if (event.modifiers() & Qt::ControlModifier)
        emit cursorStepped(1, direction);
    else
        emit panAsked(direction * keyPan);
    return true;
}

void StripGestures::press(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return;
    m_chart->setFocus(Qt::MouseFocusReason);
    m_pressed = true;
    m_last = event.position().x();
    m_cursor = cursorNear(m_last);
    if (!m_cursor)
        m_chart->setCursor(Qt::ClosedHandCursor);
}

void StripGestures::move(const QMouseEvent& event)
{
    const double pixel = event.position().x();
    if (!m_pressed)
        return showWhatADragDoes(pixel);
    if (m_cursor)
        emit cursorDragged(*m_cursor, m_chart->shareAt(pixel));
    else
        emit panAsked(m_chart->shareAt(m_last) - m_chart->shareAt(pixel));
    m_last = pixel;
}

void StripGestures::showWhatADragDoes(double pixel)
{
    m_chart->setCursor(cursorNear(pixel) ? Qt::SizeHorCursor : Qt::OpenHandCursor);
}

} // namespace gripscope
