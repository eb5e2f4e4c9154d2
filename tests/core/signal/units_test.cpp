// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/units.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

class UnitsTest : public QObject {
    Q_OBJECT
private slots:
    void parametersTakeTheirUnitsFromTheChannels_data()
    {
        QTest::addColumn<QString>("force");
        QTest::addColumn<QString>("position");
        QTest::addColumn<QStringList>("units");
        QTest::newRow("N and mm") << u"N"_s << u"mm"_s << QStringList{u"N s^2/mm"_s, u"N s/mm"_s, u"N/mm"_s};
        QTest::newRow("SI") << u"N"_s << u"m"_s << QStringList{u"kg"_s, u"N s/m"_s, u"N/m"_s};
        QTest::newRow("none") << u"1"_s << u"1"_s << QStringList{u"1"_s, u"1"_s, u"1"_s};
        QTest::newRow("only force") << u"N"_s << u"1"_s << QStringList{u"N s^2"_s, u"N s"_s, u"N"_s};
        QTest::newRow("only position") << u"1"_s << u"mm"_s << QStringList{u"s^2/mm"_s, u"s/mm"_s, u"1/mm"_s};
    }
    void parametersTakeTheirUnitsFromTheChannels()
    {
        QFETCH(QString, force);
        QFETCH(QString, position);
        QFETCH(QStringList, units);
        const ParameterUnits got = parameterUnits(force, position);
        QCOMPARE((QStringList{got.m, got.b, got.k}), units);
    }
    void knownUnitsConvertToSi()
    {
        QCOMPARE(siFactor(u"N"_s, u"mm"_s).value_or(0), 1000.0);
        QCOMPARE(siFactor(u"mN"_s, u"um"_s).value_or(0), 1000.0);
        QCOMPARE(siFactor(u"kN"_s, u"m"_s).value_or(0), 1000.0);
        // The micro sign and the Greek letter are two characters for one prefix.
        QCOMPARE(metresPer(u"\u00b5m"_s).value_or(0), 1e-6);
        QCOMPARE(metresPer(u"\u03bcm"_s).value_or(0), 1e-6);
    }
    void thoseOfOtherCountriesDoToo()
    {
        QCOMPARE(newtonsPer(u"kgf"_s).value_or(0), 9.80665);
        QCOMPARE(newtonsPer(u"gf"_s).value_or(0), 9.80665e-3);
        QCOMPARE(metresPer(u"in"_s).value_or(0), 0.0254);
        // 1 lbf/in = 4.4482216152605 / 0.0254 N/m, both by definition.
        QVERIFY(std::abs(siFactor(u"lbf"_s, u"in"_s).value_or(0) - 175.12683524647636) < 1e-11);
        QCOMPARE(parameterUnits(u"lbf"_s, u"in"_s).k, u"lbf/in"_s);
    }
    void unknownUnitsDoNot()
    {
        QVERIFY(!siFactor(u"1"_s, u"1"_s));
        QVERIFY(!siFactor(u"N"_s, u"inch"_s));
        QVERIFY(!newtonsPer(u"stone"_s));
    }
};

GRIPSCOPE_TEST(UnitsTest)
#include "units_test.moc"
