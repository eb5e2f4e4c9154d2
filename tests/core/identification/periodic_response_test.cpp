// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/periodic/periodic_response.h"
#include "core/math/fourier.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gripscope;

namespace {

struct Case {
    Eigen::Vector3d parameters; ///< M, B, K, time in samples
    ForceHold hold = ForceHold::Zero;
    double rest = 0;
};

Case fetchCase()
{
    QFETCH_GLOBAL(int, hold);
    QFETCH(double, frequency);
    QFETCH(double, damping);
    QFETCH(double, rest);
    return {{1, 2 * damping * frequency, frequency * frequency},
            hold == 0 ? ForceHold::Zero : ForceHold::First,
            rest};
}

} // namespace

class PeriodicResponseTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase_data()
    {
        QTest::addColumn<int>("hold");
        QTest::newRow("zoh") << 0;
        QTest::newRow("foh") << 1;
    }
    void itIsTheDiscreteFourierTransformOfTheSimulatedAnswer_data()
    {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("rest");
        QTest::newRow("slow") << 0.05 << 0.3 << 0.0;
        QTest::newRow("critical") << 0.1 << 1.0 << 0.0;
        QTest::newRow("overdamped, between samples") << 0.3 << 5.0 << 0.4;
        QTest::newRow("ringing, between samples") << 1.0 << 0.05 << 0.9;
        QTest::newRow("faster than the samples") << 4.0 << 0.5 << 0.25;
    }
    void itIsTheDiscreteFourierTransformOfTheSimulatedAnswer()
    {
        const Case wanted = fetchCase();
        // Periods of noise until the start has died away: 40 time constants.
        constexpr std::size_t period = 50;
        const double slowest =
            std::max(2 / wanted.parameters(1), wanted.parameters(1) / wanted.parameters(2));
        const std::size_t periods = 2 + static_cast<std::size_t>(40 * slowest / period);
        GaussianNoise random(1);
        std::vector<double> force(period);
        for (double& f : force)
            f = random();
        for (std::size_t i = period; i < period * (periods + 1); ++i)
            force.push_back(force[i - period]);
        const Eigen::Vector3d& p = wanted.parameters;
        const std::vector<double> position =
            simulate({p(0), p(1), p(2)}, force, {1.0, wanted.hold, wanted.rest});
        const auto last = [&](const std::vector<double>& values) {
            return std::span(values).subspan((periods - 1) * period, period);
        };
        const std::vector<std::complex<double>> u = fourierTransform(last(force));
        const std::vector<std::complex<double>> y = fourierTransform(last(position));

        const PeriodicResponse response(p.array().log(), wanted.hold, wanted.rest);
        QVERIFY(response.finite());
        double largest = 0;
        for (const std::complex<double>& bin : y)
            largest = std::max(largest, std::abs(bin));
        for (std::size_t q = 0; q < u.size(); ++q) {
            const double w = 2 * std::numbers::pi * double(q) / period;
            QVERIFY(std::abs(response.at(w, u[q]).position - y[q]) < 1e-10 * largest);
        }
    }

    void gradientsAreDerivatives_data() { itIsTheDiscreteFourierTransformOfTheSimulatedAnswer_data(); }
    void gradientsAreDerivatives()
    {
        const Case wanted = fetchCase();
        const Eigen::Vector3d theta = wanted.parameters.array().log();
        const std::complex<double> force{0.3, -0.7};
        constexpr double step = 1e-5;
        for (const double w : {0.01, 0.1, 1.0, 3.0}) {
            const PeriodicResponse::Value value =
                PeriodicResponse(theta, wanted.hold, wanted.rest).at(w, force);
            for (Eigen::Index i = 0; i < 3; ++i) {
                const Eigen::Vector3d change = step * Eigen::Vector3d::Unit(i);
                const std::complex<double> above =
                    PeriodicResponse(theta + change, wanted.hold, wanted.rest).at(w, force).position;
                const std::complex<double> below =
                    PeriodicResponse(theta - change, wanted.hold, wanted.rest).at(w, force).position;
                // Central differences: the square of the step, and rounding over the step.
                const double tolerance = 1e-7 * std::abs(value.position) * (1 + 1 / wanted.parameters(1));
                QVERIFY(std::abs((above - below) / (2 * step) - value.gradient(i)) < tolerance);
            }
        }
    }

    void theStartsTransientIsExact()
    {
        QFETCH_GLOBAL(int, hold);
        // One record from a start of its own: transform = G U + what the state lost from first to last
        // sample.
        const ForceHold held = hold == 0 ? ForceHold::Zero : ForceHold::First;
        const MassDampingStiffness truth{1, 0.04, 0.09};
        constexpr std::size_t count = 200;
        std::vector<double> force;
        for (std::size_t t = 0; t <= count; ++t)
            force.push_back(std::sin(2 * std::numbers::pi * 3 * double(t) / count));
        const SimulationOptions options{1.0, held, 0, 2, -0.5, 0};
        const std::vector<double> all = simulate(truth, force, options);
        const std::vector<std::complex<double>> u = fourierTransform(std::span(force).first(count));
        const std::vector<std::complex<double>> y = fourierTransform(std::span(all).first(count));
        // The state after the last sample, from two positions and the exact step between them.
        const ExactStep<2> step = discretize(truth, 1.0, held);
        Eigen::Vector2d state{2, -0.5};
        for (std::size_t t = 0; t < count; ++t)
            state = (step.phi * state + step.gamma0 * force[t] + step.gamma1 * force[t + 1]).eval();
        const Eigen::Vector2d start = (Eigen::Vector2d(2, -0.5) - state) / std::sqrt(double(count));
        const PeriodicResponse response(
            Eigen::Vector3d(std::log(truth.m), std::log(truth.b), std::log(truth.k)), held, 0);
        for (std::size_t q = 0; q < u.size(); ++q) {
            const double w = 2 * std::numbers::pi * double(q) / count;
            QVERIFY(std::abs(response.at(w, u[q], start).position - y[q]) < 1e-9);
            const auto byStart = response.byStart(w);
            const std::complex<double> without = response.at(w, u[q]).position;
            QVERIFY(std::abs(without + byStart(0) * start(0) + byStart(1) * start(1) - y[q]) < 1e-9);
        }
    }

    void whatIsNoNumberIsNoAnswer()
    {
        QVERIFY(!PeriodicResponse({800, 0, 0}, ForceHold::Zero, 0).finite());
        QVERIFY(!PeriodicResponse({-800, 0, 0}, ForceHold::Zero, 0).finite());
        QVERIFY(!PeriodicResponse({0, 700, 0}, ForceHold::First, 0.5).finite());
    }
};

GRIPSCOPE_TEST(PeriodicResponseTest)
#include "periodic_response_test.moc"
