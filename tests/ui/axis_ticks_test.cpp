// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/axis_ticks.h"

#include <QDateTime>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

class AxisTicksTest : public QObject {
    Q_OBJECT
private slots:
    void logarithmicTicksAreRoundNumbers_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<int>("most");
        QTest::addColumn<QStringList>("labels");
        QTest::newRow("two decades") << 1.0 << 3.0 << 8 << QStringList{u"10"_s,  u"20"_s,  u"50"_s,  u"100"_s,
                                                                       u"200"_s, u"500"_s, u"1000"_s};
        QTest::newRow("less room") << 1.0 << 3.0 << 4 << QStringList{u"10"_s, u"100"_s, u"1000"_s};
        QTest::newRow("hardly any") << 1.0 << 3.0 << 2 << QStringList{u"10"_s, u"1000"_s};
        QTest::newRow("small") << -2.1 << -0.5 << 3 << QStringList{u"0.01"_s, u"0.1"_s};
        QTest::newRow("tiny") << -9.0 << -6.0 << 4
                              << QStringList{u"10\u207B\u2079"_s, u"10\u207B\u2078"_s, u"10\u207B\u2077"_s,
                                             u"10\u207B\u2076"_s};
        QTest::newRow("within a decade")
            << std::log10(210.0) << std::log10(245.0) << 4 << QStringList{u"220"_s, u"240"_s};
        QTest::newRow("nothing") << 1.0 << 1.0 << 4 << QStringList{};
        QTest::newRow("no number") << -HUGE_VAL << 1.0 << 4 << QStringList{};
    }
    void logarithmicTicksAreRoundNumbers()
    {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(int, most);
        QFETCH(QStringList, labels);
        QStringList found;
        for (const LogarithmicTick& tick : logarithmicTicks(low, high, most)) {
            found << tick.label;
            QVERIFY(tick.exponent >= low - 1e-9 && tick.exponent <= high + 1e-9);
        }
        QCOMPARE(found, labels);
    }
    void aSymmetricScaleUsesMostOfItsRoom()
    {
        for (double half = 1e-6; half < 1e6; half *= 1.013) {
            const double step = symmetricStep(half);
            QVERIFY2(step <= half * (1 + 1e-9) && step >= half * 0.6, qPrintable(QString::number(half)));
            // Round: two digits at most.
            const double scaled = step / std::pow(10.0, std::floor(std::log10(step)) - 1);
            QVERIFY(std::abs(scaled - std::round(scaled)) < 1e-6);
        }
        QCOMPARE(symmetricStep(0), 0.0);
        QCOMPARE(symmetricStep(std::nan("")), 0.0);
    }
    void stepsHaveTheDecimalsTheyNeed_data()
    {
        QTest::addColumn<double>("step");
        QTest::addColumn<int>("decimals");
        QTest::newRow("whole") << 20.0 << 0;
        QTest::newRow("half") << 0.5 << 1;
        QTest::newRow("a quarter") << 0.25 << 2;
        QTest::newRow("fifteen") << 0.15 << 2;
        QTest::newRow("one and a half") << 1.5 << 1;
        QTest::newRow("small") << 2e-4 << 4;
        QTest::newRow("none") << 0.0 << 0;
    }
    void stepsHaveTheDecimalsTheyNeed()
    {
        QFETCH(double, step);
        QTEST(decimalsOf(step), "decimals");
    }
    void aDayHasItsYear()
    {
        const QDateTime noon = QDate(2026, 5, 31).startOfDay().addSecs(12 * 3600);
        const auto ticks = timeTicks(double(noon.toMSecsSinceEpoch()),
                                     double(noon.addSecs(24 * 3600).toMSecsSinceEpoch()), 6);
        QVERIFY(std::any_of(ticks.begin(), ticks.end(), [](const TimeTick& tick) {
            return tick.label.contains(QStringLiteral("2026-06-01"));
        }));
    }
    void labelsAreExact()
    {
        const AxisTicks ticks{{-0.15, 0, 0.15}, 0.15};
        QCOMPARE(ticks.label(0.15), QStringLiteral("0.15"));
        QCOMPARE(ticks.label(-0.15), QChar(0x2212) + QStringLiteral("0.15"));
        QCOMPARE(ticks.label(-1e-18), QStringLiteral("0.00"));
    }
};

GRIPSCOPE_TEST(AxisTicksTest)
#include "axis_ticks_test.moc"
