// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise/noise_model.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

class SeriesModelTest : public QObject {
    Q_OBJECT
private slots:
    void whiteNoiseIsWhite()
    {
        // BIC takes an order of its own once in some hundred series of 1,000 (chi-square above ln 1000 = 6.9,
        // once in 115 for the first lag); 8 of 100 once in 10,000.
        int coloured = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            GaussianNoise noise(seed);
            std::vector<double> series(1000);
            for (double& value : series)
                value = noise();
            const auto model = autoregressiveModel(series);
            coloured += model->coefficients.empty() ? 0 : 1;
        }
        QVERIFY2(coloured <= 8, qPrintable(QString::number(coloured)));
    }

    void anAutoregressionIsFoundWithItsLikelihood()
    {
        GaussianNoise noise(9);
        std::vector<double> series;
        double last = 0;
        double before = 0;
        for (int i = 0; i < 20000; ++i) {
            const double value = 1.2 * last - 0.5 * before + 1e-6 * noise();
            before = last;
            last = value;
            series.push_back(value);
        }
        const auto model = autoregressiveModel(series);
        QCOMPARE(model->coefficients.size(), std::size_t(2));
        // Standard error sqrt((1 - 0.5^2) / N) = 0.006.
        QVERIFY(std::abs(model->coefficients[0] - 1.2) < 0.025);
        QVERIFY(std::abs(model->coefficients[1] + 0.5) < 0.025);
        const double expected = -10000 * (std::log(2 * std::numbers::pi * 1e-12) + 1);
        QVERIFY(std::abs(model->logLikelihood - expected) < 4 * std::sqrt(10000.0));
    }

    void nothingGivesNothing()
    {
        QVERIFY(!autoregressiveModel({}));
        QVERIFY(!autoregressiveModel(std::vector<double>(100, 0.0)));
        QVERIFY(autoregressiveModel(std::vector<double>{1, -1, 1})->coefficients.empty());
        QVERIFY(autoregressiveModel(std::vector<double>(100, 1e300)));
    }
};

GRIPSCOPE_TEST(SeriesModelTest)
#include "series_model_test.moc"
