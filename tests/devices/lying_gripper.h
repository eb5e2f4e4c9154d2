// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/acquisition/gripscope_decoder.h"
#include "devices/acquisition/link_control.h"
#include "devices/virtual/virtual_firmware.h"
#include "tests/devices/port_helpers.h"

#include <algorithm>
#include <functional>

namespace gripscope::test {

/// What a gripper does that is not what it says. All of it from `since_ms` on.
struct Lies {
    bool dropsStops = false;      ///< Stop and Disarm have no effect...
    bool answersStops = false;    ///< ...though they are acknowledged as done
    bool hidesArmed = false;      ///< the stream says disarmed from the first Stop on, whatever is so
    bool hidesMoving = false;     ///< the moving bit is never set
    double forceTimes = 1;        ///< what the force channel shows, times so much
    double pushes_N = 0;          ///< a force that nobody asked for
    double creeps_m = 0;          ///< a way that nobody asked for
    bool silent = false;          ///< the stream ends; commands are answered
    bool damaged = false;         ///< stream reports with a wrong CRC
    int reportEvery_ms = 1;       ///< stream reports are held back
    bool foreignAnswers = false;  ///< to commands of somebody else
    bool fault = false;           ///< the fault bit, and goes on
    bool armsItself = false;      ///< armed bit without an Arm
    bool writeHangs = false;      ///< the next report that is written does not return
    bool feedsItself = false;     ///< its watchdog hears what was not sent
    bool losesArmAnswers = false; ///< what was done is not told
    std::int64_t since_ms = 0;
};

/// A gripper and the link to it, a millisecond at a time and in no time: an honest firmware, lies on its
/// wire, and what LinkControl makes of it, every command with its time.
class LyingGripper {
public:
    using Time = LinkControl::Time;
    struct Sent {
        std::int64_t ms = 0;
        protocol::ReportId id{};
        friend bool operator==(const Sent&, const Sent&) = default;
    };

    explicit LyingGripper(const Lies& lies, VirtualFirmwareOptions options = honest(),
                          const std::function<void(DeviceDescription&)>& says = {})
        : m_lies(lies), m_firmware(std::move(options)), m_assembler(0.001, 20e-6, 0.0005)
    {
        DeviceDescription device;
        device.measurement = *protocol::decodeMeasurement(*m_firmware.feature(0x11));
        device.limits = *protocol::decodeLimits(*m_firmware.feature(0x12));
        device.identity.commandable = true;
        device.identity.protocolMinor = protocol::versionMinor;
        device.identity.limits = {100, 0.025, 32768};
        if (says)
            says(device);
        control = LinkControl(device, {});
        m_port.said = device.identity;
    }
    static VirtualFirmwareOptions honest()
    {
        VirtualFirmwareOptions options;
        options.object = VirtualObject::exactly({0.04, 43, 9990});
        options.seed = 3;
        return options;
    }

    [[nodiscard]] Time now() const { return start + std::chrono::milliseconds(ms); }
    void run(std::int64_t milliseconds)
    {
        for (const std::int64_t end = ms + milliseconds; ms < end;)
            step();
    }
    bool runUntil(const std::function<bool()>& condition, std::int64_t atMost_ms = 5000)
    {
        for (const std::int64_t end = ms + atMost_ms; ms < end; step())
            if (condition())
                return true;
        return condition();
    }
    bool arm()
    {
        control.arm(now());
        return runUntil([&] { return control.armed(); }, 1000);
    }
    void tell(const Lies& lies)
    {
        m_lies = lies;
        m_lies.since_ms = ms;
    }
    [[nodiscard]] std::vector<Sent> sentSince(std::int64_t from_ms) const
    {
        std::vector<Sent> out;
        for (const Sent& one : sent)
            if (one.ms >= from_ms)
                out.push_back({one.ms - from_ms, one.id});
        return out;
    }
    [[nodiscard]] std::int64_t count(protocol::ReportId id, std::int64_t from_ms = 0) const
    {
        return std::count_if(sent.begin(), sent.end(),
                             [&](const Sent& one) { return one.id == id && one.ms >= from_ms; });
    }

    LinkControl control;
    std::vector<Sent> sent;
    std::int64_t ms = 0;
    bool alive = true;
    std::vector<Sample> samples;

    /// A squeeze between 10 and 30 N of so many samples, under limits of 40 N and 10 mm.
    void squeeze(std::size_t count = 20000)
    {
        SafetyGate gate(m_port);
        gate.setJobLimits({40, 0.01});
        control.start(gate.admit(usualForce(count)).value(), now());
    }

private:
    /// So that a gate admits the squeeze; nothing else is asked of it.
    struct Port : GripperPort {
        GripperIdentity said;
        void open() override {}
        void close() override {}
        LinkState state() const override { return LinkState::Armed; }
        std::optional<Error> lastError() const override { return {}; }
        GripperIdentity identity() const override { return said; }
        LinkCounters counters() const override { return {}; }
        std::size_t drain(std::vector<Sample>&, std::size_t) override { return 0; }
        void arm(const ArmingOrder&) override {}
        void disarm() override {}
        void startExcitation(const AdmittedExcitation&) override {}
        void finishExcitation() override {}
        SqueezeState squeezeState() const override { return SqueezeState::Idle; }
        void stop() noexcept override {}
        void confirmAlive() noexcept override {}
    };

    static constexpr Time start{std::chrono::hours(1)};

    [[nodiscard]] bool lying() const { return ms >= m_lies.since_ms; }
    void step()
    {
        ++ms;
        if (lying() && m_lies.feedsItself) {
            m_firmware.receive(protocol::encode(protocol::Command{39999, protocol::HeartbeatCommand{}}),
                               static_cast<std::uint64_t>(1000 * ms));
            m_firmware.outbox().pop_back();
        }
        for (int i = 0; i < 2; ++i)
            m_firmware.sample(static_cast<std::uint64_t>(1000 * ms - 500 + 500 * i));
        for (auto& out = m_firmware.outbox(); !out.empty(); out.pop_front())
            pass(out.front());
        if (lying() && m_lies.foreignAnswers)
            answerSomebodyElse();
        if (ms % m_lies.reportEvery_ms == 0 || !lying())
            flush();
        control.heard(now(), now());
        if (alive)
            m_aliveAt = now();
        while (!m_hangs) {
            const auto report = control.next(now(), m_aliveAt);
            if (!report)
                break;
            receive(*report);
        }
    }
    void pass(const protocol::Report& report)
    {
        const auto message = *protocol::decodeInput(report);
        if (const auto* answer = std::get_if<protocol::Acknowledgement>(&message)) {
            if (!(lying() && m_lies.losesArmAnswers && answer->command == protocol::ReportId::Arm))
                control.takeAnswer(*answer, now());
            return;
        }
        m_held.push_back(std::get<protocol::StreamReport>(message));
    }
    void flush()
    {
        for (protocol::StreamReport& report : m_held) {
            if (lying() && m_lies.silent)
                continue;
            if (lying() && m_lies.damaged) {
                control.takeBadReport(now());
                continue;
            }
            if (lying())
                distort(report);
            std::vector<Sample> batch;
            static_cast<void>(m_assembler.take(report, batch));
            samples.insert(samples.end(), batch.begin(), batch.end());
            control.takeSamples(batch, samples.size(), now());
            control.takeState(
                {report.status, report.timestamp_us, report.excitation, report.excitationNumber}, now());
        }
        m_held.clear();
    }
    void distort(protocol::StreamReport& report) const
    {
        const auto clear = [&](std::uint16_t bit) {
            report.status = static_cast<std::uint16_t>(report.status & ~bit);
        };
        if (m_lies.hidesArmed && m_stopsCame > 0)
            clear(StatusArmed);
        if (m_lies.hidesMoving)
            clear(StatusMoving);
        if (m_lies.fault)
            report.status |= StatusFault;
        if (m_lies.armsItself)
            report.status |= StatusArmed;
        for (protocol::RawSample& sample : report.samples) {
            sample.force =
                static_cast<std::int32_t>(m_lies.forceTimes * sample.force + 1000 * m_lies.pushes_N);
            sample.position += static_cast<std::int32_t>(m_lies.creeps_m / 20e-6);
        }
    }
    void receive(const protocol::Report& report)
    {
        const auto id = static_cast<protocol::ReportId>(report[0]);
        sent.push_back({ms, id});
        m_hangs = lying() && m_lies.writeHangs;
        if (m_hangs)
            return;
        const bool stop = id == protocol::ReportId::Stop || id == protocol::ReportId::Disarm;
        m_stopsCame += stop ? 1 : 0;
        if (stop && lying() && m_lies.dropsStops) {
            if (m_lies.answersStops)
                control.takeAnswer(doneFor(report), now());
            return;
        }
        m_firmware.receive(report, static_cast<std::uint64_t>(1000 * ms));
        for (auto& out = m_firmware.outbox(); !out.empty(); out.pop_front())
            pass(out.front());
    }
    [[nodiscard]] protocol::Acknowledgement doneFor(const protocol::Report& report) const
    {
        protocol::Acknowledgement answer;
        answer.commandNumber = static_cast<std::uint16_t>(report[2] | report[3] << 8);
        answer.command = static_cast<protocol::ReportId>(report[0]);
        answer.timestamp_us = static_cast<std::uint32_t>(1000 * ms);
        return answer;
    }
    void answerSomebodyElse()
    {
        protocol::Acknowledgement answer;
        answer.commandNumber = 40000;
        answer.command = protocol::ReportId::Heartbeat;
        answer.timestamp_us = static_cast<std::uint32_t>(1000 * ms);
        control.takeAnswer(answer, now());
    }

    Lies m_lies;
    Port m_port;
    VirtualFirmware m_firmware;
    protocol::StreamAssembler m_assembler;
    std::vector<protocol::StreamReport> m_held;
    Time m_aliveAt = start;
    int m_stopsCame = 0;
    bool m_hangs = false;
};

} // namespace gripscope::test
