// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect/inspect_automatic.h"

#include "core/signal/recording/units.h"
#include "ui/context/workbench.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/outcome_view.h"

#include <QApplication>
#include <QEvent>

#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// Of the largest force of the gripper: what no sensor is to be believed below.
constexpr double leastTouchShare = 1e-3;
constexpr double beat_s = 0.5;
const AutomaticSqueezeOptions usual{};

int secondsLeft(const AutomaticSqueeze::Decision& decision)
{
    return static_cast<int>(std::ceil(decision.remaining_s));
}

} // namespace

InspectAutomatic::InspectAutomatic(Workbench& workbench, QObject* parent)
    : QObject(parent), m_workbench(&workbench)
{
    m_listener = workbench.connection().addListener([this](const std::vector<Sample>& samples) {
        for (const Sample& one : samples)
            m_machine.take({one.sequence, one.time_s, one.force, (one.status & StatusMoving) != 0});
    });
    connect(&workbench, &Workbench::stopped, this, [this] { m_machine.stop(); });
    connect(&workbench, &Workbench::connectionChanged, this, [this] {
        if (m_workbench->connection().state() != ConnectSession::State::Connected)
            m_machine.reset();
        setOptions();
    });
    connect(&workbench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key == QLatin1String(setting::touchTimes.key))
            setOptions();
    });
    setOptions();
}

InspectAutomatic::~InspectAutomatic()
{
    m_workbench->connection().removeListener(m_listener);
}

void InspectAutomatic::setOptions()
{
    const GripperIdentity identity = m_workbench->connection().identity();
    AutomaticSqueezeOptions options = usual;
    options.touchTimes = m_workbench->settings().get(setting::touchTimes);
    if (const std::optional<double> unit_N = newtonsPer(identity.forceUnit))
        options.leastTouch = leastTouchShare * identity.limits.maxForce_N / *unit_N;
    m_machine.setOptions(options);
}

void InspectAutomatic::setActive(bool active)
{
    if (active)
        qApp->installEventFilter(this); // in front of those that are there: they may keep a key to themselves
    else
        qApp->removeEventFilter(this);
}

bool InspectAutomatic::wanted() const
{
    return m_workbench->settings().get(setting::automaticSqueeze);
}

bool InspectAutomatic::counting() const
{
    return m_now.state == AutomaticSqueeze::State::Counting;
}

void InspectAutomatic::follow(bool ready)
{
    using Seconds = std::chrono::duration<double>;
    const bool armed = m_workbench->connection().armed();
    const bool wasArmed = std::exchange(m_armed, armed);
    const AutomaticSqueeze::Decision before =
        std::exchange(m_now, m_machine.step(Seconds(std::chrono::steady_clock::now() - m_begin).count(),
                                            {armed, ready && wanted(), m_workbench->squeezing()}));
    if (counting()) {
        const int beats = static_cast<int>((usual.countdown_s - m_now.remaining_s) / beat_s);
        if (before.state != m_now.state || beats != m_beats)
            emit beat();
        m_beats = beats;
    }
    if (before.state != m_now.state || secondsLeft(before) != secondsLeft(m_now) ||
        before.waitsForPerson != m_now.waitsForPerson || armed != wasArmed)
        emit changed();
    if (m_now.squeeze)
        emit due();
}

void InspectAutomatic::show(VerdictPanel& panel) const
{
    panel.showAlert(tr("Squeezes in %1 s").arg(secondsLeft(m_now)), tr("Take the hand away or press Stop."));
}

QString InspectAutomatic::words() const
{
    if (!m_armed)
        return tr("Squeezes by itself when a part arrives, once the gripper is armed");
    if (m_now.waitsForPerson)
        return tr("Stopped: squeezes by itself again once you have armed the gripper or squeezed");
    switch (m_now.state) {
    case AutomaticSqueeze::State::Learning:
        return tr("Learns the force at rest: keep the jaws empty for a second");
    case AutomaticSqueeze::State::Waiting:
        return tr("Squeezes by itself %1 s after a part has arrived").arg(usual.countdown_s);
    case AutomaticSqueeze::State::Settling:
        return tr("A part has arrived: the force is to keep still");
    case AutomaticSqueeze::State::Counting:
        return tr("A key, a click or any change of the force ends it");
    case AutomaticSqueeze::State::Occupied:
        return tr("Take the part out: the next one that arrives is squeezed by itself");
    }
    return {};
}

bool InspectAutomatic::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride: // of a key that is a shortcut, which is pressed nowhere else
    case QEvent::Shortcut:
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::TabletPress:
    case QEvent::Wheel:
        m_machine.interrupt();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace gripscope
