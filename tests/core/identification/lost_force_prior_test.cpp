// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<double> sine(std::size_t count, double step)
{
    std::vector<double> values;
    for (std::size_t t = 0; t < count; ++t)
        values.push_back(std::sin(step * static_cast<double>(t)));
    return values;
}

/// Bits of ten samples.
std::vector<double> bits(std::size_t count)
{
    GaussianNoise random(5);
    std::vector<double> values;
    while (values.size() < count)
        values.insert(values.end(), 10, random.uniform() < 0.5 ? -1.0 : 1.0);
    values.resize(count);
    return values;
}

} // namespace

class LostForcePriorTest : public QObject {
    Q_OBJECT
private slots:
    void aSmoothForceIsKnownBetweenItsSamples()
    {
        // The cubic's error in the middle is h^4 f'''' / 6 at most: 8.4e-5 at h = 0.15.
        std::vector<double> force = sine(500, 0.15);
        const std::vector<double> truth = force;
        force[100] = force[203] = nothing;
        const LostForcePrior prior = lostForcePrior(force, {100, 203});
        for (const std::size_t t : {100U, 203U})
            QVERIFY(std::abs(prior.force[t] - truth[t]) < 9e-5);
        // A variance below that of the force over the 496 places tried has not been seen.
        QVERIFY(std::abs(prior.deviation[0] - std::sqrt(0.5 / 497)) < 0.003);
    }
    void aBinaryForceIsUnknownOnlyWhereItsNeighboursDiffer()
    {
        std::vector<double> force = bits(1000);
        std::size_t edge = 300;
        while (force[edge] == force[edge - 1])
            ++edge;
        force[305] = force[edge] = nothing;
        std::vector<std::size_t> lost{305, edge};
        std::sort(lost.begin(), lost.end());
        force[304] = force[306] = 1;
        const LostForcePrior prior = lostForcePrior(force, lost);
        const std::size_t inside = lost[0] == 305 ? 0 : 1;
        QCOMPARE(prior.force[305], 1.0);
        QVERIFY(prior.deviation[inside] < 0.05);
        QVERIFY(std::abs(prior.force[edge]) < 1e-12); // half way
        QVERIFY(std::abs(prior.deviation[1 - inside] - 1) < 0.05);
    }
    void deviationsAreThoseThatOccur()
    {
        // White noise: the error of a mean of two neighbours has variance 1 + 1/2.
        GaussianNoise noise(3);
        std::vector<double> force;
        for (int t = 0; t < 4000; ++t)
            force.push_back(noise());
        const std::vector<double> truth = force;
        std::vector<std::size_t> lost;
        for (std::size_t t = 5; t < 3990; t += 7) {
            lost.push_back(t);
            force[t] = nothing;
        }
        const LostForcePrior prior = lostForcePrior(force, lost);
        double squares = 0;
        for (std::size_t i = 0; i < lost.size(); ++i) {
            const double z = (truth[lost[i]] - prior.force[lost[i]]) / prior.deviation[i];
            squares += z * z;
        }
        // Chi-square of 570: standard deviation 6 % of the mean; five of them.
        QVERIFY(std::abs(squares / static_cast<double>(lost.size()) - 1) < 0.3);
    }
    void longGapsAndEndsAreLessCertain()
    {
        std::vector<double> force = sine(300, 0.15);
        std::vector<std::size_t> lost{0, 50, 100, 101, 102, 103, 299};
        for (const std::size_t t : lost)
            force[t] = nothing;
        const LostForcePrior prior = lostForcePrior(force, lost);
        QCOMPARE(prior.force[0], force[1]);
        QCOMPARE(prior.force[299], force[298]);
        QVERIFY(prior.deviation[0] > prior.deviation[1] && prior.deviation[6] > prior.deviation[1]);
        QVERIFY(prior.deviation[3] > prior.deviation[1]);
    }
    void anyRecordGivesNumbers()
    {
        for (const double scale : {0.0, 1e-300, 1e300}) {
            for (const std::size_t count : {2U, 3U, 6U, 40U}) {
                std::vector<double> force(count, scale);
                force[count / 2] = nothing;
                const LostForcePrior prior = lostForcePrior(force, {count / 2});
                QVERIFY(std::isfinite(prior.force[count / 2]));
                QVERIFY(prior.deviation[0] > 0 && std::isfinite(prior.deviation[0]));
            }
        }
    }
};

GRIPSCOPE_TEST(LostForcePriorTest)
#include "lost_force_prior_test.moc"
