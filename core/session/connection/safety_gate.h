// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace gripscope {

class GripperPort;

/// What the device itself allows; SI.
struct DeviceLimits {
    double maxForce_N = 0;
    double maxTravel_m = 0;
    std::size_t maxSamples = 0; ///< longest excitation it can hold
};

/// What the job at hand allows on top (the crush limit of the part); SI.
struct JobLimits {
    double maxForce_N = 0;
    double maxTravel_m = 0;
};

/// A force signal that passed the gate. Only the gate can make one, so nothing else can move the gripper.
class AdmittedExcitation {
public:
    [[nodiscard]] const std::vector<double>& force_N() const { return m_force_N; }
    [[nodiscard]] double maxForce_N() const { return m_limits.maxForce_N; }
    [[nodiscard]] double maxTravel_m() const { return m_limits.maxTravel_m; }

private:
    friend class SafetyGate;
    AdmittedExcitation(std::vector<double> force_N, JobLimits limits)
        : m_force_N(std::move(force_N)), m_limits(limits)
    {
    }
    std::vector<double> m_force_N;
    JobLimits m_limits;
};

/// Proof that a person asked for the gripper to be armed.
class ArmingOrder {
public:
    [[nodiscard]] const QString& person() const { return m_person; }

private:
    friend class SafetyGate;
    explicit ArmingOrder(QString person) : m_person(std::move(person)) {}
    QString m_person;
};

/// The one gate before the gripper. It holds the limits of the device and of the job, and refuses whatever is
/// above the lower of the two, is not finite, would pull, or comes before a person armed the gripper.
class SafetyGate {
public:
    explicit SafetyGate(GripperPort& port) : m_port(&port) {}

    void setJobLimits(const JobLimits& limits) { m_jobLimits = limits; }
    [[nodiscard]] JobLimits effectiveLimits() const; ///< the lower of device and job

    /// LimitExceeded, Usage (empty, too long, not finite, negative), NotArmed, DeviceRefused (a device that
    /// only listens).
    [[nodiscard]] Expected<void> arm(const QString& person);
    [[nodiscard]] Expected<void> start(const std::vector<double>& force_N);
    /// What the gripper was asked for last.
    struct Started {
        std::vector<double> force_N;
        std::uint64_t number = 0; ///< counted from 1; 0: nothing was started yet
    };
    [[nodiscard]] const Started& lastStarted() const { return m_started; }
    /// Ends a squeeze before its time: it only takes force away, so nothing is asked of it.
    void finish();
    void stop() noexcept;

    /// The check alone, for previews.
    [[nodiscard]] Expected<AdmittedExcitation> admit(const std::vector<double>& force_N) const;

private:
    GripperPort* m_port;
    JobLimits m_jobLimits{1e9, 1e9};
    Started m_started;
};

} // namespace gripscope
