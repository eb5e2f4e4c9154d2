// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/quality/limits/guard_bands.h"
#include "core/quality/limits/tolerance_factors.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

namespace {

double below(double z)
{
    return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// The same integrals by so many equal steps, the tolerance limits at their ends.
GlobalRisks byMidpoints(const MeasuredProcess& p, double guard)
{
    GlobalRisks risks;
    const double far = 12 * p.deviation;
    const double lower = p.limits.lower.value_or(p.mean - far);
    const double upper = p.limits.upper.value_or(p.mean + far);
    const double low = p.limits.lower ? lower + guard : -1e300;
    const double high = p.limits.upper ? upper - guard : 1e300;
    const auto add = [&](double from, double to, bool conforms) {
        constexpr int steps = 100'000;
        for (int i = 0; i < steps; ++i) {
            const double part = from + (i + 0.5) * (to - from) / steps;
            const double z = (part - p.mean) / p.deviation;
            const double share =
                std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi) / p.deviation * (to - from) / steps;
            const double accepted =
                std::max(0.0, below((high - part) / p.uncertainty) - below((low - part) / p.uncertainty));
            (conforms ? risks.producers : risks.consumers) += share * (conforms ? 1 - accepted : accepted);
        }
    };
    if (p.limits.lower)
        add(p.mean - far, lower, false);
    if (p.limits.upper)
        add(upper, p.mean + far, false);
    add(lower, upper, true);
    return risks;
}

struct Process {
    const char* name;
    MeasuredProcess process;
    double guard;
};
const Process processes[] = {
    {"both sides", {{-2., 2.}, 0.1, 1, 0.2}, 0},
    {"guarded", {{-2., 2.}, 0.1, 1, 0.2}, 0.3},
    {"relaxed", {{-2., 2.}, 0.1, 1, 0.2}, -0.2},
    {"a lower limit", {{9500., std::nullopt}, 10000, 200, 60}, 50},
    {"an upper limit", {{std::nullopt, 0.05}, 0.04, 0.004, 0.003}, 0.001},
    {"sharp", {{-2., 2.}, 0, 1, 1e-3}, 0},
    {"poor", {{-2., 2.}, 0, 0.5, 2}, 0.5},
};

} // namespace

class GuardBandsTest : public QObject {
    Q_OBJECT
private slots:
    void risksAreThoseOfAnotherQuadrature_data()
    {
        QTest::addColumn<int>("row");
        for (int i = 0; i < int(std::size(processes)); ++i)
            QTest::newRow(processes[i].name) << i;
    }
    void risksAreThoseOfAnotherQuadrature()
    {
        QFETCH(int, row);
        const auto& [name, process, guard] = processes[row];
        const auto risks = globalRisks(process, guard);
        QVERIFY(risks);
        const GlobalRisks other = byMidpoints(process, guard);
        // 1e5 steps of a twelfth of a deviation's 1e-3 at most leave 1e-7.
        QVERIFY2(std::abs(risks->consumers - other.consumers) < 1e-6,
                 qPrintable(QString::number(risks->consumers - other.consumers)));
        QVERIFY(std::abs(risks->producers - other.producers) < 1e-6);
    }
    void aMillionPartsAgree()
    {
        const MeasuredProcess process{{-2., 2.}, 0.1, 1, 0.2};
        constexpr double guard = 0.1;
        constexpr int parts = 1'000'000;
        GaussianNoise noise(11);
        int consumers = 0, producers = 0;
        for (int i = 0; i < parts; ++i) {
            const double part = process.mean + process.deviation * noise();
            const double measured = part + process.uncertainty * noise();
            const bool conforms = std::abs(part) <= 2;
            const bool accepted = std::abs(measured) <= 2 - guard;
            consumers += accepted && !conforms;
            producers += conforms && !accepted;
        }
        const auto risks = globalRisks(process, guard);
        QVERIFY(risks);
        for (const auto& [count, risk] :
             {std::pair(consumers, risks->consumers), std::pair(producers, risks->producers)})
            QVERIFY2(std::abs(count - parts * risk) < 3 * std::sqrt(parts * risk * (1 - risk)),
                     qPrintable(QStringLiteral("%1 of %2").arg(count).arg(parts * risk)));
    }
    /// Where the parts lie far from zero as well, and no slower: JCGM 106's resistor of 1500 ohms.
    void whereTheScaleBeginsDoesNotMatter()
    {
        const MeasuredProcess here{{-0.2, 0.2}, 0, 0.12, 0.04}, there{{1499.8, 1500.2}, 1500, 0.12, 0.04};
        QVERIFY(std::abs(globalRisks(here, 0)->consumers - 0.0189422) < 5e-8);
        QVERIFY(std::abs(globalRisks(there, 0)->consumers - 0.0189422) < 5e-8);
        QVERIFY(std::abs(**guardForRisk(here, 0.01) - **guardForRisk(there, 0.01)) < 1e-9);
    }
    void aGuardBandHoldsItsRisk()
    {
        const MeasuredProcess process{{-2., 2.}, 0.1, 1, 0.2};
        for (const double risk : {0.02, 0.005, 0.001}) {
            const auto band = guardForRisk(process, risk);
            QVERIFY(band && *band);
            QVERIFY(std::abs(globalRisks(process, **band)->consumers - risk) < 1e-9);
        }
        // Fewer parts than that do not conform at all.
        QVERIFY(!*guardForRisk(process, 0.2));
        QVERIFY(std::abs(guardForSpecificRisk(1, 0.05) - 1.6448536269514722) < 1e-12);
    }
    void aValueTellsHowLikelyItsPartConforms()
    {
        const ToleranceLimits limits{0., 10.};
        QVERIFY(std::abs(conformanceProbability(limits, 10, 1) - 0.5) < 1e-12);
        QVERIFY(std::abs(conformanceProbability(limits, 8.355, 1) - below(1.645)) < 1e-12);
        // Parts that are mostly well inside make one at the limit more likely to be inside.
        QVERIFY(conformanceProbability(limits, 10, 1, PartsBefore{5, 1}) > 0.99);
        QVERIFY(decide(0.96, 0.05) == PartDecision::Conforms);
        QVERIFY(decide(0.03, 0.05) == PartDecision::DoesNotConform);
        QVERIFY(decide(0.5, 0.05) == PartDecision::TooNearTheLimit);
        // Far out the tails keep their digits.
        const double tiny = conformanceProbability({10., std::nullopt}, 0, 1);
        QVERIFY(std::abs(tiny / 7.619853024160527e-24 - 1) < 1e-10);
    }
    void nonsenseIsRefused()
    {
        QVERIFY(!globalRisks({{}, 0, 1, 1}, 0));
        QVERIFY(!globalRisks({{2., 1.}, 0, 1, 1}, 0));
        QVERIFY(!globalRisks({{1., 2.}, 0, 0, 1}, 0));
        QVERIFY(!globalRisks({{1., 2.}, 0, 1, NAN}, 0));
        QVERIFY(!globalRisks({{1., 2.}, 0, 1, 1}, INFINITY));
        QVERIFY(!guardForRisk({{1., 2.}, 0, 1, 1}, 1));
    }
    /// Tables of ISO 16269-6:2014; the last by the handbook of NIST, 7.2.6.3.
    void toleranceFactorsArePublished()
    {
        QVERIFY(std::abs(oneSidedToleranceFactor({10, 0.95, 0.95}).value() - 2.910963) < 5e-7);
        QVERIFY(std::abs(twoSidedToleranceFactor({10, 0.95, 0.95}).value() - 3.393429) < 5e-7);
        QVERIFY(std::abs(oneSidedToleranceFactor({43, 0.90, 0.99}).value() - 1.8740) < 5e-5);
        QVERIFY(!twoSidedToleranceFactor({1, 0.95, 0.95}));
        QVERIFY(!oneSidedToleranceFactor({10, 1, 0.95}));
    }
    /// What the factor promises, of 20,000 samples of five.
    void aToleranceIntervalHoldsWhatItSays()
    {
        constexpr int samples = 20'000, size = 5;
        const double k = twoSidedToleranceFactor({size, 0.9, 0.95}).value();
        GaussianNoise noise(3);
        int held = 0;
        for (int i = 0; i < samples; ++i) {
            double sum = 0, squares = 0;
            for (int j = 0; j < size; ++j) {
                const double value = noise();
                sum += value;
                squares += value * value;
            }
            const double mean = sum / size;
            const double s = std::sqrt((squares - size * mean * mean) / (size - 1));
            held += below(mean + k * s) - below(mean - k * s) >= 0.9;
        }
        const double share = held / double(samples);
        QVERIFY2(std::abs(share - 0.95) < 4 * std::sqrt(0.95 * 0.05 / samples),
                 qPrintable(QString::number(share)));
    }
};

GRIPSCOPE_TEST(GuardBandsTest)
#include "guard_bands_test.moc"
