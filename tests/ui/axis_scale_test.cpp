// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/axis_ticks.h"
#include "ui/format/channel_scale.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class AxisScaleTest : public QObject {
    Q_OBJECT
private slots:
    void ticksAreRoundInTheUnitShown_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<QString>("title");
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("last");
        QTest::newRow("mass in grams") << "kg" << 0.0213 << 0.0438 << "m (g)"
                                       << "20"
                                       << "45";
        QTest::newRow("stiffness in kN/m") << "N/m" << 3400.0 << 11800.0 << "m (kN/m)"
                                           << "2"
                                           << "12";
        QTest::newRow("as printed") << "1" << 0.034 << 0.118 << "m (as printed)"
                                    << "0.02"
                                    << "0.12";
        QTest::newRow("unknown unit") << "N s^2/mm" << 12.0 << 38.0 << "m (N s^2/mm)"
                                      << "10"
                                      << "40";
    }
    void ticksAreRoundInTheUnitShown()
    {
        QFETCH(QString, unit);
        QFETCH(double, low);
        QFETCH(double, high);
        const AxisScale scale = axisScale(QStringLiteral("m"), unit, low, high);
        QTEST(scale.title(), "title");
        QTEST(scale.tickText(scale.ticks.front()), "first");
        QTEST(scale.tickText(scale.ticks.back()), "last");
        QVERIFY(scale.low <= low && scale.high >= high);
        QVERIFY(scale.ticks.size() >= 3 && scale.ticks.size() <= 8);
    }
    void valuesAndPositionsGoBothWays()
    {
        const AxisScale scale = axisScale(QStringLiteral("k"), QStringLiteral("N/m"), 3400, 11800);
        QVERIFY(std::abs(scale.unitPosition(scale.low)) < 1e-12);
        QVERIFY(std::abs(scale.unitPosition(scale.high) - 1) < 1e-12);
        QVERIFY(std::abs(scale.valueAt(scale.unitPosition(5000)) - 5000) < 1e-9);
    }
    void aSingleValueStillGetsARange()
    {
        for (const double value : {0.0, 5.0, -3.0}) {
            const AxisScale scale = axisScale(QStringLiteral("b"), QStringLiteral("N s/m"), value, value);
            QVERIFY(scale.low < value && value < scale.high);
        }
    }
    void channelsTakeAPrefixThatKeepsThemShort()
    {
        QCOMPARE(channelScale(QStringLiteral("m"), 3e-3).unit, QStringLiteral("mm"));
        QCOMPARE(channelScale(QStringLiteral("m"), 15e-6).unit, QString::fromUtf8("µm"));
        QCOMPARE(channelScale(QStringLiteral("mm"), 0.015).unit, QString::fromUtf8("µm"));
        QVERIFY(std::abs(channelScale(QStringLiteral("mm"), 0.015).factor - 1000) < 1e-9);
        QCOMPARE(channelScale(QStringLiteral("N"), 30).unit, QStringLiteral("N"));
        QCOMPARE(channelScale(QStringLiteral("1"), 30).title(QStringLiteral("Force")),
                 QStringLiteral("Force (as recorded)"));
        QCOMPARE(channelScale(QStringLiteral("V"), 0.001).unit, QStringLiteral("V"));
        QCOMPARE(channelScale(QStringLiteral("m"), 0).factor, 1.0);
    }
};

GRIPSCOPE_TEST(AxisScaleTest)
#include "axis_scale_test.moc"
