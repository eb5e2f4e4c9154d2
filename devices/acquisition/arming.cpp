// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/arming.h"

#include "core/base/words.h"
#include "devices/protocol/arming_obstacle.h"

#include <algorithm>
#include <utility>

namespace gripscope {

namespace {

/// Two clocks, and reports that arrive a little early or late, make 20 ms of one and the same 20.2.
constexpr double sameDespiteClocks = 1.02;

/// Long enough for ten reports at the slowest pace that is allowed, and a late one.
std::chrono::milliseconds listenFor(const LinkLimits& limits)
{
    return (StreamPulse::needed + 2) * limits.reportPeriod;
}

} // namespace

void Arming::ask(Time now)
{
    if (m_step != Step::Off)
        return;
    m_refusal.reset();
    m_step = Step::Listening;
    m_since = now;
}

bool Arming::sendArm(const StreamPulse& pulse, Time now)
{
    if (m_step != Step::Listening)
        return false;
    if (m_device.realTime) {
        if (!pulse.known() && now < m_since + listenFor(m_limits))
            return false;
        if (!pulse.known()) {
            refuse(Words::tr("good samples do not come, or come too seldom"));
            return false;
        }
        if (pulse.period() > m_limits.reportPeriod * sameDespiteClocks) {
            refuse(protocol::tooSeldom(pulse.period().count(),
                                       static_cast<double>(m_limits.reportPeriod.count())));
            return false;
        }
    }
    m_step = m_proved ? Step::Asked : Step::ProofAsked;
    m_since = now;
    return true;
}

void Arming::answered(bool armed, std::uint32_t device_us, Time now)
{
    if (m_step != Step::ProofAsked && m_step != Step::Asked)
        return;
    if (!armed)
        return refuse(Words::tr("it answered too late, and is disarmed again"));
    m_step = m_step == Step::ProofAsked ? Step::ProofWaits : Step::Armed;
    m_since = now;
    m_answered_us = device_us;
}

void Arming::takeStatus(bool armed, bool watchdog, std::uint32_t device_us, Time now)
{
    if (armed)
        return;
    if (m_step == Step::Armed)
        m_step = Step::Off;
    if (m_step != Step::ProofWaits)
        return;
    judgeTrip(watchdog, device_us);
    if (m_step != Step::ProofWaits)
        return;
    m_proved = true;
    m_step = Step::Listening; // the reports are known: Arm goes out at once
    m_since = now;
}

void Arming::judgeTrip(bool watchdog, std::uint32_t device_us)
{
    // By the device's clock: its answer may have waited for a busy reader.
    const auto after = std::chrono::microseconds(static_cast<std::int32_t>(device_us - m_answered_us));
    if (!watchdog)
        refuse(Words::tr("left without heartbeats it disarmed itself, but not with its watchdog bit"));
    else if (after < m_device.watchdog / 2)
        refuse(Words::tr("its watchdog trips after %1 ms already; it states %2 ms")
                   .arg(std::max<std::int64_t>(0, after.count() / 1000))
                   .arg(m_device.watchdog.count()));
}

void Arming::heard(Time time)
{
    if (m_step == Step::ProofWaits && time > m_since + m_device.watchdog + m_limits.watchdogMargin)
        refuse(Words::tr("left without heartbeats for %1 ms it stayed armed: its watchdog of %2 ms does not "
                         "work, and nothing would stop it if this program or the cable failed")
                   .arg((m_device.watchdog + m_limits.watchdogMargin).count())
                   .arg(m_device.watchdog.count()));
}

std::optional<Arming::Refusal> Arming::takeRefusal()
{
    return std::exchange(m_refusal, std::nullopt);
}

void Arming::refuse(const QString& why)
{
    m_refusal = {why, underWay()};
    m_step = Step::Off;
}

} // namespace gripscope
