// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/arming_obstacle.h"
#include "devices/protocol/codec.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace Qt::StringLiterals;

// The numbers of a description: which of them keep it from being read, which only from being armed, and the
// words that name them.

namespace {

struct Description {
    MeasurementFeature measurement;
    LimitsFeature limits{100000, 1250, 32768};

    /// One that may be armed.
    Description()
    {
        measurement.forcePerCount = 0.001;
        measurement.positionPerCount = 2e-5;
        measurement.sampleTime_s = 0.0005;
        measurement.commandable = true;
        measurement.watchdog_ms = 100;
    }
};

using Change = std::function<void(Description&)>;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// What a decoder names; nothing where it takes the feature.
std::optional<Field> unreadable(const Description& description)
{
    const auto measurement = decodeMeasurement(encode(description.measurement));
    if (!measurement)
        return measurement.error().field->field;
    const auto limits = decodeLimits(encode(description.limits));
    return limits ? std::nullopt : std::optional(limits.error().field->field);
}

void addChange(const char* name, Change change, std::optional<Field> unreadable,
               std::optional<Field> obstacle)
{
    QTest::newRow(name) << change << unreadable << obstacle;
}

} // namespace

Q_DECLARE_METATYPE(Change)
Q_DECLARE_METATYPE(std::optional<Field>)

class ArmingObstacleTest : public QObject {
    Q_OBJECT
private slots:
    void everyNumberHasItsRangeAndItsName_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<std::optional<Field>>("unread");
        QTest::addColumn<std::optional<Field>>("obstacle");
        const std::optional<Field> fine;
        addChange(
            "a good one", [](Description&) {}, fine, fine);
        struct Number {
            const char* name;
            double MeasurementFeature::*member;
            Field field;
            double least, most; ///< that can be read
            double mostForArming;
        };
        static const Number numbers[] = {
            {"force in a count", &MeasurementFeature::forcePerCount, Field::ForcePerCount, 1e-12, 1e6, 1e6},
            {"position in a count", &MeasurementFeature::positionPerCount, Field::PositionPerCount, 1e-12,
             1e6, 1e6},
            {"sample time", &MeasurementFeature::sampleTime_s, Field::SampleTime, 1e-6, 1, 0.02},
            {"lag", &MeasurementFeature::forceLag_s, Field::Lag, -0.1, 0.1, 0.1}};
        for (const Number& n : numbers) {
            const auto row = [&](const char* what, double value, bool reads, bool arms) {
                const std::optional<Field> it = n.field;
                QTest::newRow(qPrintable(u"%1: %2"_s.arg(QLatin1String(n.name), QLatin1String(what))))
                    << Change([&n, value](Description& d) { d.measurement.*n.member = value; })
                    << (reads ? fine : it) << (arms ? fine : it);
            };
            row("least", n.least, true, true);
            row("below the least", std::nextafter(n.least, -infinite), false, false);
            row("most", n.most, true, n.most == n.mostForArming);
            row("above the most", std::nextafter(n.most, infinite), false, false);
            row("most of an armed one", n.mostForArming, true, true);
            row("above the most of an armed one", std::nextafter(n.mostForArming, infinite),
                n.most > n.mostForArming, false);
            row("not a number", notANumber, false, false);
            row("infinite", infinite, false, false);
            row("minus infinite", -infinite, false, false);
        }
        const auto watchdog = [&](const char* name, std::uint16_t ms, bool arms) {
            addChange(
                name, [ms](Description& d) { d.measurement.watchdog_ms = ms; }, fine,
                arms ? fine : std::optional(Field::Watchdog));
        };
        watchdog("no watchdog", 0, false);
        watchdog("a watchdog of 20 ms", 20, false);
        watchdog("99 ms", 99, false);
        watchdog("100 ms", 100, true);
        watchdog("200 ms", 200, true);
        watchdog("201 ms", 201, false);
        watchdog("65535 ms", 65535, false);
        addChange(
            "only streams", [](Description& d) { d.measurement.commandable = false; }, fine,
            Field::TakesCommands);
        addChange(
            "unknown unit of force", [](Description& d) { d.measurement.forceUnit = ForceUnit::None; }, fine,
            Field::ForceUnit);
        addChange(
            "unknown unit of position",
            [](Description& d) { d.measurement.positionUnit = PositionUnit::None; }, fine,
            Field::PositionUnit);
        addChange(
            "no force", [](Description& d) { d.limits.maxForce = 0; }, fine, Field::LargestForce);
        addChange(
            "force below zero", [](Description& d) { d.limits.maxForce = -1; }, Field::LargestForce,
            Field::LargestForce);
        addChange(
            "no travel", [](Description& d) { d.limits.maxTravel = 0; }, fine, Field::LongestTravel);
        addChange(
            "travel below zero", [](Description& d) { d.limits.maxTravel = -1; }, Field::LongestTravel,
            Field::LongestTravel);
        addChange(
            "no samples", [](Description& d) { d.limits.maxSamples = 0; }, fine, Field::LongestExcitation);
        addChange(
            "the largest limits",
            [](Description& d) {
                d.limits = {0x7FFFFFFF, 0x7FFFFFFF, 0xFFFFFFFF};
            },
            fine, fine);
    }
    void everyNumberHasItsRangeAndItsName()
    {
        QFETCH(Change, change);
        QFETCH(std::optional<Field>, unread);
        QFETCH(std::optional<Field>, obstacle);
        Description description;
        change(description);
        QVERIFY(unreadable(description) == unread);
        const std::optional<FieldProblem> found = armingObstacle(description.measurement, description.limits);
        QCOMPARE(found.has_value(), obstacle.has_value());
        if (!found)
            return;
        QVERIFY(found->field == *obstacle);
        QVERIFY2(describe(*found).contains(fieldName(*obstacle)), qPrintable(describe(*found)));
    }

    void theWordsNameFieldValueAndRange()
    {
        Description description;
        description.measurement.watchdog_ms = 20;
        QCOMPARE(describeObstacle(*armingObstacle(description.measurement, description.limits)),
                 u"\"watchdog\" is 20 ms; it must be from 100 ms to 200 ms"_s);
        description.measurement.watchdog_ms = 100;
        description.measurement.sampleTime_s = 0.04;
        QVERIFY2(describeObstacle(*armingObstacle(description.measurement, description.limits))
                     .startsWith(u"its reports come every 40.0 ms; "_s),
                 "a slow gripper has no wrong field");
        description.measurement.sampleTime_s = 10;
        QCOMPARE(describe(decodeMeasurement(encode(description.measurement)).error()),
                 u"\"sample time\" is 10 s; it must be from 1e-06 s to 1 s"_s);
        description.measurement.commandable = false;
        QCOMPARE(describe(*armingObstacle(description.measurement, description.limits)),
                 u"\"takes commands\" is 0; it must be 1"_s);
    }

    void aFieldOfAReportIsNamed_data()
    {
        QTest::addColumn<int>("id");
        QTest::addColumn<int>("byte");
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("named");
        QTest::newRow("samples") << 0x01 << 17 << 6 << u"\"number of samples\" is 6"_s;
        QTest::newRow("state") << 0x01 << 16 << 5 << u"\"excitation state\" is 5"_s;
        QTest::newRow("result") << 0x02 << 7 << 11 << u"\"result\" is 11"_s;
        QTest::newRow("forces") << 0x25 << 6 << 13 << u"\"number of forces\" is 13"_s;
        QTest::newRow("key") << 0x20 << 4 << 0x40 << u"\"key\" is"_s;
    }
    void aFieldOfAReportIsNamed()
    {
        QFETCH(int, id);
        QFETCH(int, byte);
        QFETCH(int, value);
        QFETCH(QString, named);
        Report report = encode(Command{1, ArmCommand{}});
        report[0] = static_cast<std::uint8_t>(id);
        report[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(value);
        seal(report);
        const QString words =
            id < 0x20 ? describe(decodeInput(report).error()) : describe(decodeCommand(report).error());
        QVERIFY2(words.startsWith(named), qPrintable(words));
    }

    void anotherVersionIsTold()
    {
        QCOMPARE(describe(DecodeError(DecodeError::Version, 0x20)),
                 u"it speaks version 2.0 of the protocol, this program 1.1"_s);
        QCOMPARE(describe(DecodeError(DecodeError::Length, 63)), u"the report has 63 bytes, not 64 bytes"_s);
    }

    void anAnswerIsToldWithItsDetail_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<int>("result");
        QTest::addColumn<int>("detail");
        QTest::addColumn<QString>("words");
        const auto row = [](ReportId command, CommandResult result, int detail, const char* words) {
            QTest::newRow(words) << static_cast<int>(command) << static_cast<int>(result) << detail
                                 << QString::fromUtf8(words);
        };
        row(ReportId::Arm, CommandResult::Fault, 7, "it reports a fault: its code 7");
        row(ReportId::Upload, CommandResult::LimitExceeded, 24, "force 24 of the signal is above the limit");
        row(ReportId::Start, CommandResult::LimitExceeded, 0, "force 0 of the signal is above the limit");
        row(ReportId::Upload, CommandResult::BadValue, 3, "force 3 of the signal is outside its range");
        row(ReportId::Start, CommandResult::Incomplete, 12, "force 12 of the signal is missing");
        row(ReportId::Start, CommandResult::Spent, 9,
            "squeeze 9 was started already; this one is not behind it");
        row(ReportId::SetLimits, CommandResult::LimitExceeded, 1, "the largest force is above its own limit");
        row(ReportId::SetLimits, CommandResult::LimitExceeded, 2,
            "the longest travel is above its own limit");
        row(ReportId::SetLimits, CommandResult::BadValue, 1, "the largest force is not above zero");
        row(ReportId::SetLimits, CommandResult::BadValue, 2, "the longest travel is not above zero");
        row(ReportId::SetLimits, CommandResult::LimitExceeded, 0, "a value is above a limit");
        row(ReportId::Start, CommandResult::NotArmed, 0, "it is not armed");
        row(ReportId::Arm, CommandResult::BadValue, 0, "a value is outside its range");
    }
    void anAnswerIsToldWithItsDetail()
    {
        QFETCH(int, command);
        QFETCH(int, result);
        QFETCH(int, detail);
        QFETCH(QString, words);
        QCOMPARE(describe(static_cast<ReportId>(command), static_cast<CommandResult>(result),
                          static_cast<std::uint32_t>(detail)),
                 words);
    }
};

GRIPSCOPE_TEST(ArmingObstacleTest)
#include "arming_obstacle_test.moc"
