// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// Free response to x(0) = 1, by the textbook formula in extended precision: phi(0,0) and phi(0,1).
struct FreeResponse {
    long double fromPosition, fromVelocity;

    FreeResponse(const MassDampingStiffness& p, long double t)
    {
        const long double s = p.b / (2.0L * p.m);
        const long double w2 = p.k / static_cast<long double>(p.m) - s * s;
        const long double decay = std::exp(-s * t);
        // Where the poles meet the other two formulas divide nothing by nothing.
        const bool critical = std::abs(w2) < 1e-14L * s * s;
        if (w2 > 0 && !critical) {
            const long double w = std::sqrt(w2);
            fromVelocity = decay * std::sin(w * t) / w;
            fromPosition = decay * std::cos(w * t) + s * fromVelocity;
        } else if (!critical) {
            // By the two real poles, which does not overflow.
            const long double r = std::sqrt(-w2);
            const long double slow = -p.k / static_cast<long double>(p.m) / (s + r);
            const long double fast = -(s + r);
            fromVelocity = (std::exp(slow * t) - std::exp(fast * t)) / (slow - fast);
            fromPosition = (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast);
        } else {
            fromVelocity = t * decay;
            fromPosition = decay * (1 + s * t);
        }
    }
};

double relative(double got, long double want)
{
    return static_cast<double>(std::abs((got - want) / want));
}

} // namespace

class DiscretizationTest : public QObject {
    Q_OBJECT
private slots:
    void agreesWithTheTextbook_data()
    {
        QTest::addColumn<double>("frequency"); // natural frequency times sample time
        QTest::addColumn<double>("damping");   // ratio
        for (const double frequency : {0.03, 0.3, 3.0}) {
            for (const double damping : {0.0, 0.01, 0.3, 1.0, 3.0, 100.0})
                QTest::addRow("wT %g, damping ratio %g", frequency, damping) << frequency << damping;
        }
    }
    void agreesWithTheTextbook()
    {
        QFETCH(double, frequency);
        QFETCH(double, damping);
        const double t = 0.002;
        const double w = frequency / t;
        const MassDampingStiffness p{0.35, 2 * damping * w * 0.35, w * w * 0.35};
        const FreeResponse free(p, t);
        const ExactStep<2> zero = discretize(p, t, ForceHold::Zero);
        const long double b = p.b;
        const long double k = p.k;
        const long double step = (1 - free.fromPosition) / k;
        const long double ramp = (t / k - b / (k * k) * (1 - free.fromPosition) - free.fromVelocity / k) / t;
        // The textbook formulas themselves cancel: some of the 19 digits are gone at the smallest w T.
        QVERIFY(relative(zero.phi(0, 0), free.fromPosition) < 1e-12);
        QVERIFY(relative(zero.phi(0, 1), free.fromVelocity) < 1e-12);
        QVERIFY(relative(zero.phi(1, 0), -k / p.m * free.fromVelocity) < 1e-12);
        QVERIFY(relative(zero.gamma0(0), step) < 1e-12);
        QVERIFY(relative(zero.gamma0(1), free.fromVelocity / p.m) < 1e-12);
        QVERIFY(zero.gamma1.isZero(0));
        const ExactStep<2> first = discretize(p, t, ForceHold::First);
        QVERIFY(relative(first.gamma1(0), ramp) < 1e-9);
        QVERIFY(relative(first.gamma0(0) + first.gamma1(0), step) < 1e-12);
        QVERIFY(relative(first.gamma1(1), step / t) < 1e-12);
    }
    void verySmallStepsDoNotCancel()
    {
        // w T = 1e-6: x after a step of force is F T^2/2m (1 - b T/3m - ...), where 1 - E (C + s S) would
        // lose 12 digits.
        const MassDampingStiffness p{1, 1, 1};
        const double t = 1e-6;
        const ExactStep<2> d = discretize(p, t, ForceHold::First);
        QVERIFY(relative(d.gamma0(0) + d.gamma1(0), t * t / 2 * (1 - t / 3)) < 1e-12);
        QVERIFY(relative(d.gamma1(0), t * t / 6 * (1 - t / 4)) < 1e-12);
        QVERIFY(relative(d.phi(1, 0), -t * (1 - t / 2)) < 1e-12);
    }
    void strongOverdampingStaysFinite()
    {
        // k/b = 1 /s: a pure relaxation towards F/k, the mass long settled.
        const MassDampingStiffness p{1e-12, 1, 1};
        const ExactStep<2> d = discretize(p, 0.1, ForceHold::Zero);
        QVERIFY(d.phi.allFinite());
        QVERIFY(std::abs(d.phi(0, 0) - std::exp(-0.1)) < 1e-5);
        QVERIFY(std::abs(d.gamma0(0) - (1 - std::exp(-0.1))) < 1e-5);
        QVERIFY(discretize({1e-300, 1, 1}, 1, ForceHold::First).phi.allFinite());
    }
    void aFreeMassAccelerates()
    {
        const ExactStep<2> d = discretize({2, 0, 0}, 3, ForceHold::Zero);
        QVERIFY(relative(d.gamma0(0), 9.0L / 4) < 1e-14);
        QVERIFY(relative(d.gamma0(1), 1.5L) < 1e-14);
        QVERIFY(relative(d.phi(0, 1), 3) < 1e-14);
    }
    void noTimeNoChange()
    {
        const ExactStep<2> d = discretize({1, 1, 1}, 0, ForceHold::First);
        QVERIFY(d.phi.isIdentity(0));
        QVERIFY(d.gamma0.isZero(0) && d.gamma1.isZero(0));
    }
    void twoHalfStepsAreOne()
    {
        const MassDampingStiffness p{0.04, 43, 9990};
        const ExactStep<2> whole = discretize(p, 0.001, ForceHold::Zero);
        const ExactStep<2> half = discretize(p, 0.0005, ForceHold::Zero);
        QVERIFY((half.phi * half.phi - whole.phi).norm() < 1e-12 * whole.phi.norm());
        QVERIFY((half.phi * half.gamma0 + half.gamma0 - whole.gamma0).norm() < 1e-12 * whole.gamma0.norm());
    }

    void aLagOfWholeSamplesShiftsThePosition()
    {
        const MassDampingStiffness p{0.04, 0.14, 0.1};
        const std::vector<double> force{0, 1, -1, 2, 0.5, 0.5, -2, 1};
        const std::vector<double> now = simulate(p, force, {0.05, ForceHold::Zero, 0, 0.3, -1, 7});
        const std::vector<double> later = simulate(p, force, {0.05, ForceHold::Zero, 0.1, 0.3, -1, 7});
        for (std::size_t n = 0; n + 2 < force.size(); ++n)
            QVERIFY(std::abs(later[n] - now[n + 2]) < 1e-14);
        const std::vector<double> sooner = simulate(p, force, {0.05, ForceHold::Zero, -0.1, 0.3, -1, 7});
        for (std::size_t n = 2; n < force.size(); ++n)
            QVERIFY(std::abs(sooner[n] - now[n - 2]) < 1e-14);
        QCOMPARE(sooner[0], 7.3); // before the record the object rests where it starts
    }
    void aLagOfPartOfASampleIsExact_data()
    {
        QTest::addColumn<bool>("straight");
        QTest::newRow("zero-order hold") << false;
        QTest::newRow("first-order hold") << true;
    }
    void aLagOfPartOfASampleIsExact()
    {
        // The same force on a grid four times as fine.
        QFETCH(bool, straight);
        const ForceHold hold = straight ? ForceHold::First : ForceHold::Zero;
        const MassDampingStiffness p{0.04, 0.14, 0.1};
        const std::vector<double> force{0, 1, -1, 2, 0.5, 0.5, -2, 1, 1};
        std::vector<double> fine;
        for (std::size_t i = 0; i < 4 * (force.size() - 1); ++i) {
            const double part = static_cast<double>(i % 4) / 4;
            const double end = force[i / 4 + 1];
            fine.push_back(straight ? (1 - part) * force[i / 4] + part * end : force[i / 4]);
        }
        const std::vector<double> coarse = simulate(p, force, {0.2, hold, 0.15, 0.3, -1, 0});
        const std::vector<double> exact = simulate(p, fine, {0.05, hold, 0, 0.3, -1, 0});
        for (std::size_t n = 0; 4 * n + 3 < exact.size(); ++n)
            QVERIFY2(std::abs(coarse[n] - exact[4 * n + 3]) < 1e-13, qPrintable(QString::number(n)));
    }
    void anAbsurdLagDoesNotHang()
    {
        QCOMPARE(simulate({1, 1, 1}, {1, 2, 3}, {0.1, ForceHold::First, 1e12, 0, 0, 0}).size(),
                 std::size_t(3));
        QCOMPARE(simulate({1, 1, 1}, {1, 2, 3}, {0.1, ForceHold::First, -1e12, 0, 0, 0}).size(),
                 std::size_t(3));
        QVERIFY(simulate({1, 1, 1}, {}, {0.1, ForceHold::First, 0, 0, 0, 0}).empty());
    }
};

GRIPSCOPE_TEST(DiscretizationTest)
#include "discretization_test.moc"
