// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "tests/support/test_registry.h"
#include "ui/feed/live_feed.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

constexpr MassDampingStiffness can{0.0396, 43, 9990};

/// A squeeze of one second at 2 kHz, at rest before and after it; every `loseEvery`-th sample missing.
std::vector<Sample> squeeze(std::size_t loseEvery = 0)
{
    ExcitationOptions excitation;
    excitation.samples = 2000;
    const std::vector<double> force = *makeExcitation(excitation);
    const std::vector<double> position =
        simulate(can, force, {excitation.sampleTime_s, ForceHold::Zero, 0, 0.002, 0, 0.01});
    GaussianNoise noise(3);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < force.size(); ++i)
        if (loseEvery == 0 || i % loseEvery != loseEvery - 1)
            samples.push_back({100 + i, static_cast<double>(i) * excitation.sampleTime_s, force[i],
                               position[i] + 1e-5 * noise(), StatusMoving});
    samples.push_back({100 + force.size(), 1, force.back(), position.back(), 0});
    return samples;
}

LiveEstimate after(const std::vector<Sample>& samples)
{
    LiveEstimate live;
    live.reset(0.0005, ForceHold::Zero, 0);
    live.append(samples);
    return live;
}

bool holds(const RecursiveState& state)
{
    const Eigen::Vector3d error = state.parameters->vector() - can.vector();
    const Eigen::Vector3d allowed = 4 * state.covariance->diagonal().cwiseSqrt();
    return (error.cwiseAbs().array() < allowed.array()).all();
}

} // namespace

class LiveEstimateTest : public QObject {
    Q_OBJECT
private slots:
    void nothingBeforeTheGripperMoves()
    {
        const LiveEstimate live = after({{1, 0, 20, 0.01, 0}, {2, 0.0005, 20, 0.01, StatusArmed}});
        QVERIFY(!live.state());
        QVERIFY(!live.following());
    }
    void aSqueezeIsFollowedAndItsEndIsKept()
    {
        const LiveEstimate live = after(squeeze());
        QVERIFY(!live.following());
        QVERIFY(live.state() && live.state()->parameters && live.state()->covariance);
        QCOMPARE(live.state()->samples, std::size_t(2000));
        QVERIFY(holds(*live.state()));
    }
    void lostSamplesKeepTheirTime()
    {
        const LiveEstimate live = after(squeeze(200));
        QVERIFY(live.state() && live.state()->parameters);
        // The sample behind the last one that moved shows that it was the last that was lost.
        QVERIFY(live.state()->samples >= 1999);
        // A held force instead of the lost one disturbs the answer for a while: within a few per cent.
        QVERIFY(std::abs(live.state()->parameters->k / can.k - 1) < 0.05);
    }
    void theNextSqueezeStartsAfresh()
    {
        std::vector<Sample> samples = squeeze();
        LiveEstimate live = after(samples);
        samples.resize(10);
        live.append(samples);
        QVERIFY(live.following());
        QCOMPARE(live.state()->samples, std::size_t(10));
        live.reset(0.001, ForceHold::First, 0);
        QVERIFY(!live.state());
    }
};

GRIPSCOPE_TEST(LiveEstimateTest)
#include "live_estimate_test.moc"
