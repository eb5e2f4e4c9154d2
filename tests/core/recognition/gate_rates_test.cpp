// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/type_model.h"
#include "tests/core/recognition/gaussian_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;

namespace {

constexpr int manyEnrolments = 8000;

/// Share of squeezes of the first type that fall outside its gate, each after an enrolment of its own.
double rejectedShare(int types, int squeezes, double correlation, int enrolments)
{
    constexpr double rate = 0.01;
    GaussianTypes source(std::uint64_t(100 * types + squeezes), correlation);
    int rejected = 0, degrees = 0;
    double gate = 0;
    for (int i = 0; i < enrolments; ++i) {
        const TypeModels models = fitTypeModels(source.enrolment(types, squeezes));
        if (models.degreesOfFreedom != degrees) {
            degrees = models.degreesOfFreedom;
            gate = falseRejectGate(squeezes, degrees, rate).value();
        }
        rejected += squaredDistance(models, models.types[0], source.squeeze(0)).value() > gate;
    }
    return double(rejected) / enrolments;
}

} // namespace

/// How often a part of a type falls outside the gate of its own type, by the thousand.
class GateRatesTest : public QObject {
    Q_OBJECT
private slots:
    void gateRejectsAtItsStatedRate_data()
    {
        QTest::addColumn<int>("types");
        QTest::addColumn<int>("squeezes");
        QTest::addColumn<double>("correlation");
        QTest::newRow("4 types, 10 squeezes") << 4 << 10 << 0.0;
        QTest::newRow("4 types, 10 squeezes, m b k together") << 4 << 10 << 0.9;
        QTest::newRow("4 types, 5 squeezes") << 4 << 5 << 0.0;
        QTest::newRow("4 types, 5 squeezes, m b k together") << 4 << 5 << 0.9;
        QTest::newRow("4 types, 3 squeezes") << 4 << 3 << 0.0;
        QTest::newRow("1 type, 20 squeezes") << 1 << 20 << 0.5;
    }
    void gateRejectsAtItsStatedRate()
    {
        QFETCH(int, types);
        QFETCH(int, squeezes);
        QFETCH(double, correlation);
        // Three standard deviations of a binomial share of 1 %: 0.0033. The seeds are fixed.
        const double tolerance = 3 * std::sqrt(0.01 * 0.99 / manyEnrolments);
        const double share = rejectedShare(types, squeezes, correlation, manyEnrolments);
        QVERIFY2(std::abs(share - 0.01) < tolerance, qPrintable(QString::number(share)));
    }
    void withFewSqueezesThatGoTogetherTheGateRejectsNoMoreThanStated()
    {
        const double most = 0.01 + 3 * std::sqrt(0.01 * 0.99 / manyEnrolments);
        for (int squeezes : {4, 5, 6})
            QVERIFY(rejectedShare(1, squeezes, 0.9, manyEnrolments) < most);
        QVERIFY(rejectedShare(4, 3, 0.9, manyEnrolments) < most);
    }
};

GRIPSCOPE_TEST(GateRatesTest)
#include "gate_rates_test.moc"
