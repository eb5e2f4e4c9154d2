// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_firmware.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// Tries to pass the limits of force and travel, past the program by bytes and past the gate by force signals.

namespace {

constexpr std::int32_t deviceForce = 100'000;                                   ///< counts: 100 N
const std::uint64_t watchdogSamples = 2 * VirtualFirmwareOptions().watchdog_ms; ///< of 0.5 ms

/// A program that sends any command at any time, and a witness who only believes the answers and the sensor.
class Adversary {
public:
    explicit Adversary(std::uint64_t seed) : m_random(seed), m_firmware(options()) {}

    void act()
    {
        const CommandBody body = anyCommand();
        const Acknowledgement answer = send(body);
        const bool done = answer.result == CommandResult::Done;
        const bool arms = answer.command == ReportId::Arm;
        const bool ends = answer.command == ReportId::Stop || answer.command == ReportId::Disarm;
        if (!ends && (done || (answer.result == CommandResult::Repeated && !arms)))
            m_silence = 0; // nothing else tells the device that somebody is there
        if (arms)
            judgeArming(std::get<ArmCommand>(body).token, answer);
        m_armed = answer.status & StatusArmed;
        m_answered_us = answer.timestamp_us;
        if (answer.command == ReportId::SetLimits && done)
            m_limit = m_limits.maxForce;
        if (answer.command == ReportId::SetLimits && !done)
            ++refusedLimits;
        if (answer.command == ReportId::Start && done) {
            m_limitOfSqueeze = m_limit; // limits cannot be changed while it runs
            ++started;
        }
        const auto pause = any(0, 40) == 0 ? any(150, 400) : any(0, 12);
        for (int i = 0; i < pause; ++i)
            sample();
    }

    std::string broken; ///< what was seen that must not be
    int started = 0, refusedLimits = 0, pushed = 0, watchdogs = 0, lateArms = 0;

private:
    static VirtualFirmwareOptions options()
    {
        VirtualFirmwareOptions out;
        out.object = VirtualObject::exactly({0.04, 43, 9990});
        out.forceNoise_N = 0;
        out.positionNoise_m = 0;
        return out;
    }
    int any(int least, int most) { return std::uniform_int_distribution<int>(least, most)(m_random); }
    /// Allowed ones mostly, and those at, just above and far above each limit, and below nothing.
    std::int32_t anyForce()
    {
        switch (any(0, 60)) {
        case 0:
            return m_limit + 1;
        case 1:
            return deviceForce + 1;
        case 2:
            return std::numeric_limits<std::int32_t>::max();
        case 3:
            return -1;
        case 4:
            return std::numeric_limits<std::int32_t>::min();
        case 5:
            return m_limit;
        default:
            return any(0, m_limit);
        }
    }
    CommandBody anyCommand()
    {
        switch (any(0, 12)) {
        case 0:
        case 1:
            return ArmCommand{static_cast<std::uint32_t>(any(0, 7) == 0 ? m_token : any(0, 1000))};
        case 2:
            return any(0, 3) == 0 ? CommandBody(DisarmCommand{}) : CommandBody(HeartbeatCommand{});
        case 3:
            return any(0, 3) == 0 ? CommandBody(StopCommand{}) : CommandBody(HeartbeatCommand{});
        case 4:
            m_limits = {any(0, 9) == 0 ? anyForce() : any(1, deviceForce),
                        any(0, 9) == 0 ? any(-1, 1 << 20) : any(1, 1250)};
            return m_limits;
        case 5:
        case 6:
        case 7:
        case 8:
            return anyUpload();
        case 9:
        case 10:
        case 11:
            return StartCommand{m_excitation, static_cast<std::uint32_t>(m_forces.size()),
                                forcesCrc(m_forces)};
        default:
            return FinishCommand{m_excitation};
        }
    }
    CommandBody anyUpload()
    {
        if (any(0, 2) == 0 || m_forces.size() > 200) { // another excitation
            ++m_excitation;
            m_forces.clear();
        }
        UploadCommand chunk;
        chunk.excitationNumber = m_excitation;
        chunk.offset = static_cast<std::uint32_t>(m_forces.size());
        chunk.count = static_cast<std::uint8_t>(any(1, int(maxForcesPerUpload)));
        for (std::size_t i = 0; i < chunk.count; ++i)
            m_forces.push_back(chunk.forces[i] = anyForce());
        return chunk;
    }

    Acknowledgement send(const CommandBody& body)
    {
        m_firmware.receive(encode(Command{++m_number, body}), m_now_us);
        const Acknowledgement answer = std::get<Acknowledgement>(*decodeInput(m_firmware.outbox().back()));
        m_firmware.outbox().pop_back();
        watch();
        return answer;
    }
    void sample()
    {
        m_now_us += 500;
        ++m_silence;
        m_firmware.sample(m_now_us);
        watch();
    }
    void watch()
    {
        for (const Report& bytes : m_firmware.outbox()) {
            const StreamReport report = std::get<StreamReport>(*decodeInput(bytes));
            if (report.timestamp_us >= m_answered_us) // an older one may come behind an answer
                m_armed = report.status & StatusArmed;
            watchdogs += report.status & StatusWatchdog ? 1 : 0;
            for (std::size_t i = 0; i < report.count; ++i)
                judge(report, report.samples[i].force);
        }
        m_firmware.outbox().clear();
    }
    void judgeArming(std::uint32_t token, const Acknowledgement& answer)
    {
        const bool wasUsed = token != 0 && token == m_token;
        lateArms += wasUsed && !m_armed ? 1 : 0;
        if (wasUsed && !m_armed && answer.status & StatusArmed)
            broken = "armed twice by one wish";
        m_token = token == 0 ? m_token : token;
    }
    void judge(const StreamReport& report, std::int32_t force)
    {
        pushed += force > 0 ? 1 : 0;
        if (force > m_limitOfSqueeze || force > deviceForce)
            broken = "pushed above the limit";
        if (force < 0)
            broken = "pulled";
        if (force > 0 && !(report.status & StatusArmed && report.status & StatusMoving))
            broken = "pushed without being armed";
        if (force > 0 && m_silence > watchdogSamples + 2 * maxSamplesPerReport)
            broken = "pushed though nobody was there";
    }

    std::mt19937_64 m_random;
    VirtualFirmware m_firmware;
    std::uint64_t m_now_us = 0, m_silence = 0;
    std::uint16_t m_number = 0, m_excitation = 1;
    std::uint32_t m_token = 0;       ///< of the last Arm
    bool m_armed = false;            ///< by the last report
    std::uint32_t m_answered_us = 0; ///< the device's time of the last answer
    std::int32_t m_limit = deviceForce, m_limitOfSqueeze = 0;
    SetLimitsCommand m_limits;
    std::vector<std::int32_t> m_forces;
};

} // namespace

class LimitsTest : public QObject {
    Q_OBJECT
private slots:
    void noOrderOfCommandsPassesTheLimitsOfTheDevice()
    {
        int started = 0, refused = 0, pushed = 0, watchdogs = 0, lateArms = 0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Adversary adversary(seed);
            for (int i = 0; i < 4000; ++i) {
                adversary.act();
                QVERIFY2(adversary.broken.empty(), adversary.broken.c_str());
            }
            started += adversary.started;
            refused += adversary.refusedLimits;
            pushed += adversary.pushed;
            watchdogs += adversary.watchdogs;
            lateArms += adversary.lateArms;
        }
        // It did get to where limits matter.
        QVERIFY2(
            started > 1000 && pushed > 5000 && refused > 100 && watchdogs > 100 && lateArms > 100,
            qPrintable(
                u"%1 squeezes, %2 samples of force, %3 limits refused, %4 with the watchdog, %5 late Arms"_s
                    .arg(started)
                    .arg(pushed)
                    .arg(refused)
                    .arg(watchdogs)
                    .arg(lateArms)));
    }

    void aForceUpToTheLimitIsTakenAndNotPassed_data()
    {
        QTest::addColumn<double>("limit_N");
        QTest::newRow("between two counts, nearer the upper") << 10.0006;
        QTest::newRow("between two counts, nearer the lower") << 10.0004;
        QTest::newRow("no binary fraction") << 33.3;
        QTest::newRow("the device's own") << 100.0;
    }
    void aForceUpToTheLimitIsTakenAndNotPassed()
    {
        QFETCH(double, limit_N);
        OpenPort gripper(u"virtual:?speed=0&object=0.04,43,50000"_qs);
        gripper.gate.setJobLimits({limit_N, 0.02});
        QCOMPARE(gripper.squeeze(std::vector<double>(200, limit_N)), SqueezeState::Finished);
        constexpr double sensorNoise_N = 0.02;
        double most_N = 0;
        for (const Sample& sample : samplesMoving(gripper.samples))
            most_N = std::max(most_N, sample.force);
        // Of 200 normal deviates one is beyond 6 standard deviations once in a million runs.
        QVERIFY(most_N > limit_N - 6 * sensorNoise_N && most_N < limit_N + 6 * sensorNoise_N);
        QVERIFY(!gripper.gate.start(std::vector<double>(200, std::nextafter(limit_N, 1000))));
    }
};

GRIPSCOPE_TEST(LimitsTest)
#include "limits_test.moc"
