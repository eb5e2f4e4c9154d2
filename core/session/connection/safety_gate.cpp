// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/safety_gate.h"

#include "core/base/words.h"
#include "core/session/connection/gripper_port.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

Finding newtons(double force_N)
{
    return Finding::quantity(MechanicalQuantity::Force, force_N);
}

/// Nothing when every value is a push; else what is wrong with the first that is not.
std::optional<Error> notAPush(const std::vector<double>& force_N)
{
    const auto bad =
        std::find_if(force_N.begin(), force_N.end(), [](double f) { return !std::isfinite(f) || f < 0; });
    if (bad == force_N.end())
        return std::nullopt;
    const Finding what =
        std::isfinite(*bad) ? Words::say("a pull of %1").arg(newtons(-*bad)) : Words::say("not a number");
    return Error{ErrorCode::Usage,
                 {Words::say("The force signal has %1 at sample %2; a gripper can only push. Raise the bias "
                             "or lower the peak.")
                      .arg(what, QString::number(bad - force_N.begin()))}};
}

} // namespace

JobLimits SafetyGate::effectiveLimits() const
{
    const DeviceLimits device = m_port->identity().limits;
    return {std::min(device.maxForce_N, m_jobLimits.maxForce_N),
            std::min(device.maxTravel_m, m_jobLimits.maxTravel_m)};
}

Expected<AdmittedExcitation> SafetyGate::admit(const std::vector<double>& force_N) const
{
    const GripperIdentity identity = m_port->identity();
    if (!identity.commandable)
        return failure(ErrorCode::DeviceRefused, {Words::tr("squeeze"), Words::tr("it only listens")});
    if (force_N.empty())
        return failure(ErrorCode::Usage, {Words::tr("The force signal is empty. Choose a longer squeeze.")});
    if (force_N.size() > identity.limits.maxSamples)
        return failure(
            ErrorCode::Usage,
            {Words::tr(
                 "The force signal has %1 samples; the gripper holds at most %2. Choose a shorter squeeze.")
                 .arg(QString::number(force_N.size()), QString::number(identity.limits.maxSamples))});
    RETURN_IF_ERROR(notAPush(force_N));

    const JobLimits limits = effectiveLimits();
    const auto usable = [](double limit) { return std::isfinite(limit) && limit > 0; };
    if (!usable(m_jobLimits.maxForce_N) || !usable(m_jobLimits.maxTravel_m))
        return failure(
            ErrorCode::Usage,
            {Words::tr(
                "The recipe has no crush limit. Give the most force and travel that the part bears.")});
    const double largest_N = *std::max_element(force_N.begin(), force_N.end());
    if (largest_N > limits.maxForce_N) {
        const bool device = identity.limits.maxForce_N <= m_jobLimits.maxForce_N;
        return failure(ErrorCode::LimitExceeded,
                       {Words::tr("The force"), newtons(largest_N), newtons(limits.maxForce_N),
                        device ? Words::tr("the gripper's own") : Words::tr("the recipe's")});
    }
    return AdmittedExcitation(force_N, limits);
}

Expected<void> SafetyGate::arm(const QString& person)
{
    if (person.trimmed().isEmpty())
        return failure(ErrorCode::Usage,
                       {Words::tr("Only a person may arm the gripper, and no name was given.")});
    if (!m_port->identity().commandable)
        return failure(ErrorCode::DeviceRefused, {Words::tr("arm"), Words::tr("it only listens")});
    if (const LinkState state = m_port->state(); state != LinkState::Ready && state != LinkState::Armed)
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("arm"), Words::tr("the link is %1").arg(toString(state))});
    m_port->arm(ArmingOrder(person.trimmed()));
    return {};
}

Expected<void> SafetyGate::start(const std::vector<double>& force_N)
{
    ASSIGN_OR_RETURN(const AdmittedExcitation admitted, admit(force_N));
    if (m_port->state() != LinkState::Armed)
        return failure(ErrorCode::NotArmed, {Words::tr("move")});
    m_port->startExcitation(admitted);
    m_started.force_N = admitted.force_N();
    ++m_started.number;
    return {};
}

void SafetyGate::finish()
{
    m_port->finishExcitation();
}

void SafetyGate::stop() noexcept
{
    m_port->stop();
}

} // namespace gripscope
