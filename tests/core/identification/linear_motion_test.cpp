// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/linear_motion.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

using Slopes = Dual<6>;
using P = MotionParameter;

/// Times of the size of a sample.
MotionIntegrator<Slopes>::Coefficients coefficients()
{
    MotionIntegrator<Slopes>::Coefficients all{};
    const std::pair<P, double> values[] = {{P::Mass, 2},       {P::Damping, 0.8},      {P::Stiffness, 0.3},
                                           {P::Relaxing, 0.2}, {P::RelaxationTime, 5}, {P::ForceOffset, 0.1}};
    int direction = 0;
    for (const auto& [parameter, value] : values)
        all[static_cast<std::size_t>(parameter)] = Slopes(value, direction++);
    return all;
}

} // namespace

/// What is found once for all samples is what each would have found by itself.
class LinearMotionTest : public QObject {
    Q_OBJECT
private slots:
    void everySampleIsTheIntegrators_data()
    {
        QTest::addColumn<bool>("mass");
        QTest::addColumn<bool>("spring");
        QTest::addColumn<bool>("relaxation");
        QTest::addColumn<bool>("offset");
        for (int i = 0; i < 16; ++i)
            QTest::addRow("%d", i) << bool(i & 1) << bool(i & 2) << bool(i & 4) << bool(i & 8);
    }
    void everySampleIsTheIntegrators()
    {
        QFETCH(bool, mass);
        QFETCH(bool, spring);
        QFETCH(bool, relaxation);
        QFETCH(bool, offset);
        const MotionTerms terms{
            .mass = mass, .spring = spring, .relaxation = relaxation, .forceOffset = offset};
        QVERIFY(LinearMotion<Slopes>::describes(terms));
        MotionIntegrator<Slopes> each(terms, coefficients());
        LinearMotion<Slopes> once(terms, coefficients());
        each.begin(0.7, -0.2, 0.3, 1);
        once.begin(0.7, each.speed(), 0.3);
        GaussianNoise draw(5);
        double force = 1;
        for (int n = 0; n < 300; ++n) {
            const double next = draw();
            for (const double duration : {0.3, 0.7}) {
                QVERIFY(each.advance(duration, force, next));
                QVERIFY(once.advance(duration, force, next));
            }
            force = next;
            // Both leave 1e-12 of the motion at each sample; it and its derivatives grow to some tens.
            QVERIFY(std::abs(each.position().value - once.position().value) < 1e-10);
            QVERIFY((each.position().slope - once.position().slope).abs().maxCoeff() < 1e-8);
        }
    }
    void whatIsTooStiffIsSaid()
    {
        auto stiff = coefficients();
        stiff[static_cast<std::size_t>(P::Stiffness)] = Slopes(1e6);
        LinearMotion<Slopes> motion({}, stiff);
        motion.begin(0.0, 0.0, 0.0);
        QVERIFY(!motion.advance(1, 1, 1));
        QVERIFY(!motion.advance(1, 1, 1));
    }
    void aBendIsNotLinear()
    {
        QVERIFY(!LinearMotion<double>::describes({.friction = true}));
        QVERIFY(!LinearMotion<double>::describes({.cubic = true}));
        QVERIFY(!LinearMotion<double>::describes({.eachWay = true}));
    }
};

GRIPSCOPE_TEST(LinearMotionTest)
#include "linear_motion_test.moc"
