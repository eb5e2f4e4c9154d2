// SPDX-License-Identifier: GPL-3.0-or-later
// A gripper that measures wrongly, from its reports to the verdict on the part.
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/connection/connect_session.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/signal/recording/stream_account.h"
#include "devices/acquisition/device_port.h"
#include "devices/protocol/codec.h"
#include "devices/virtual/virtual_transport.h"
#include "tests/devices/port_helpers.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// What it says is changed on its way.
struct Lie {
    std::function<void(protocol::StreamReport&)> report = [](protocol::StreamReport&) {};
    std::function<void(protocol::MeasurementFeature&)> description = [](protocol::MeasurementFeature&) {};
};

class LyingTransport : public Transport {
public:
    LyingTransport(const VirtualAddress& address, Lie lie)
        : m_inner(*VirtualTransport::make(address)), m_lie(std::move(lie))
    {
    }
    Expected<void> open() override { return m_inner->open(); }
    Expected<protocol::Report> feature(protocol::ReportId id) override
    {
        Expected<protocol::Report> report = m_inner->feature(id);
        if (!report || id != protocol::ReportId::Measurement)
            return report;
        protocol::MeasurementFeature measurement = protocol::decodeMeasurement(*report).value();
        m_lie.description(measurement);
        return protocol::encode(measurement);
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        const ReadResult result = m_inner->read(buffer, timeout);
        if (result.outcome != Outcome::Report)
            return result;
        const auto message = protocol::decodeInput(protocol::ReportView(buffer).first(result.size));
        if (message && std::holds_alternative<protocol::StreamReport>(*message)) {
            protocol::StreamReport stream = std::get<protocol::StreamReport>(*message);
            m_lie.report(stream);
            const protocol::Report changed = protocol::encode(stream);
            std::copy(changed.begin(), changed.end(), buffer.begin());
        }
        return result;
    }
    bool write(const protocol::Report& report) override { return m_inner->write(report); }
    void close() noexcept override { m_inner->close(); }
    bool streamsAlways() const override { return m_inner->streamsAlways(); }
    bool keepsComputerTime() const override { return m_inner->keepsComputerTime(); }

private:
    std::shared_ptr<VirtualTransport> m_inner;
    const Lie m_lie;
};

class LyingFactory : public GripperPortFactory {
public:
    LyingFactory(VirtualAddress address, Lie lie) : m_address(std::move(address)), m_lie(std::move(lie)) {}
    Expected<std::unique_ptr<GripperPort>> create(const QString& address) override
    {
        return std::make_unique<DevicePort>(
            address, [this] { return std::make_shared<LyingTransport>(m_address, m_lie); });
    }

private:
    VirtualAddress m_address;
    Lie m_lie;
};

/// A program on such a gripper.
struct Squeezer {
    explicit Squeezer(const VirtualAddress& address, const Lie& lie = {}) : factory(address, lie) {}
    LyingFactory factory;
    ConnectSession connection{factory};
    SqueezeJob job{connection};

    void poll()
    {
        connection.poll();
        job.poll();
    }
    bool until(const std::function<bool()>& condition)
    {
        return waitFor([&] {
            poll();
            return condition();
        });
    }
    bool armed()
    {
        if (!connection.connectTo(u"virtual:"_s) ||
            !until([&] { return connection.state() == ConnectSession::State::Connected; }))
            return false;
        return connection.arm(u"tester"_s).has_value() && until([&] { return connection.armed(); });
    }
    [[nodiscard]] bool ended() const
    {
        return job.state() == SqueezeJob::State::Done || job.state() == SqueezeJob::State::Failed;
    }
    bool squeeze()
    {
        return job.start(Recipe{}, 1).has_value() && until([&] { return ended(); });
    }
};

Verdict judged(const Recording& recording)
{
    static const TypeModels models = fitTypeModels(paperSqueezesInSi());
    IdentificationOptions options;
    options.assess = false;
    const Identification found = identify(recording, options);
    return judge(models, found, identifiedSqueeze({}, found, recording.forceUnit, recording.positionUnit));
}

QString inWords(const Verdict& verdict)
{
    return u"%1 %2, %3: %4 | %5"_s.arg(
        toString(verdict.kind), verdict.type, toString(verdict.validity.verdict),
        verdict.validity.checksFailed.join(u' '), described(verdict.allReasons()).join(u' '));
}

/// The force channel's counts are 1 mN, the position's 20 um.
Lie clipped(std::int32_t protocol::RawSample::*channel, std::int32_t lowest, std::int32_t highest,
            std::uint16_t flag)
{
    return {[=](protocol::StreamReport& report) {
        for (std::size_t i = 0; i < report.count; ++i) {
            std::int32_t& value = report.samples[i].*channel;
            const std::int32_t before = value;
            const bool moving = (report.status & StatusMoving) != 0;
            if (moving)
                value = std::clamp(value, lowest, highest);
            if (value != before)
                report.status |= flag;
        }
    }};
}

Lie stuckPosition(std::uint32_t movingBefore)
{
    auto seen = std::make_shared<std::uint32_t>(0);
    auto held = std::make_shared<std::optional<std::int32_t>>();
    return {[=](protocol::StreamReport& report) {
        for (std::size_t i = 0; i < report.count; ++i) {
            if ((report.status & StatusMoving) == 0)
                continue;
            if (++*seen > movingBefore) {
                if (!held->has_value())
                    *held = report.samples[i].position;
                report.samples[i].position = **held;
            }
        }
    }};
}

Lie faultFrom(std::uint32_t moving)
{
    auto seen = std::make_shared<std::uint32_t>(0);
    return {[=](protocol::StreamReport& report) {
        if ((report.status & StatusMoving) != 0 && ++*seen > moving && *seen < moving + 50)
            report.status |= StatusFault;
    }};
}

Lie statedSampleTime(double factor)
{
    Lie lie;
    lie.description = [factor](protocol::MeasurementFeature& measurement) {
        measurement.sampleTime_s *= factor;
    };
    return lie;
}

constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();

} // namespace

Q_DECLARE_METATYPE(Lie)

class UntrueMeasurementTest : public QObject {
    Q_OBJECT
private slots:
    void isRefusedOrDoubtedByName_data()
    {
        QTest::addColumn<Lie>("lie");
        QTest::addColumn<QString>("fault"); ///< of the virtual gripper
        QTest::addColumn<QString>("validity");
        QTest::addColumn<QString>("failed");
        const auto row = [](const char* name, const Lie& lie, const QString& fault, const QString& validity,
                            const QString& failed) {
            QTest::newRow(name) << lie << fault << validity << failed;
        };
        using protocol::RawSample;
        const QString invalid = u"invalid"_s, suspect = u"suspect"_s;
        // 20 N and 10 more or less; the object moves from 50 to 150 counts about the 617th.
        row("nothing", {}, {}, u"valid"_s, {});
        row("force clipped high, marked", {}, u"&fault=saturate:25"_s, invalid, u"saturation"_s);
        row("force clipped high, unmarked", clipped(&RawSample::force, least, 25000, 0), {}, invalid,
            u"saturation"_s);
        row("force clipped low, marked", clipped(&RawSample::force, 15000, most, StatusForceSaturated), {},
            invalid, u"saturation"_s);
        row("force clipped low, unmarked", clipped(&RawSample::force, 15000, most, 0), {}, invalid,
            u"saturation"_s);
        row("position clipped high, marked",
            clipped(&RawSample::position, least, 735, StatusPositionSaturated), {}, invalid, u"saturation"_s);
        row("position clipped high, unmarked", clipped(&RawSample::position, least, 735, 0), {}, invalid,
            u"saturation"_s);
        row("position clipped low, marked", clipped(&RawSample::position, 700, most, StatusPositionSaturated),
            {}, invalid, u"saturation"_s);
        row("position clipped low, unmarked", clipped(&RawSample::position, 700, most, 0), {}, invalid,
            u"saturation"_s);
        row("stuck from the start", {}, u"&fault=stuck"_s, invalid, u"stuck"_s);
        row("stuck midway", stuckPosition(900), {}, invalid, u"stuck"_s);
        row("sample time stated double", statedSampleTime(2), {}, invalid, u"sample_time"_s);
        row("sample time stated half", statedSampleTime(0.5), {}, invalid, u"sample_time"_s);
        row("sample time stated 3 % long", statedSampleTime(1.03), {}, invalid, u"sample_time"_s);
        row("2 % lost", {}, u"&fault=loss:0.02"_s, suspect, u"samples_lost"_s);
    }
    void isRefusedOrDoubtedByName()
    {
        QFETCH(Lie, lie);
        QFETCH(QString, fault);
        QFETCH(QString, validity);
        QFETCH(QString, failed);
        const auto address = parseDeviceAddress(u"virtual:?object=A&seed=5&speed=0"_s + fault);
        QVERIFY(address);
        Squeezer squeezer(std::get<VirtualAddress>(*address), lie);
        QVERIFY(squeezer.armed() && squeezer.squeeze());
        QVERIFY2(squeezer.job.state() == SqueezeJob::State::Done, qPrintable(whyNot(squeezer.job.error())));
        const Verdict verdict = judged(squeezer.job.recording());
        QVERIFY2(toString(verdict.validity.verdict) == validity, qPrintable(inWords(verdict)));
        QCOMPARE(verdict.kind == VerdictKind::Invalid, validity == u"invalid"_s);
        QCOMPARE(verdict.validity.checksFailed.isEmpty(), failed.isEmpty());
        if (failed.isEmpty())
            return;
        QVERIFY2(verdict.validity.checksFailed.contains(failed), qPrintable(inWords(verdict)));
        QVERIFY(!verdict.validity.reasons.empty() && !verdict.validity.reasons[0].describe().contains(u'_'));
    }

    void aFaultEndsTheSqueezeWithItsName()
    {
        const auto address = parseDeviceAddress(u"virtual:?object=A&seed=5&speed=0"_s);
        QVERIFY(address);
        Squeezer squeezer(std::get<VirtualAddress>(*address), faultFrom(300));
        QVERIFY(squeezer.armed() && squeezer.squeeze());
        QVERIFY(squeezer.job.state() == SqueezeJob::State::Failed);
        QVERIFY2(squeezer.job.error()->describe().contains(u"it reports a fault"),
                 qPrintable(squeezer.job.error()->describe()));
    }

    void aWrongClockIsRefusedOrDoubted()
    {
        // In real time, since it is the computer's that tells; all at once, since it takes a while.
        struct Case {
            double rate;
            QString validity;
            std::unique_ptr<Squeezer> squeezer = {};
            int squeezes = 0;
            bool done = false;
            Verdict verdict = {};
            double m = 0;
        };
        std::vector<Case> cases;
        for (const double size : {0.005, 0.015, 0.055, 0.1})
            for (const double rate : {size, -size})
                cases.push_back({rate, size > 0.01 ? u"invalid"_s : u"suspect"_s});
        cases.push_back({0, u"valid"_s});
        for (Case& each : cases) {
            const auto address = parseDeviceAddress(
                u"virtual:?object=0.0396,43,9990&seed=5&fault=clock-rate:%1"_s.arg(each.rate));
            QVERIFY(address);
            each.squeezer = std::make_unique<Squeezer>(std::get<VirtualAddress>(*address));
            QVERIFY(each.squeezer->armed());
        }
        const auto certain = [](const Case& each, const ClockAccount& clocks) {
            const double limit_ppm = std::abs(each.rate) > 0.01 ? 10000 : 1000;
            return clocks.clock &&
                   (each.rate != 0 ? clocks.clock->beyond(limit_ppm) : clocks.clock->uncertainty_ppm < 2000);
        };
        const auto follow = [&](Case& each) {
            Squeezer& squeezer = *each.squeezer;
            squeezer.poll();
            if (each.done)
                return;
            if (squeezer.job.state() == SqueezeJob::State::Done) {
                const auto account = streamAccount(squeezer.job.recording());
                QVERIFY(account && account->clocks.compared);
                if (certain(each, account->clocks) || each.squeezes == 5) {
                    each.done = true;
                    return;
                }
            }
            const bool idle = squeezer.job.state() == SqueezeJob::State::Idle || squeezer.ended();
            // While another one was armed nobody polled this one, whose watchdog took that for a frozen
            // screen.
            if (idle && !squeezer.connection.armed())
                static_cast<void>(squeezer.connection.arm(u"tester"_s));
            if (idle && squeezer.connection.armed() && certain(each, squeezer.connection.counters().clocks)) {
                ++each.squeezes;
                QVERIFY(squeezer.job.start(Recipe{}, 1));
            }
        };
        QVERIFY(waitFor([&] {
            for (Case& each : cases)
                follow(each);
            return std::all_of(cases.begin(), cases.end(), [](const Case& each) { return each.done; });
        }));
        for (Case& each : cases) {
            const Recording& recording = each.squeezer->job.recording();
            each.verdict = judged(recording);
            const QString words = u"%1: %2"_s.arg(each.rate).arg(inWords(each.verdict));
            QVERIFY2(toString(each.verdict.validity.verdict) == each.validity, qPrintable(words));
            QCOMPARE(each.verdict.kind == VerdictKind::Invalid, each.validity == u"invalid"_s);
            QVERIFY2(each.verdict.validity.checksFailed.contains(u"clock"_s) == (each.rate != 0),
                     qPrintable(words));
            QVERIFY2(!each.verdict.validity.checksFailed.contains(u"sample_time"_s), qPrintable(words));
            // The physics runs in true time: m comes out wrong by the square of the clock's error.
            const Identification found = identify(recording);
            QVERIFY(found.best());
            const double off = found.best()->parameters->m / 0.0396 - 1;
            const double expected = (1 + each.rate) * (1 + each.rate) - 1;
            // Twice what the noise leaves of m.
            QVERIFY2(std::abs(off - expected) < 0.025, qPrintable(u"%1: m %2"_s.arg(each.rate).arg(off)));
        }
    }

    void aTimeOfItsOwnIsNotCompared_data()
    {
        QTest::addColumn<QString>("speed");
        QTest::newRow("as fast as it can") << u"speed=0"_s;
        QTest::newRow("five times") << u"speed=5"_s;
    }
    void aTimeOfItsOwnIsNotCompared()
    {
        QFETCH(QString, speed);
        const auto address = parseDeviceAddress(u"virtual:?object=A&seed=5&"_s + speed);
        Squeezer squeezer(std::get<VirtualAddress>(*address));
        QVERIFY(squeezer.armed() && squeezer.squeeze());
        const auto account = streamAccount(squeezer.job.recording());
        QVERIFY(account && !account->clocks.compared && !account->clocks.clock);
        QVERIFY(judged(squeezer.job.recording()).validity.verdict == ValidityVerdict::Valid);
    }
};

GRIPSCOPE_TEST(UntrueMeasurementTest)
#include "untrue_measurement_test.moc"
