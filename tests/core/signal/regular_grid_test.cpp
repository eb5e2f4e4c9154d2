// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/signal/preparation/preparation_parts.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

namespace {

struct Jittered {
    std::vector<std::int64_t> index;
    std::vector<double> time;
};

Jittered jittered(std::size_t count, double jitter, const std::vector<std::int64_t>& lost = {})
{
    GaussianNoise random(5);
    Jittered result;
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(count); ++n) {
        const double off = std::clamp(jitter * random(), -0.3, 0.3);
        if (std::find(lost.begin(), lost.end(), n) != lost.end())
            continue;
        result.index.push_back(n);
        result.time.push_back(static_cast<double>(n) + off);
    }
    return result;
}

std::vector<double> valuesAt(const std::vector<double>& time, double (*function)(double))
{
    std::vector<double> values;
    for (const double t : time)
        values.push_back(function(t));
    return values;
}

double cubic(double t)
{
    return 1 + t * (0.5 + t * (0.01 - 1e-4 * t));
}

double line(double t)
{
    return 4 - 0.25 * t;
}

} // namespace

class RegularGridTest : public QObject {
    Q_OBJECT
private slots:
    void samplesOnTheGridAreUnchanged()
    {
        const std::vector<double> force{1, 2, 3}, position{4, 5, 6};
        const GriddedChannels grid = placeOnGrid(force, position, std::vector<std::int64_t>{7, 8, 9});
        QVERIFY(grid.force == force);
        QVERIFY(grid.position == position);
        QVERIFY(grid.lost.empty());
    }
    void lostPlacesAreNamedAndBridged()
    {
        const GriddedChannels grid = placeOnGrid(std::vector<double>{0, 4, 5}, std::vector<double>{1, -3, 0},
                                                 std::vector<std::int64_t>{0, 4, 5});
        QVERIFY((grid.lost == std::vector<std::size_t>{1, 2, 3}));
        QVERIFY((grid.force == std::vector<double>{0, 1, 2, 3, 4, 5}));
        QVERIFY((grid.position == std::vector<double>{1, 0, -1, -2, -3, 0}));
    }
    void whatTheGridCanHoldIsReproduced()
    {
        // A cubic position and a straight force are within the grid's functions: only rounding is left, here
        // of values up to 100.
        const Jittered clock = jittered(60, 0.1, {20, 40, 41});
        const std::vector<double> force = valuesAt(clock.time, line), position = valuesAt(clock.time, cubic);
        const GriddedChannels grid =
            resampleToGrid(force, position, clock.index, clock.time, ForceHold::First);
        QVERIFY((grid.lost == std::vector<std::size_t>{20, 40, 41}));
        for (std::size_t n = 0; n < 60; ++n) {
            if (n == 20 || n == 40 || n == 41)
                continue;
            QVERIFY(std::abs(grid.force[n] - line(static_cast<double>(n))) < 1e-11);
            QVERIFY(std::abs(grid.position[n] - cubic(static_cast<double>(n))) < 1e-10);
        }
    }
    void regularTimesChangeNothingButRounding()
    {
        GaussianNoise random(2);
        std::vector<double> force, position;
        for (int n = 0; n < 50; ++n) {
            force.push_back(random());
            position.push_back(random());
        }
        const Jittered clock = jittered(50, 0);
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
            const GriddedChannels grid = resampleToGrid(force, position, clock.index, clock.time, hold);
            for (std::size_t n = 0; n < 50; ++n) {
                QVERIFY(std::abs(grid.force[n] - force[n]) < 1e-13);
                QVERIFY(std::abs(grid.position[n] - position[n]) < 1e-13);
            }
        }
    }
    void theImpulseIsKept()
    {
        // Between the first and last grid point, where the hats add up to one.
        const Jittered clock = jittered(80, 0.1);
        GaussianNoise random(9);
        std::vector<double> force;
        for (std::size_t i = 0; i < clock.time.size(); ++i)
            force.push_back(random());
        std::vector<double> steps = projectForce(force, clock.time, 1, 78, ForceHold::Zero);
        double held = 0, exact = 0;
        for (const double value : steps)
            held += value;
        for (std::size_t i = 0; i < force.size(); ++i) {
            const double from = std::clamp(clock.time[i], 1.0, 79.0);
            const double to = i + 1 < force.size() ? std::clamp(clock.time[i + 1], 1.0, 79.0) : 79.0;
            exact += force[i] * (to - from);
        }
        QVERIFY(std::abs(held - exact) < 1e-11);
    }
    void theProjectionIsTheNearestHeldForce()
    {
        // Nothing in reach is nearer: any change of the values makes the squared distance larger.
        const Jittered clock = jittered(12, 0.15);
        GaussianNoise random(4);
        std::vector<double> force;
        for (std::size_t i = 0; i < clock.time.size(); ++i)
            force.push_back(random());
        const auto straight = [](const std::vector<double>& time, const std::vector<double>& value,
                                 double t) {
            std::size_t i = 0;
            while (i + 2 < time.size() && time[i + 1] <= t)
                ++i;
            const double share = (t - time[i]) / (time[i + 1] - time[i]);
            return (1 - share) * value[i] + share * value[i + 1];
        };
        const std::vector<double> points{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
        const auto distance = [&](const std::vector<double>& values) {
            double sum = 0;
            for (int i = 0; i < 9000; ++i) {
                const double t = 1 + (i + 0.5) / 1000;
                const double d = straight(clock.time, force, t) - straight(points, values, t);
                sum += d * d / 1000;
            }
            return sum;
        };
        const std::vector<double> best = projectForce(force, clock.time, 1, 10, ForceHold::First);
        const double least = distance(best);
        for (std::size_t n = 0; n < best.size(); ++n) {
            for (const double change : {-0.02, 0.02}) {
                std::vector<double> other = best;
                other[n] += change;
                QVERIFY(distance(other) > least);
            }
        }
    }
    void fewSamplesAreNoTrouble()
    {
        for (std::size_t count = 0; count < 6; ++count) {
            const Jittered clock = jittered(count, 0.1);
            const std::vector<double> ones(count, 1.0);
            for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
                const GriddedChannels grid = resampleToGrid(ones, ones, clock.index, clock.time, hold);
                QCOMPARE(grid.force.size(), count);
                for (const double value : grid.force)
                    QVERIFY(std::abs(value - 1) < 1e-12);
            }
        }
    }
    void tooManyLostCutTheRecordAtItsGaps()
    {
        // 10 samples, 100 lost, 40 samples with 4 lost among them.
        std::vector<std::int64_t> index;
        for (int n = 0; n < 10; ++n)
            index.push_back(n);
        for (int n = 0; n < 44; ++n) {
            if (n % 10 != 5)
                index.push_back(110 + n);
        }
        QVERIFY((keepLostShare(index, 0.25) == Window{10, index.size() - 10}));
        QVERIFY((keepLostShare(index, 0.8) == Window{0, index.size()}));
        QVERIFY((keepLostShare({}, 0.25) == Window{0, 0}));
        const std::vector<std::int64_t> apart{0, 1000, 1000000};
        QVERIFY((keepLostShare(apart, 0.25) == Window{0, 1}));
    }
};

GRIPSCOPE_TEST(RegularGridTest)
#include "regular_grid_test.moc"
