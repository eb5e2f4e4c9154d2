// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/safety_gate.h"
#include "core/signal/excitation/excitation.h"
#include "devices/factory/gripper_factory.h"
#include "tests/support/patient_limits.h"

#include <QString>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace gripscope::test {

/// Waits until `condition` holds, looking often; false when it never does.
inline bool waitFor(const std::function<bool()>& condition, std::chrono::milliseconds atMost = patience)
{
    PatienceLeft left(atMost);
    while (!condition()) {
        if (left.isOver())
            return false;
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return true;
}

inline bool waitForState(GripperPort& port, LinkState state)
{
    return waitFor([&] { return port.state() == state; });
}

/// Bias and PRBS as a recipe has them, `samples` long.
inline std::vector<double> usualForce(std::size_t samples = 2000)
{
    ExcitationOptions options;
    options.samples = samples;
    return makeExcitation(options).value();
}

/// For tests that are not about the pauses of the program.
inline DeviceFactory patientFactory()
{
    DeviceFactory factory;
    factory.setLinkLimits(limitsForABusyProgram());
    return factory;
}

/// A port, opened, with a gate before it.
struct OpenPort {
    explicit OpenPort(std::unique_ptr<GripperPort> made) : port(std::move(made)), gate(*port)
    {
        port->open();
    }
    explicit OpenPort(const QString& address) : OpenPort(patientFactory().create(address).value()) {}

    /// Drains, tells the port that it is alive, and looks at `condition`, until it holds.
    bool pollUntil(const std::function<bool()>& condition)
    {
        return waitFor([&] {
            port->confirmAlive();
            const bool holds = condition(); // before draining: what it saw has been drained then
            port->drain(samples);
            return holds;
        });
    }
    bool ready()
    {
        return pollUntil([&] { return port->state() == LinkState::Ready; });
    }
    bool arm()
    {
        const auto ask = [this] { return gate.arm(QStringLiteral("tester")).has_value(); };
        // Asked for again where a busy computer let it fail; asking twice is harmless.
        return ask() && pollUntil([&] { return port->state() == LinkState::Armed || !ask(); }) &&
               port->state() == LinkState::Armed;
    }
    bool squeezeEnded() const
    {
        const SqueezeState state = port->squeezeState();
        return state == SqueezeState::Finished || state == SqueezeState::Stopped ||
               state == SqueezeState::Refused;
    }
    /// It ended, or there is nothing left that could: the gripper's watchdog disarmed it first.
    bool squeezeIsOver() const { return squeezeEnded() || port->state() != LinkState::Armed; }
    /// Opens, arms, squeezes to the end; the state the squeeze ended in.
    SqueezeState squeeze(const std::vector<double>& force_N)
    {
        if (port->state() != LinkState::Armed && !(ready() && arm()))
            return SqueezeState::Idle;
        if (!gate.start(force_N) || !pollUntil([&] { return squeezeEnded(); }))
            return SqueezeState::Idle;
        return port->squeezeState();
    }

    std::unique_ptr<GripperPort> port;
    SafetyGate gate;
    std::vector<Sample> samples; ///< all that was drained
};

/// A gripper of its own that has done what `squeezes` says; empty where none ever does. In real time a busy
/// computer may keep one waiting for so long that its watchdog trips: then it is another one's turn.
inline std::unique_ptr<OpenPort> gripperThat(const QString& address,
                                             const std::function<bool(OpenPort&)>& squeezes)
{
    constexpr int mostTries = 20;
    for (int tries = 0; tries < mostTries; ++tries) {
        auto gripper = std::make_unique<OpenPort>(address);
        if (squeezes(*gripper))
            return gripper;
        if (const auto error = gripper->port->lastError())
            qInfo("another one: %s", qPrintable(error->describe()));
    }
    return nullptr;
}

/// The samples taken while the excitation ran.
inline std::vector<Sample> samplesMoving(const std::vector<Sample>& samples)
{
    std::vector<Sample> out;
    for (const Sample& sample : samples)
        if (sample.status & StatusMoving)
            out.push_back(sample);
    return out;
}

} // namespace gripscope::test
