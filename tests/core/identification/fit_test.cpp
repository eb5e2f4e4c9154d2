// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/fit.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace gripscope;

class FitTest : public QObject {
    Q_OBJECT
private slots:
    void aPerfectModelFitsByHundredTheMeanByNothing()
    {
        const std::vector<double> y{1, 2, 3, 6};
        QCOMPARE(fitPercent(y, y).value_or(-1), 100.0);
        QVERIFY(std::abs(fitPercent(y, std::vector<double>(4, 3.0)).value_or(-1)) < 1e-12);
    }
    void theNumberIsTheFormulas()
    {
        // |y - yhat| = sqrt(2), |y - mean| = sqrt(14).
        const std::vector<double> y{1, 2, 3, 6};
        const std::vector<double> model{2, 2, 3, 5};
        QVERIFY(std::abs(fitPercent(y, model).value_or(-1) - 100 * (1 - std::sqrt(2.0 / 14))) < 1e-12);
    }
    void unitsDoNotMatterHoweverLarge()
    {
        for (const double scale : {1e-200, 1e-6, 1e6, 1e200}) {
            const std::vector<double> y{1 * scale, 2 * scale, 3 * scale, 6 * scale};
            const std::vector<double> model{2 * scale, 2 * scale, 3 * scale, 5 * scale};
            QVERIFY(std::abs(fitPercent(y, model).value_or(-1) - 100 * (1 - std::sqrt(2.0 / 14))) < 1e-12);
        }
    }
    void whereItIsNotDefinedThereIsNone()
    {
        QVERIFY(!fitPercent(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}));
        QVERIFY(!fitPercent(std::vector<double>{}, std::vector<double>{}));
        QVERIFY(!fitPercent(std::vector<double>{1, 2}, std::vector<double>{1}));
        QVERIFY(!fitPercent(std::vector<double>{1, 2},
                            std::vector<double>{1, std::numeric_limits<double>::infinity()}));
    }
};

GRIPSCOPE_TEST(FitTest)
#include "fit_test.moc"
