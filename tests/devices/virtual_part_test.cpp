// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/research/real_part.h"
#include "core/signal/excitation/excitation.h"
#include "devices/virtual/virtual_part.h"
#include "tests/devices/bare_device.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// Parts and grippers that are not ideal, against a simulator that shares nothing with them.

namespace {

constexpr MassDampingStiffness canA{0.0396, 43, 9990};

std::vector<double> fourLevels(double sampleTime_s, std::size_t samples)
{
    ExcitationOptions options;
    options.kind = ExcitationKind::FourLevel;
    options.sampleTime_s = sampleTime_s;
    options.samples = samples;
    options.bit_s = std::max(0.005, sampleTime_s);
    return makeExcitation(options).value();
}

std::vector<double> timesOf(std::size_t samples, double sampleTime_s)
{
    std::vector<double> times;
    for (std::size_t i = 0; i < samples; ++i)
        times.push_back(static_cast<double>(i) * sampleTime_s);
    return times;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// The bytes of one squeeze by `forces`, as a recording.
Recording squeezed(VirtualFirmwareOptions options, const std::vector<double>& forces_N)
{
    options.forceNoise_N = 0;
    options.hasWatchdog = false;
    BareDevice device(std::move(options));
    std::vector<std::int32_t> counts;
    for (const double force : forces_N)
        counts.push_back(static_cast<std::int32_t>(std::lround(force / VirtualFirmware::forcePerCount_N)));
    device.send(ArmCommand{1});
    device.upload(counts, 1);
    device.start(counts, 1);
    device.stream.clear();
    while (device.firmware.busy())
        device.run(100, false);
    Recording recording;
    recording.sampleTime_s = device.firmware.sampleTime_s();
    recording.hold = ForceHold::Zero;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    for (const StreamReport& report : device.stream)
        for (std::size_t i = 0; i < report.count && (report.status & StatusMoving); ++i) {
            recording.time_s.push_back(static_cast<double>(recording.size()) * recording.sampleTime_s);
            recording.force.push_back(report.samples[i].force * VirtualFirmware::forcePerCount_N);
            recording.position.push_back(report.samples[i].position * VirtualFirmware::positionPerCount_m);
        }
    return recording;
}

VirtualFirmwareOptions ofCanA(const VirtualTerms& terms)
{
    VirtualFirmwareOptions options;
    options.object = VirtualObject::exactly(canA);
    options.terms = terms;
    return options;
}

/// None: without a value, so that no comparison with it holds.
FurtherParameter parameterOf(const Identification& found, MotionParameter parameter)
{
    for (const FurtherParameter& one : found.budget.further)
        if (one.parameter == parameter)
            return one;
    FurtherParameter none;
    none.value = std::numeric_limits<double>::quiet_NaN();
    return none;
}

bool isWithin(const FurtherParameter& found, double truth, double most)
{
    const double deviation = found.combined.standardUncertainty;
    return std::abs(found.value - truth) < 4 * deviation && deviation < most;
}

} // namespace

Q_DECLARE_METATYPE(VirtualTerms)

class VirtualPartTest : public QObject {
    Q_OBJECT
private slots:
    void itMovesAsAnIndependentSimulatorSays_data()
    {
        QTest::addColumn<VirtualTerms>("terms");
        QTest::addColumn<double>("sampleTime_s");
        const auto row = [](const char* name, VirtualTerms terms, double sampleTime_s = 0.0005) {
            QTest::newRow(name) << terms << sampleTime_s;
        };
        row("ideal", {});
        row("friction", {.friction_N = 0.5});
        row("a worn gripper", {.ownFriction_N = 1.5});
        row("friction of both", {.friction_N = 0.5, .ownFriction_N = 1.5});
        row("yields", {.relaxingShare = 0.3, .relaxationTime_s = 0.05});
        row("yields fast", {.relaxingShare = 0.3, .relaxationTime_s = 0.002});
        row("stiffens", {.cubic = 1e9});
        row("softens", {.cubic = -2e8});
        row("all of it", {.friction_N = 0.3,
                          .ownFriction_N = 0.2,
                          .relaxingShare = 0.2,
                          .relaxationTime_s = 0.03,
                          .cubic = 5e8});
        row("slow, ideal", {}, 0.01);
        row("slow, yields at once", {.relaxingShare = 0.2, .relaxationTime_s = 0.0005}, 0.01);
        row("slow, all of it",
            {.friction_N = 0.3, .relaxingShare = 0.2, .relaxationTime_s = 0.03, .cubic = 5e8}, 0.01);
    }
    void itMovesAsAnIndependentSimulatorSays()
    {
        QFETCH(VirtualTerms, terms);
        QFETCH(double, sampleTime_s);
        std::vector<double> force = fourLevels(sampleTime_s, 400);
        force.front() = 0; // from rest without force, as the part begins
        VirtualPart part(canA, terms, sampleTime_s);
        std::vector<double> moved;
        for (const double f : force) {
            moved.push_back(part.position_m());
            part.advance(f);
        }
        RealPart real{canA.m, canA.b, canA.k};
        real.friction = terms.friction_N + terms.ownFriction_N;
        real.relaxing = terms.relaxingShare * canA.k;
        if (terms.relaxingShare > 0)
            real.relaxationTime_s = terms.relaxationTime_s;
        real.cubic = terms.cubic;
        const std::vector<double> times = timesOf(force.size(), sampleTime_s);
        const std::vector<double> truth = simulateRealPart(real, times, force, ForceHold::Zero, times, 1e-6);
        // The simulator is exact to 1e-6 of a motion of 3 mm.
        QVERIFY2(largestDifference(moved, truth) < 1e-8,
                 qPrintable(QString::number(largestDifference(moved, truth))));
    }

    void aLaterPositionIsWhereItWouldBe()
    {
        for (const VirtualTerms& terms :
             {VirtualTerms{},
              VirtualTerms{.friction_N = 0.5, .relaxingShare = 0.2, .relaxationTime_s = 0.03}}) {
            VirtualPart part(canA, terms, 0.0005);
            part.advance(20);
            part.advance(20);
            const double later = part.positionAfter(0.0005, 5);
            const double now = part.positionAfter(0, 5);
            QCOMPARE(now, part.position_m());
            part.advance(5);
            QVERIFY(std::abs(later - part.position_m()) < 1e-12);
            QVERIFY(later != now);
        }
    }

    void whatIsTooStiffOrCollapsesStaysANumber()
    {
        const MassDampingStiffness stiff{1e-6, 1e6, 1e9};
        VirtualPart hard(stiff, {.friction_N = 0.1, .relaxingShare = 100, .relaxationTime_s = 1e-4}, 0.05);
        VirtualPart soft(canA, {.cubic = -1e15}, 0.0005);
        for (int i = 0; i < 200; ++i)
            for (VirtualPart* part : {&hard, &soft}) {
                part->advance(20);
                QVERIFY(std::isfinite(part->position_m()));
                QVERIFY(std::isfinite(part->positionAfter(1e-4, 20)));
            }
    }

    void frictionYieldingAndABentSpringAreFoundInWhatItSends()
    {
        const std::vector<double> force = fourLevels(0.0005, 2000);
        const Identification worn =
            identify(squeezed(ofCanA({.friction_N = 0.4, .ownFriction_N = 0.6}), force), {});
        QCOMPARE(toString(worn.recommended), u"friction"_s);
        QVERIFY(isWithin(parameterOf(worn, MotionParameter::Friction), 1, 0.05));
        const Identification foam =
            identify(squeezed(ofCanA({.relaxingShare = 0.3, .relaxationTime_s = 0.05}), force), {});
        QCOMPARE(toString(foam.recommended), u"zener"_s);
        QVERIFY(isWithin(parameterOf(foam, MotionParameter::RelaxationTime), 0.05, 0.005));
        const Identification rubber = identify(squeezed(ofCanA({.cubic = 1e9}), force), {});
        QVERIFY(rubber.comparison.decisive);
        QCOMPARE(rubber.comparison.ranked.front().id, u"cubic_spring"_s);
    }

    void aSlowGripperSaysItsSampleTimeAndKeepsIt()
    {
        VirtualFirmwareOptions options = ofCanA({});
        options.sampleTime_s = 0.01;
        const VirtualFirmware firmware(options);
        const std::optional<Report> report =
            firmware.feature(static_cast<std::uint8_t>(ReportId::Measurement));
        QVERIFY(report);
        QCOMPARE(decodeMeasurement(*report)->sampleTime_s, 0.01);
        QCOMPARE(firmware.samplesIn(VirtualFirmware::restBefore_s), 5U);
        const Recording recording = squeezed(options, fourLevels(0.01, 200));
        QCOMPARE(recording.size(), std::size_t(200));
        BareDevice device(options);
        device.run(100, false);
        QCOMPARE(device.stream.size(), std::size_t(100)); // none waits for a second sample
        for (std::size_t i = 1; i < device.stream.size(); ++i)
            QCOMPARE(device.stream[i].timestamp_us - device.stream[i - 1].timestamp_us, 10'000U);
    }

    void anIdleGripperStaysWhereItIs()
    {
        VirtualFirmwareOptions options = ofCanA({.friction_N = 0.5});
        options.positionNoise_m = 0;
        options.jitter_s = 1e-4;
        BareDevice device(options);
        device.run(100, false);
        for (const StreamReport& report : device.stream)
            for (std::size_t i = 0; i < report.count; ++i)
                QCOMPARE(report.samples[i].position, 617); // the contact, in steps of 20 um
    }

    /// Positions taken a tenth of a sample time about when they say, while the part moves at v: v times that.
    void jitterIsAsLargeAsItSays()
    {
        const std::vector<double> force = fourLevels(0.0005, 2000);
        VirtualFirmwareOptions options;
        options.object = VirtualObject::exactly({0.06, 6, 1500}); // moves far beside a step of the encoder
        options.positionNoise_m = 0;
        const Recording regular = squeezed(options, force);
        options.jitter_s = 50e-6;
        const Recording irregular = squeezed(options, force);
        QCOMPARE(irregular.size(), regular.size());
        double squares = 0;
        double expected = 0;
        for (std::size_t i = 1; i + 1 < regular.size(); ++i) {
            const double speed = (regular.position[i + 1] - regular.position[i - 1]) / 0.001;
            expected += std::pow(speed * options.jitter_s, 2);
            squares += std::pow(irregular.position[i] - regular.position[i], 2);
        }
        // Both are rounded to 20 um: a sixth of a step's square each.
        const double steps = 2000.0 / 6 * std::pow(VirtualFirmware::positionPerCount_m, 2);
        QVERIFY2(std::abs(squares / (expected + steps) - 1) < 0.15,
                 qPrintable(QString::number(squares / (expected + steps))));
    }
};

GRIPSCOPE_TEST(VirtualPartTest)
#include "virtual_part_test.moc"
