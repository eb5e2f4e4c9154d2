// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/session/connection/gripper_return.h"

#include <QMap>

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <random>
#include <utility>

namespace gripscope::test {

/// What the fake device does, changed by a test at any time; shared with the port that a session owns.
struct FakeGripper {
    GripperIdentity identity;
    LinkState state = LinkState::Closed;
    SqueezeState squeezeState = SqueezeState::Idle;
    std::optional<Error> error;
    LinkCounters counters;
    MassDampingStiffness object{0.0396, 43.0, 9990.0};
    /// The positions under a force, sample by sample, where they are not the object's.
    std::function<std::vector<double>(const std::vector<double>&)> moves;
    double noise_m = 1e-6;
    double forceGain = 1; ///< of what its force sensor says over what it was told to press
    double trueLag_s = 0; ///< of the position channel, whatever the identity says

    bool opensAtOnce = true;
    bool refusesExcitation = false;
    bool neverStarts = false; ///< takes the excitation and does nothing
    bool armsOnRequest = true;
    bool obeysStop = true;
    StopState stopState = StopState::None;
    std::optional<Error> disarmReason;
    bool finishesOnRequest = true;
    std::function<bool()> holdsBack;     ///< true: samples wait, as if the squeeze stood still
    std::optional<int> lostAfterSamples; ///< goes away after so many samples of a squeeze
    std::function<bool(int)> dropSample; ///< true: the sample with this index in the squeeze is lost
    int chunk = 100;                     ///< samples handed over a drain()

    int opened = 0, closed = 0, armRequests = 0, disarmRequests = 0, started = 0, finished = 0, confirmed = 0;
    std::atomic<int> stops{0};
    QString armedBy;
    std::vector<double> commanded_N;
    double admittedMaxForce_N = 0;

    std::vector<Sample> pending;
    std::uint64_t sequence = 0;
    std::mt19937_64 random{7};

    FakeGripper()
    {
        identity.address = QStringLiteral("fake:");
        identity.serial = QStringLiteral("F-1");
        identity.name = QStringLiteral("Fake gripper");
        identity.firmware = QStringLiteral("1.2");
        identity.limits = {100, 0.05, 20000};
        identity.commandable = true;
    }

    /// One sample at rest or in a squeeze.
    void push(double force, double position, std::uint16_t status)
    {
        const std::uint64_t number = sequence++;
        pending.push_back(
            {number, static_cast<double>(number) * identity.sampleTime_s, force, position, status});
    }
    void skip()
    {
        ++sequence;
        ++counters.lostSamples;
    }

    /// Bounded, centred, with the deviation asked for: the sum of twelve uniform numbers.
    double noise()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += static_cast<double>(random() >> 11) * 0x1.0p-53;
        return noise_m * sum;
    }

    /// What was to come of the squeeze does not come; it ends with 50 samples at rest.
    void finishSqueeze()
    {
        const auto moving = [](const Sample& sample) { return sample.status & StatusMoving; };
        if (std::none_of(pending.begin(), pending.end(), moving))
            return;
        sequence = pending.front().sequence;
        const Sample last = pending.front();
        pending.clear();
        for (int i = 0; i < 50; ++i)
            push(commanded_N.front(), last.position + noise(), StatusArmed);
    }

    /// The whole squeeze in one go: 50 samples at rest, the excitation, 50 at rest.
    void runSqueeze()
    {
        const double rest_N = commanded_N.empty() ? 0 : commanded_N.front();
        std::vector<double> force(50, rest_N);
        force.insert(force.end(), commanded_N.begin(), commanded_N.end());
        force.insert(force.end(), 50, rest_N);
        SimulationOptions options;
        options.sampleTime_s = identity.sampleTime_s;
        options.x0 = rest_N / object.k;
        options.lag_s = trueLag_s;
        const std::vector<double> position = moves ? moves(force) : simulate(object, force, options);
        for (int i = 0; i < static_cast<int>(force.size()); ++i) {
            const int inside = i - 50;
            const bool moving = inside >= 0 && inside < static_cast<int>(commanded_N.size());
            if (moving && lostAfterSamples && inside >= *lostAfterSamples)
                return;
            if (moving && dropSample && dropSample(inside)) {
                skip();
                continue;
            }
            push(forceGain * force[static_cast<std::size_t>(i)],
                 position[static_cast<std::size_t>(i)] + noise(),
                 static_cast<std::uint16_t>(StatusArmed | (moving ? StatusMoving : 0)));
        }
    }
};

class FakeGripperPort : public GripperPort {
public:
    explicit FakeGripperPort(std::shared_ptr<FakeGripper> gripper) : m_gripper(std::move(gripper)) {}

    void open() override
    {
        ++m_gripper->opened;
        m_gripper->state = m_gripper->opensAtOnce ? LinkState::Ready : LinkState::Opening;
    }
    void close() override
    {
        ++m_gripper->closed;
        m_gripper->state = LinkState::Closed;
    }
    LinkState state() const override { return m_gripper->state; }
    std::optional<Error> lastError() const override { return m_gripper->error; }
    GripperIdentity identity() const override { return m_gripper->identity; }
    LinkCounters counters() const override { return m_gripper->counters; }

    std::size_t drain(std::vector<Sample>& samples, std::size_t most) override
    {
        FakeGripper& g = *m_gripper;
        if (g.holdsBack && g.holdsBack())
            return 0;
        const std::size_t count = std::min({most, g.pending.size(), static_cast<std::size_t>(g.chunk)});
        samples.insert(samples.end(), g.pending.begin(),
                       g.pending.begin() + static_cast<std::ptrdiff_t>(count));
        g.pending.erase(g.pending.begin(), g.pending.begin() + static_cast<std::ptrdiff_t>(count));
        if (g.pending.empty() && g.squeezeState == SqueezeState::Running && !g.neverStarts) {
            if (g.lostAfterSamples) {
                g.state = LinkState::Lost;
                g.error = Error{ErrorCode::DeviceLost, {g.identity.address, QStringLiteral("unplugged")}};
                g.squeezeState = SqueezeState::Stopped;
            } else {
                g.squeezeState = SqueezeState::Finished;
            }
        }
        return count;
    }

    void arm(const ArmingOrder& order) override
    {
        ++m_gripper->armRequests;
        m_gripper->armedBy = order.person();
        if (m_gripper->armsOnRequest)
            m_gripper->state = LinkState::Armed;
    }
    void disarm() override
    {
        ++m_gripper->disarmRequests;
        if (m_gripper->state == LinkState::Armed)
            m_gripper->state = LinkState::Ready;
    }
    void startExcitation(const AdmittedExcitation& excitation) override
    {
        FakeGripper& g = *m_gripper;
        ++g.started;
        g.commanded_N = excitation.force_N();
        g.admittedMaxForce_N = excitation.maxForce_N();
        g.squeezeState = g.refusesExcitation ? SqueezeState::Refused : SqueezeState::Running;
        if (!g.refusesExcitation && !g.neverStarts)
            g.runSqueeze();
    }
    void finishExcitation() override
    {
        ++m_gripper->finished;
        if (m_gripper->finishesOnRequest)
            m_gripper->finishSqueeze();
    }
    SqueezeState squeezeState() const override { return m_gripper->squeezeState; }
    void stop() noexcept override
    {
        ++m_gripper->stops;
        if (!m_gripper->obeysStop) {
            m_gripper->stopState = StopState::NotObeyed;
            return;
        }
        if (m_gripper->squeezeState == SqueezeState::Running ||
            m_gripper->squeezeState == SqueezeState::Uploading)
            m_gripper->squeezeState = SqueezeState::Stopped;
        if (m_gripper->state == LinkState::Armed)
            m_gripper->state = LinkState::Ready;
    }
    StopState stopState() const override { return m_gripper->stopState; }
    std::optional<Error> disarmReason() const override { return m_gripper->disarmReason; }
    void confirmAlive() noexcept override { ++m_gripper->confirmed; }

private:
    std::shared_ptr<FakeGripper> m_gripper;
};

/// What is looked out for, and whether it is there again.
struct FakeReturn {
    std::optional<AwaitedGripper> awaited;
    bool looking = false;
    std::shared_ptr<FakeGripper> there; ///< taken once
};

class FakeGripperReturn : public GripperReturn {
public:
    explicit FakeGripperReturn(std::shared_ptr<FakeReturn> fake) : m_fake(std::move(fake))
    {
        m_fake->looking = true;
    }
    ~FakeGripperReturn() override { m_fake->looking = false; }
    std::unique_ptr<GripperPort> take() override
    {
        const std::shared_ptr<FakeGripper> gripper = std::exchange(m_fake->there, nullptr);
        return gripper ? std::make_unique<FakeGripperPort>(gripper) : nullptr;
    }

private:
    std::shared_ptr<FakeReturn> m_fake;
};

class FakeGripperFactory : public GripperPortFactory {
public:
    std::shared_ptr<FakeGripper> gripper = std::make_shared<FakeGripper>();
    std::shared_ptr<FakeReturn> comeback = std::make_shared<FakeReturn>();
    std::optional<Error> refuses;

    Expected<std::unique_ptr<GripperPort>> create(const QString&) override
    {
        if (refuses)
            return tl::unexpected<Error>(*refuses);
        return std::make_unique<FakeGripperPort>(gripper);
    }
    std::unique_ptr<GripperReturn> awaitReturn(const AwaitedGripper& awaited) override
    {
        comeback->awaited = awaited;
        return std::make_unique<FakeGripperReturn>(comeback);
    }
};

} // namespace gripscope::test
