// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/arm_chord.h"

#include "ui/context/workbench.h"
#include "ui/windows/window_guard.h"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace gripscope {

namespace {

constexpr Qt::KeyboardModifiers chordModifiers = Qt::ControlModifier | Qt::ShiftModifier;

bool isModifier(int key)
{
    return key == Qt::Key_Control || key == Qt::Key_Shift;
}

} // namespace

ArmChord::ArmChord(Workbench& workbench, QWidget* place)
    : QObject(place), m_workbench(&workbench), m_place(place),
      m_clock([] { return std::chrono::steady_clock::now(); })
{
    connect(&workbench, &Workbench::ticked, this, &ArmChord::follow);
    connect(&workbench, &Workbench::stopped, this, &ArmChord::cancel);
    qApp->installEventFilter(this);
}

ArmChord::~ArmChord()
{
    qApp->removeEventFilter(this);
}

void ArmChord::setClock(Clock clock)
{
    m_clock = std::move(clock);
}

std::optional<double> ArmChord::progress() const
{
    if (!m_since)
        return {};
    const std::chrono::duration<double> held = m_clock() - *m_since;
    return std::clamp(held / std::chrono::duration<double>(duration), 0.0, 1.0);
}

bool ArmChord::eventFilter(QObject* watched, QEvent* event)
{
    // A key goes to a window first, and on to the parents of who does not take it: all but the first are told
    // of what is known already.
    const bool pressed = event->type() == QEvent::KeyPress;
    if ((pressed || event->type() == QEvent::KeyRelease) && watched->isWidgetType() &&
        static_cast<QWidget*>(watched)->window() == m_place->window()) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        pressed ? press(key) : release(key);
    }
    return QObject::eventFilter(watched, event);
}

void ArmChord::press(const QKeyEvent& key)
{
    if (key.isAutoRepeat() || isModifier(key.key()))
        return;
    if (key.key() != Qt::Key_A || key.modifiers() != chordModifiers)
        return cancel();
    if (m_since || !possible())
        return;
    m_since = m_clock();
    emit changed();
}

void ArmChord::release(const QKeyEvent& key)
{
    if (!key.isAutoRepeat() && (key.key() == Qt::Key_A || isModifier(key.key())))
        cancel();
}

void ArmChord::follow()
{
    if (!m_since)
        return;
    if (!possible())
        return cancel();
    if (m_clock() - *m_since < duration) {
        emit changed();
        return;
    }
    cancel();
    m_workbench->arm();
}

void ArmChord::cancel()
{
    if (std::exchange(m_since, std::nullopt))
        emit changed();
}

bool ArmChord::possible() const
{
    const ConnectSession& connection = m_workbench->connection();
    return connection.state() == ConnectSession::State::Connected && connection.identity().commandable &&
           !connection.armed() && !WindowGuard::asking() && m_place->window()->isActiveWindow();
}

} // namespace gripscope
