// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/axis_ticks.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class AxisTicksTest : public QObject {
    Q_OBJECT
private slots:
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
