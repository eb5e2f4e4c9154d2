// SPDX-License-Identifier: GPL-3.0-or-later
// What a person reads in place of SI, held against the exact definitions of the units.
#include "core/base/display_units.h"
#include "core/base/finding.h"
#include "core/signal/recording/channel_quantity.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

using Q = MechanicalQuantity;
constexpr DisplayUnits imperial{DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch};
constexpr DisplayUnits kilograms{DisplayUnits::Force::KilogramForce, DisplayUnits::Length::Metre};

/// An inch is 127 / 5000 m, a pound 45359237 / 10^8 kg, a pound force that times 980665 / 10^5 m/s^2: with
/// these the factors are quotients of whole numbers. A double and two roundings: 4e-16.
constexpr double inch_m = 127.0 / 5000;
constexpr double pound_kg = 45359237.0 / 1e8;
constexpr double gravity = 980665.0 / 1e5;
constexpr double roundings = 1e-15;

bool near(double found, double expected)
{
    return std::abs(found / expected - 1) < roundings;
}

} // namespace

class DisplayUnitsTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { DisplayUnits::choose({}); }

    void siStaysAsItIs()
    {
        for (const char16_t* unit : {u"N", u"m", u"kg", u"N s/m", u"N/m", u"N/m\u00B3", u"Hz", u"1", u""}) {
            const ShownUnit shown = displayUnit(QString::fromUtf16(unit));
            QCOMPARE(shown.unit, QString::fromUtf16(unit));
            QCOMPARE(shown.factor, 1.0);
        }
    }
    void poundsAndInchesAreExact_data()
    {
        QTest::addColumn<QString>("si");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<double>("siPerShown");
        QTest::newRow("force") << u"N"_s << u"lbf"_s << pound_kg * gravity;
        QTest::newRow("length") << u"m"_s << u"in"_s << inch_m;
        QTest::newRow("mass") << u"kg"_s << u"lb"_s << pound_kg;
        QTest::newRow("damping") << u"N s/m"_s << u"lbf s/in"_s << pound_kg * gravity / inch_m;
        QTest::newRow("stiffness") << u"N/m"_s << u"lbf/in"_s << pound_kg * gravity / inch_m;
        QTest::newRow("cubic") << u"N/m\u00B3"_s << u"lbf/in\u00B3"_s
                               << pound_kg * gravity / (inch_m * inch_m * inch_m);
    }
    void poundsAndInchesAreExact()
    {
        QFETCH(QString, si);
        QFETCH(QString, shown);
        QFETCH(double, siPerShown);
        const ShownUnit found = displayUnit(si, imperial);
        QCOMPARE(found.unit, shown);
        QVERIFY2(near(found.factor * siPerShown, 1), qPrintable(QString::number(found.factor, 'g', 17)));
        QCOMPARE(displayUnit(found.unit, imperial).unit, found.unit); // what was chosen is not chosen again
        QCOMPARE(displayUnit(found.unit, imperial).factor, 1.0);
    }
    void aForceOfItsOwnLeavesLengthsMetric()
    {
        QCOMPARE(displayUnit(u"N"_s, kilograms).unit, u"kgf"_s);
        QVERIFY(near(displayUnit(u"N"_s, kilograms).factor * gravity, 1));
        QCOMPARE(displayUnit(u"N/m"_s, kilograms).unit, u"kgf/mm"_s);
        QVERIFY(near(displayUnit(u"N/m"_s, kilograms).factor * gravity * 1000, 1));
        QCOMPARE(displayUnit(u"m"_s, kilograms).unit, u"m"_s);
        QCOMPARE(displayUnit(u"kg"_s, kilograms).unit, u"kg"_s);
        QCOMPARE(fieldUnit(Q::Length, kilograms).unit, u"mm"_s);
    }
    void everyChoiceIsReadByItsName()
    {
        QCOMPARE(forceUnitChoices.front().unit, DisplayUnits().force);
        QCOMPARE(lengthUnitChoices.front().unit, DisplayUnits().length);
        for (const auto& force : forceUnitChoices)
            for (const auto& length : lengthUnitChoices) {
                const DisplayUnits units{force.unit, length.unit};
                QCOMPARE(fieldUnit(Q::Force, units).unit, QString::fromLatin1(force.name));
                QCOMPARE(fieldUnit(Q::Length, units).unit, QString::fromLatin1(length.name));
            }
    }
    void aLengthOfItsOwnLeavesForcesInNewtons()
    {
        constexpr DisplayUnits inches{DisplayUnits::Force::Newton, DisplayUnits::Length::Inch};
        QCOMPARE(displayUnit(u"N"_s, inches).unit, u"N"_s);
        QCOMPARE(displayUnit(u"kg"_s, inches).unit, u"kg"_s);
        QCOMPARE(displayUnit(u"N/m"_s, inches).unit, u"N/in"_s);
        QVERIFY(near(displayUnit(u"N/m"_s, inches).factor / inch_m, 1));
        QCOMPARE(displayUnit(u"N s/m"_s, inches).unit, u"N s/in"_s);
    }
    void fieldsHaveOneHandyMultiple()
    {
        const Q all[] = {Q::Mass, Q::Damping, Q::Stiffness, Q::Force, Q::Length};
        QStringList metric, pounds;
        for (const Q quantity : all) {
            metric << fieldUnit(quantity, {}).unit;
            pounds << fieldUnit(quantity, imperial).unit;
        }
        QCOMPARE(metric, (QStringList{u"g"_s, u"N s/m"_s, u"kN/m"_s, u"N"_s, u"mm"_s}));
        QCOMPARE(pounds, (QStringList{u"lb"_s, u"lbf s/in"_s, u"lbf/in"_s, u"lbf"_s, u"in"_s}));
    }
    void aFindingIsReadAsChosenAndKeptInSi()
    {
        const Finding force = Finding::quantity(Q::Force, 30);
        const Finding stiffness = Finding::quantity(Q::Stiffness, 9984);
        QCOMPARE(force.describe(), u"30 N"_s);
        QCOMPARE(stiffness.describe(), u"9.98 kN/m"_s);
        QCOMPARE(Finding::quantity(Q::Length, 0.0025).describe(), u"2.5 mm"_s);
        const QJsonValue kept = force.toJson();
        DisplayUnits::choose(imperial);
        QCOMPARE(force.describe(), u"6.744 lbf"_s);
        QCOMPARE(stiffness.describe(), u"57 lbf/in"_s);
        QCOMPARE(Finding::quantity(Q::Mass, 0.0396).describe(), u"0.0873 lb"_s);
        QCOMPARE(Finding::fromJson(kept)->describe(), u"6.744 lbf"_s); // stored before it was chosen
        QCOMPARE(force.toJson(), kept);
        QCOMPARE(force.english(), u"30 N"_s); // documents are in SI, whatever is chosen
        QCOMPARE(stiffness.english(), u"9.98 kN/m"_s);
    }
    void aChannelsNumberIsReadAsChosenWhereItsUnitIsKnown()
    {
        const Finding length = channelQuantity(Q::Length, 12.7, u"mm"_s);
        const Finding force = channelQuantity(Q::Force, 0.03, u"kN"_s);
        QCOMPARE(length.describe(), u"12.7 mm"_s);
        QCOMPARE(force.describe(), u"30 N"_s);
        DisplayUnits::choose(imperial);
        QCOMPARE(length.describe(), u"0.5 in"_s);
        QCOMPARE(force.describe(), u"6.744 lbf"_s);
        QCOMPARE(channelQuantity(Q::Force, 7, u"counts"_s).describe(), u"7 counts"_s);
        QCOMPARE(channelQuantity(Q::Length, 7, u"1"_s).describe(), u"7"_s);
    }
    void everyQuantityIsStoredAndReadBack()
    {
        for (const Q quantity : {Q::Mass, Q::Damping, Q::Stiffness, Q::Force, Q::Length}) {
            const Finding kept = Finding::quantity(quantity, 0.0125);
            QCOMPARE(Finding::fromJson(kept.toJson()), std::optional(kept));
        }
    }
    void whatIsNotAQuantityIsRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("unknown") << QByteArray(R"({"quantity": "torque", "si": 1})");
        QTest::newRow("no value") << QByteArray(R"({"quantity": "force"})");
        QTest::newRow("a word for a value") << QByteArray(R"({"quantity": "force", "si": "much"})");
        QTest::newRow("a number for a name") << QByteArray(R"({"quantity": 3, "si": 1})");
    }
    void whatIsNotAQuantityIsRefused()
    {
        QFETCH(QByteArray, json);
        QVERIFY(!Finding::fromJson(QJsonDocument::fromJson(json).object()));
    }
};

GRIPSCOPE_TEST(DisplayUnitsTest)
#include "display_units_test.moc"
