// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/friction_motion.h"
#include "tests/core/identification/jumping_force.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

namespace {

using Slopes = Dual<8>;
using P = MotionParameter;

/// Times of the size of a sample.
MotionIntegrator<Slopes>::Coefficients coefficients(double friction)
{
    MotionIntegrator<Slopes>::Coefficients all{};
    const std::pair<P, double> values[] = {
        {P::Mass, 20},      {P::Damping, 2},        {P::Stiffness, 1},   {P::Friction, friction},
        {P::Relaxing, 0.3}, {P::RelaxationTime, 8}, {P::DampingBack, 3}, {P::FrictionBack, 0.6 * friction}};
    int direction = 0;
    for (const auto& [parameter, value] : values)
        all[static_cast<std::size_t>(parameter)] = Slopes(value, direction++);
    return all;
}

struct Difference {
    double position = 0, slopes = 0;
    int atRest = 0; ///< samples
};

/// The largest difference of both ways over 2,000 samples, positions in between.
Difference difference(const MotionTerms& terms, double friction, bool ramps)
{
    MotionIntegrator<Slopes> exact(terms, coefficients(friction));
    FrictionMotion<Slopes> quick(terms, coefficients(friction));
    exact.begin(0.2, 0.1, 0.1, 0);
    quick.begin(0.2, 0.1, 0.1);
    JumpingForce forces(3);
    double from = 0;
    Difference found;
    for (int n = 0; n < 2000; ++n) {
        const double to = forces.next();
        const double before = exact.position().value;
        for (const double duration : {0.4, 0.6}) {
            const double start = ramps ? from : to;
            if (!exact.advance(duration, start, to) || !quick.advance(duration, start, to))
                return {1e300, 1e300, 0};
        }
        from = to;
        found.atRest += before == exact.position().value ? 1 : 0;
        found.position = std::max(found.position, std::abs(exact.position().value - quick.position().value));
        found.slopes =
            std::max(found.slopes, (exact.position().slope - quick.position().slope).abs().maxCoeff());
    }
    return found;
}

} // namespace

/// Sliding by products and turning by the series is what the series would have found alone.
class FrictionMotionTest : public QObject {
    Q_OBJECT
private slots:
    void everySampleIsTheIntegrators_data()
    {
        QTest::addColumn<bool>("friction");
        QTest::addColumn<bool>("relaxation");
        QTest::addColumn<bool>("eachWay");
        QTest::addColumn<bool>("ramps");
        for (int i = 1; i < 16; ++i)
            if (bool(i & 1) || bool(i & 4))
                QTest::addRow("%d", i) << bool(i & 1) << bool(i & 2) << bool(i & 4) << bool(i & 8);
    }
    void everySampleIsTheIntegrators()
    {
        QFETCH(bool, friction);
        QFETCH(bool, relaxation);
        QFETCH(bool, eachWay);
        QFETCH(bool, ramps);
        const MotionTerms terms{.friction = friction, .relaxation = relaxation, .eachWay = eachWay};
        QVERIFY(FrictionMotion<Slopes>::describes(terms));
        for (const double size : {0.02, 0.3, 1.5}) {
            const Difference found = difference(terms, size, ramps);
            // Both leave 1e-12 of the motion at each sample. An event's moment is found to some 1e-13 of a
            // sample, and its derivatives divide by how fast the speed passes zero there.
            QVERIFY2(found.position < 1e-9, qPrintable(QString::number(found.position)));
            QVERIFY2(found.slopes < 1e-6, qPrintable(QString::number(found.slopes)));
            if (friction && size > 1)
                QVERIFY(found.atRest > 100);
        }
    }
    void whatHoldsRelaxesOn()
    {
        const MotionTerms terms{.friction = true, .relaxation = true};
        auto c = coefficients(0.5);
        FrictionMotion<Slopes> motion(terms, c);
        motion.begin(0.0, 0.0, 1.0); // 0.3 of force in the dashpot, held by 0.5
        for (int n = 0; n < 100; ++n)
            QVERIFY(motion.advance(1, 0, 0));
        QCOMPARE(motion.position().value, 0.0);
        // The dashpot has let go: what little it still holds does not help against 0.52.
        QVERIFY(motion.advance(1, 0.52, 0.52));
        QVERIFY(motion.position().value > 0);
    }
    void whatIsTooStiffIsSaid()
    {
        auto stiff = coefficients(0.1);
        stiff[static_cast<std::size_t>(P::Stiffness)] = Slopes(1e6);
        FrictionMotion<Slopes> motion({.friction = true}, stiff);
        motion.begin(0.0, 0.0, 0.0);
        QVERIFY(!motion.advance(1, 1, 1));
    }
    void othersAreNotItsOwn()
    {
        QVERIFY(!FrictionMotion<double>::describes({.friction = true, .cubic = true}));
        QVERIFY(!FrictionMotion<double>::describes({.relaxation = true}));
        QVERIFY(!FrictionMotion<double>::describes({.mass = false, .friction = true}));
    }
};

GRIPSCOPE_TEST(FrictionMotionTest)
#include "friction_motion_test.moc"
