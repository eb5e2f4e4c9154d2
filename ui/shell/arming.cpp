// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/arming.h"

#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/settings/values/settings.h"
#include "ui/windows/window_guard.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
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

Attendance::Attendance(Workbench& workbench, std::unique_ptr<StationWatch> station, QObject* parent)
    : QObject(parent), m_workbench(&workbench), m_station(std::move(station))
{
    setClock([] { return std::chrono::steady_clock::now(); });
    connect(m_station.get(), &StationWatch::left, this, [this](StationWatch::Departure how) {
        switch (how) {
        case StationWatch::Departure::Locked:
            return leave(tr("Disarmed: the station was locked."));
        case StationWatch::Departure::Suspended:
            return leave(tr("Disarmed: the station went to sleep."));
        case StationWatch::Departure::Switched:
            return leave(tr("Disarmed: another user took the station over."));
        }
    });
    m_listener = workbench.connection().addListener([this](const std::vector<Sample>& samples) {
        if (m_button.pressedIn(samples))
            m_lastDone = m_clock();
    });
    connect(&workbench, &Workbench::ticked, this, &Attendance::follow);
    connect(&workbench.signIn(), &SignIn::changed, this, &Attendance::noticePerson);
    noticePerson();
    qApp->installEventFilter(this);
}

Attendance::~Attendance()
{
    qApp->removeEventFilter(this);
    m_workbench->connection().removeListener(m_listener);
}

void Attendance::setClock(Clock clock)
{
    m_clock = std::move(clock);
    m_lastDone = m_clock();
}

std::chrono::milliseconds Attendance::limit() const
{
    const double minutes = m_workbench->settings().get(setting::disarmMinutes);
    return std::chrono::milliseconds(static_cast<qint64>(minutes * 60'000));
}

bool Attendance::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
        m_lastDone = m_clock();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void Attendance::follow()
{
    const bool armed = m_workbench->connection().armed();
    const bool wasArmed = std::exchange(m_armed, armed);
    if ((armed && !wasArmed) || m_workbench->squeezing())
        m_lastDone = m_clock();
    if (armed && m_clock() - m_lastDone >= limit())
        leave(tr("Disarmed: nothing was done for %1 min.")
                  .arg(m_workbench->settings().get(setting::disarmMinutes)));
}

void Attendance::noticePerson()
{
    const std::optional<Authority>& now = m_workbench->signIn().current();
    const QString before = std::exchange(m_person, now ? now->personId() : QString());
    if (before == m_person || before.isEmpty()) // who signs in over nobody armed it, or may have
        return;
    leave(tr("Disarmed: the person who worked here has signed out."));
}

void Attendance::leave(const QString& why)
{
    if (!m_workbench->connection().armed() && !m_workbench->squeezing())
        return;
    m_workbench->stop();
    m_workbench->messages().report(why);
}

} // namespace gripscope
