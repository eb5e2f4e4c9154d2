// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/link_control.h"

#include "core/base/words.h"
#include "devices/acquisition/link_words.h"

#include <algorithm>
#include <cmath>

// What its owner wants, and what is sent; what comes in is in link_control_input.cpp.

namespace gripscope {

using namespace protocol;
using namespace std::chrono_literals;

LinkControl::LinkControl(const DeviceDescription& device, const Options& options)
    : m_options(options), m_device(device), m_commandable(device.identity.commandable),
      m_commands(options.lastNumber, device.identity.protocolMinor >= 1, options.limits.attempts),
      m_arming(options.limits, {std::chrono::milliseconds(device.measurement.watchdog_ms), options.realTime}),
      m_stop(options.limits), m_token(options.lastToken)
{
    watchFrom({device.identity.limits.maxForce_N, device.identity.limits.maxTravel_m});
}

void LinkControl::arm(Time now)
{
    if (!m_commandable || armed() || m_arming.step() != Arming::Step::Off)
        return;
    m_error.reset();
    m_disarmReason.reset();
    if (stopState(now) == StopState::NotObeyed) {
        m_error = Error{ErrorCode::StopNotObeyed, {}};
        return;
    }
    if (m_options.realTime && m_device.armingObstacle)
        return refuseToArm(*m_device.armingObstacle);
    if (m_foreign && now < *m_foreign + m_options.limits.forgetForeign)
        return refuseToArm(Words::tr("another program sends it commands. Close that program first"));
    restHere(now);
    m_arming.ask(now);
}

void LinkControl::refuseToArm(const QString& why)
{
    m_disarmReason = Error{ErrorCode::ArmingRefused, {why}};
    m_error = m_disarmReason;
}

void LinkControl::disarm(Time now)
{
    halt(DisarmCommand{}, now);
}

void LinkControl::stop(Time now)
{
    halt(StopCommand{}, now);
}

void LinkControl::close(Time now)
{
    if (guarded() || !m_commands.empty())
        halt(StopCommand{}, now);
}

void LinkControl::halt(CommandBody body, Time now, bool mayBeArmed)
{
    if (!m_commandable)
        return;
    if (m_stop.engaged(now)) { // it goes on; what was asked for since is taken back all the same
        m_arming.drop();
        m_commands.clear();
        if (squeezing())
            endSqueeze(SqueezeState::Stopped);
        return;
    }
    mayBeArmed = mayBeArmed || guarded();
    const double floor = harmless();
    m_arming.drop();
    if (squeezing())
        endSqueeze(SqueezeState::Stopped);
    StopSequence::Begin begin;
    begin.report = m_commands.halt(body);
    begin.armed = mayBeArmed;
    begin.forceMatters = mayBeArmed;
    // Where time waits for its reader, the last 50 ms are none of the device's.
    begin.force = m_options.realTime ? std::max(m_force.now, m_force.before)
                                     : std::abs(distanceFromRest(m_newestForce));
    begin.floor = floor;
    begin.samplesCome = m_options.realTime;
    begin.watchdog = std::chrono::milliseconds(m_options.realTime ? m_device.measurement.watchdog_ms : 0);
    m_stop.begin(begin, now);
}

double LinkControl::harmless() const
{
    // While it squeezes: no grip, and more than sensors make of nothing. At rest a part may have been put in.
    const double counts =
        squeezing() ? 0.01 * m_device.limits.maxForce : 0.1 * m_device.forceCounts(m_limits.maxForce_N);
    return std::max(counts, 3.0) * m_device.measurement.forcePerCount;
}

void LinkControl::stopBecause(Error reason, Time now)
{
    if (m_stop.engaged(now) || m_disobeyed)
        return;
    m_disarmReason = std::move(reason);
    m_error = m_disarmReason;
    halt(StopCommand{}, now);
}

StopState LinkControl::stopState(Time now)
{
    const StopState state = m_stop.state(now);
    if (state == StopState::NotObeyed && !m_disobeyed) {
        m_disobeyed = true;
        m_error = Error{ErrorCode::StopNotObeyed, {}};
    }
    return m_disobeyed ? StopState::NotObeyed : state;
}

void LinkControl::start(const AdmittedExcitation& excitation, Time now)
{
    if (!m_commandable || !fresh(now)) {
        refuseSqueeze();
        if (m_commandable)
            m_error = blindness(now);
        return;
    }
    m_error.reset();
    const std::uint16_t number = m_nextExcitation++;
    m_squeeze = {SqueezeState::Uploading, number, 0};
    const SetLimitsCommand limits = m_device.limitCounts(excitation.maxForce_N(), excitation.maxTravel_m());
    m_commands.push(limits);
    watchFrom({excitation.maxForce_N(), excitation.maxTravel_m()});
    restHere(now);
    std::vector<std::int32_t> forces;
    forces.reserve(excitation.force_N().size());
    // A force at the limit may be rounded up, the limit never is.
    for (const double force_N : excitation.force_N())
        forces.push_back(std::min(m_device.forceCounts(force_N), limits.maxForce));
    for (std::size_t first = 0; first < forces.size(); first += maxForcesPerUpload) {
        UploadCommand chunk{number, static_cast<std::uint32_t>(first), 0, {}};
        const std::size_t count = std::min(maxForcesPerUpload, forces.size() - first);
        chunk.count = static_cast<std::uint8_t>(count);
        std::copy_n(forces.begin() + static_cast<std::ptrdiff_t>(first), count, chunk.forces.begin());
        m_commands.push(chunk);
    }
    m_commands.push(StartCommand{number, static_cast<std::uint32_t>(forces.size()), forcesCrc(forces)});
}

void LinkControl::finish()
{
    if (m_commandable && m_squeeze.state == SqueezeState::Running)
        m_commands.push(FinishCommand{m_squeeze.number});
}

void LinkControl::watchFrom(const JobLimits& limits)
{
    m_limits = limits;
    const bool known = m_lastSample != Time{};
    m_watch = LimitWatch(limits, m_device.identity, known ? std::optional(m_position) : std::nullopt);
}

void LinkControl::restHere(Time now)
{
    m_restForce = m_newestForce;
    m_force = {now, 0, 0};
}

bool LinkControl::squeezing() const
{
    return m_squeeze.state == SqueezeState::Uploading || m_squeeze.state == SqueezeState::Running;
}

bool LinkControl::guarded() const
{
    return m_commandable && (m_deviceArmed || m_arming.underWay() || squeezing());
}

bool LinkControl::fresh(Time now) const
{
    return !m_options.realTime || now <= m_lastSample + m_options.limits.freshFor;
}

std::optional<Report> LinkControl::next(Time now, Time aliveAt)
{
    if (!m_commandable)
        return std::nullopt;
    if (std::optional<Report> halt = m_stop.next(now)) {
        m_commands.countHalt(m_stop.sentBefore());
        return halt;
    }
    if (m_stop.engaged(now))
        return std::nullopt;
    followArming(now);
    if (m_stop.engaged(now))
        return m_stop.next(now);
    if (heartbeatDue(now, aliveAt)) {
        m_lastHeartbeat = now;
        return m_commands.heartbeat();
    }
    if (m_arming.step() == Arming::Step::ProofWaits) // whatever is sent would keep the watchdog quiet
        return std::nullopt;
    std::optional<Report> command = m_commands.next(now);
    if (command)
        return command;
    if (const auto outcome = m_commands.expired(now))
        refuse(*outcome, now);
    return m_stop.next(now);
}

void LinkControl::followArming(Time now)
{
    if (m_arming.sendArm(m_pulse, now)) {
        m_stop = StopSequence(m_options.limits); // what became of the last one is over
        if (++m_token == 0)
            ++m_token;
        m_commands.push(ArmCommand{m_token});
    }
    const auto refusal = m_arming.takeRefusal();
    if (!refusal)
        return;
    if (refusal->mayBeArmed)
        halt(StopCommand{}, now, true);
    refuseToArm(refusal->why);
}

bool LinkControl::heartbeatDue(Time now, Time aliveAt)
{
    if (!armed() || now < m_lastHeartbeat + m_options.limits.heartbeatPeriod)
        return false;
    m_frozen = now - aliveAt >= m_options.limits.aliveFor;
    return !m_frozen && fresh(now);
}

LinkControl::Time LinkControl::wakeAt(Time now) const
{
    Time earliest = now + m_options.limits.heartbeatPeriod;
    if (armed() && m_lastHeartbeat + m_options.limits.heartbeatPeriod > now)
        earliest = std::min(earliest, m_lastHeartbeat + m_options.limits.heartbeatPeriod);
    if (m_arming.step() == Arming::Step::Listening)
        earliest = std::min(earliest, now + 5ms);
    for (const Time at : {m_stop.wakeAt(), m_commands.wakeAt()})
        if (at > now)
            earliest = std::min(earliest, at);
    return earliest;
}

bool LinkControl::wantsToWrite(Time now) const
{
    return m_commandable &&
           (m_stop.wakeAt() <= now ? !m_stop.allSent() : m_arming.step() == Arming::Step::Listening);
}

bool LinkControl::mayClose(Time now) const
{
    return !m_commandable || !m_stop.engaged(now) ||
           (m_stop.allSent() && m_stop.state(now) != StopState::Waiting);
}

} // namespace gripscope
