// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/cubic_motion.h"
#include "core/identification/motion/friction_motion.h"
#include "tests/core/identification/jumping_force.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;

namespace {

using BentSlopes = Dual<10>;
using P = MotionParameter;
using BentCoefficients = MotionIntegrator<BentSlopes>::Coefficients;

/// Times of the size of a sample; a stiffness of 1, so that forces of 1 are positions of about 1.
struct BentPart {
    double rate = 0.2;    ///< of the part swinging freely, rad a sample
    double damping = 0.3; ///< ratio
    double cubic = 0.1;
    double friction = 0;
};

BentCoefficients coefficientsOf(const BentPart& part)
{
    BentCoefficients all{};
    const double mass = 1 / (part.rate * part.rate);
    const double damping = 2 * part.damping * std::sqrt(mass);
    const std::pair<P, double> values[] = {{P::Mass, mass},
                                           {P::Damping, damping},
                                           {P::Stiffness, 1},
                                           {P::Cubic, part.cubic},
                                           {P::Friction, part.friction},
                                           {P::ForceOffset, 0.1},
                                           {P::DampingBack, 1.3 * damping},
                                           {P::FrictionBack, 0.6 * part.friction}};
    int direction = 2;
    for (const auto& [parameter, value] : values)
        all[static_cast<std::size_t>(parameter)] = BentSlopes(value, direction++, std::max(value, 0.01));
    return all;
}

struct LargestDifference {
    double position = 0, slopes = 0;
};

/// From the integrator, over 1,000 samples, positions in between.
template <typename Quick>
LargestDifference fromIntegrator(const MotionTerms& terms, const BentPart& part, bool ramps)
{
    MotionIntegrator<BentSlopes> exact(terms, coefficientsOf(part));
    Quick quick(terms, coefficientsOf(part));
    exact.begin(BentSlopes(0.2, 0), BentSlopes(0.01, 1), BentSlopes(0), 0);
    quick.begin(BentSlopes(0.2, 0), BentSlopes(0.01, 1), BentSlopes(0));
    JumpingForce forces(1);
    double from = 0;
    LargestDifference found;
    for (int n = 0; n < 1000; ++n) {
        const double to = forces.next();
        for (const double duration : {0.4, 0.6}) {
            const double start = ramps ? from : to;
            if (!exact.advance(duration, start, to) || !quick.advance(duration, start, to))
                return {1e300, 1e300};
        }
        from = to;
        const BentSlopes difference = exact.position() - quick.position();
        const double size = std::max(exact.position().slope.abs().maxCoeff(), 1.0);
        found.position = std::max(found.position, std::abs(difference.value));
        found.slopes = std::max(found.slopes, difference.slope.abs().maxCoeff() / size);
    }
    return found;
}

} // namespace

/// Collocation of the cubic spring's force is what the series finds.
class CubicMotionTest : public QObject {
    Q_OBJECT
private slots:
    void everySampleIsTheIntegrators_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("cubic");
        QTest::addColumn<bool>("ramps");
        for (const double rate : {0.03, 0.2, 0.6, 1.0})
            for (const double damping : {0.05, 0.5, 1.3})
                for (const double cubic : {-0.005, 0.0, 0.1, 1.0})
                    for (const bool ramps : {false, true})
                        QTest::addRow("rate %g, damping %g, cubic %g%s", rate, damping, cubic,
                                      ramps ? ", ramps" : "")
                            << rate << damping << cubic << ramps;
    }
    void everySampleIsTheIntegrators()
    {
        QFETCH(double, rate);
        QFETCH(double, damping);
        QFETCH(double, cubic);
        QFETCH(bool, ramps);
        for (const bool offset : {false, true}) {
            const MotionTerms terms{.cubic = true, .forceOffset = offset};
            QVERIFY(CubicMotion<BentSlopes>::describes(terms));
            const LargestDifference found =
                fromIntegrator<CubicMotion<BentSlopes>>(terms, {rate, damping, cubic}, ramps);
            // Some 1e-14 a step, which a lightly damped motion adds up, the more the harder its spring.
            QVERIFY2(found.position < 1e-10, qPrintable(QString::number(found.position)));
            QVERIFY2(found.slopes < 1e-8, qPrintable(QString::number(found.slopes)));
        }
    }
    void turnsAndSticksAsTheIntegrator_data()
    {
        QTest::addColumn<bool>("eachWay");
        QTest::addColumn<bool>("ramps");
        QTest::addColumn<double>("friction");
        for (const bool eachWay : {false, true})
            for (const bool ramps : {false, true})
                for (const double friction : {0.02, 0.3, 1.0})
                    QTest::addRow("%g%s%s", friction, eachWay ? " each way" : "", ramps ? ", ramps" : "")
                        << eachWay << ramps << friction;
    }
    void turnsAndSticksAsTheIntegrator()
    {
        QFETCH(bool, eachWay);
        QFETCH(bool, ramps);
        QFETCH(double, friction);
        using Quick = FrictionMotion<BentSlopes, CubicMotion<BentSlopes>>;
        const MotionTerms terms{.friction = true, .cubic = true, .eachWay = eachWay};
        QVERIFY(Quick::describes(terms));
        for (const double cubic : {-0.02, 0.1, 1.0}) {
            const LargestDifference found = fromIntegrator<Quick>(terms, {0.3, 0.3, cubic, friction}, ramps);
            // As of FrictionMotion's.
            QVERIFY2(found.position < 1e-9, qPrintable(QString::number(found.position)));
            QVERIFY2(found.slopes < 1e-6, qPrintable(QString::number(found.slopes)));
        }
    }
    void whatRunsAwayIsSaid()
    {
        CubicMotion<double> motion({.cubic = true}, [] {
            MotionIntegrator<double>::Coefficients all{};
            all[static_cast<std::size_t>(P::Mass)] = 10;
            all[static_cast<std::size_t>(P::Damping)] = 1;
            all[static_cast<std::size_t>(P::Stiffness)] = 1;
            all[static_cast<std::size_t>(P::Cubic)] = -1;
            return all;
        }());
        motion.begin(0, 0, 0);
        bool bounded = true;
        for (int n = 0; n < 100 && bounded; ++n)
            bounded = motion.advance(1, 5, 5);
        QVERIFY(!bounded);
    }
    void aDashpotIsNotItsOwn()
    {
        QVERIFY(!CubicMotion<double>::describes({.relaxation = true, .cubic = true}));
        QVERIFY(!CubicMotion<double>::describes({.mass = false, .cubic = true}));
        QVERIFY(!CubicMotion<double>::describes({.friction = true, .cubic = true}));
        QVERIFY(!CubicMotion<double>::describes({}));
    }
};

GRIPSCOPE_TEST(CubicMotionTest)
#include "cubic_motion_test.moc"
