// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/acquisition/link_control.h"
#include "devices/acquisition/link_words.h"

#include <algorithm>
#include <cmath>

// What comes from the device, and when it makes a stop necessary.

namespace gripscope {

using namespace protocol;

namespace {

Error stopped(const QString& why)
{
    return {ErrorCode::Stopped, {why}};
}

} // namespace

void LinkControl::takeSamples(std::span<const Sample> samples, std::uint64_t pushed, Time now)
{
    m_pushed = pushed;
    if (samples.empty())
        return;
    m_lastSample = now;
    m_pulse.take(now);
    for (const Sample& sample : samples) {
        const double distance = distanceFromRest(sample.force);
        rememberForce(std::abs(distance), now);
        m_stop.takeForce(distance, now);
        m_newestForce = sample.force;
        m_position = sample.position;
        if (guarded() || (sample.status & StatusArmed))
            m_watch.take(sample);
    }
    if (m_watch.exceeded() && guarded())
        stopBecause(*m_watch.exceeded(), now);
}

void LinkControl::rememberForce(double distance, Time now)
{
    if (now > m_force.since + m_options.limits.freshFor)
        m_force = {now, 0, m_force.now};
    m_force.now = std::max(m_force.now, distance);
}

void LinkControl::takeState(const ReportDecoder::DeviceState& state, Time now)
{
    if (!m_commandable || olderThanAnswer(state.timestamp_us))
        return;
    const bool armedBit = state.status & StatusArmed;
    m_deviceArmed = armedBit;
    m_stop.takeArmed(armedBit, now);
    const bool wasArmed = armed();
    m_arming.takeStatus(armedBit, state.status & StatusWatchdog, state.timestamp_us, now);
    if (wasArmed && !armed()) {
        m_disarmReason = stopped(deviceReason(state.status, m_frozen));
        m_error = m_disarmReason;
    }
    if (armedBit && !m_arming.underWay() && !m_stop.engaged(now))
        stopBecause(stopped(Words::tr("it is armed, though this program did not arm it")), now);
    if (armedBit && (state.status & StatusFault))
        stopBecause(stopped(Words::tr("it reports a fault")), now);
    followSqueeze(state.excitation, state.excitationNumber);
}

bool LinkControl::olderThanAnswer(std::uint32_t timestamp_us)
{
    if (m_lastAnswer_us && static_cast<std::int32_t>(timestamp_us - *m_lastAnswer_us) < 0)
        return true;
    m_lastAnswer_us.reset(); // so that it does not look new again when the device's clock has gone round
    return false;
}

void LinkControl::followSqueeze(ExcitationState excitation, std::uint16_t number)
{
    if (!squeezing() || number != m_squeeze.number)
        return;
    if (excitation == ExcitationState::Running)
        m_squeeze.state = SqueezeState::Running;
    else if (excitation == ExcitationState::Finished)
        endSqueeze(SqueezeState::Finished);
    else if (excitation == ExcitationState::Stopped)
        endSqueeze(SqueezeState::Stopped);
}

void LinkControl::endSqueeze(SqueezeState state)
{
    m_squeeze.state = state;
    m_squeeze.samplesBefore = m_pushed;
}

void LinkControl::takeAnswer(const Acknowledgement& answer, Time now)
{
    if (!m_commandable)
        return;
    if (!m_commands.sentHere(answer)) {
        m_foreign = now;
        if (guarded())
            stopBecause(stopped(Words::tr("another program sends it commands. Close that program, then "
                                          "arm again")),
                        now);
        return;
    }
    if (const auto outcome = m_commands.acknowledge(answer))
        settle(*outcome, answer, now);
    m_lastAnswer_us = answer.timestamp_us;
    if (!m_options.realTime) { // there may be no further report to say so
        m_deviceArmed = answer.status & StatusArmed;
        m_stop.takeArmed(m_deviceArmed, now);
    }
    followSqueeze(answer.excitation, answer.excitationNumber);
}

void LinkControl::settle(const CommandQueue::Outcome& outcome, const Acknowledgement& answer, Time now)
{
    const bool fine = outcome.result == CommandResult::Done || outcome.result == CommandResult::Repeated;
    // A device that does not end a squeeze early ends it later by itself; whether a stop was obeyed is seen.
    const bool judged = std::holds_alternative<FinishCommand>(outcome.body) ||
                        std::holds_alternative<StopCommand>(outcome.body) ||
                        std::holds_alternative<DisarmCommand>(outcome.body);
    if (!fine && !judged)
        return refuse(outcome, now);
    if (!fine || !std::holds_alternative<ArmCommand>(outcome.body))
        return;
    m_nextExcitation = static_cast<std::uint16_t>(outcome.detail + 1);
    m_frozen = false;
    m_arming.answered(answer.status & StatusArmed, answer.timestamp_us, now);
    if (armed())
        watchFrom({m_device.identity.limits.maxForce_N, m_device.identity.limits.maxTravel_m});
}

void LinkControl::refuse(const CommandQueue::Outcome& outcome, Time now)
{
    m_commands.clear(); // what was to follow makes no sense any more
    if (m_squeeze.state == SqueezeState::Uploading)
        endSqueeze(SqueezeState::Refused);
    const Error why = refusal(outcome);
    if (std::holds_alternative<ArmCommand>(outcome.body)) {
        if (!outcome.result)
            halt(StopCommand{}, now, true);
        m_arming.drop();
        m_disarmReason = why;
    }
    m_error = why;
}

void LinkControl::takeBadReport(Time now)
{
    m_lastBad = now;
    if (guarded() && !fresh(now))
        stopBecause(blindness(now), now);
}

void LinkControl::heard(Time time, Time now)
{
    if (!m_commandable)
        return;
    m_stop.heard(time);
    static_cast<void>(stopState(now)); // final from the moment on that it is known
    m_arming.heard(time);
    if (guarded() && !fresh(time))
        stopBecause(blindness(now), now);
}

Error LinkControl::blindness(Time now) const
{
    const bool damaged = m_lastBad && now < *m_lastBad + 2 * m_options.limits.freshFor;
    return stopped(
        damaged ? Words::tr("its reports arrive damaged (length, version or checksum wrong), so that nobody "
                            "would see what it does")
                : Words::tr("no samples came for %1 ms, so that nobody would see what it does")
                      .arg(m_options.limits.freshFor.count()));
}

void LinkControl::lose()
{
    m_commands.clear();
    m_arming.drop();
    m_deviceArmed = false;
    if (squeezing())
        endSqueeze(SqueezeState::Stopped);
}

} // namespace gripscope
