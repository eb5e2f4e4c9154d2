// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/determined_parameters.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using P = MotionParameter;

namespace {

Estimate converged(Estimator estimator)
{
    Estimate estimate;
    estimate.estimator = estimator;
    estimate.status = EstimateStatus::Converged;
    return estimate;
}

/// m, b, k and Fc in N and mm.
Estimate withFriction()
{
    Estimate estimate = converged(Estimator::Friction);
    estimate.parameters = MassDampingStiffness{4e-5, 0.04, 10};
    estimate.covariance = Eigen::Vector3d(1e-14, 1e-8, 1e-4).asDiagonal();
    MotionEstimate& motion = estimate.motion.emplace();
    motion.terms = {.friction = true};
    motion.values[P::Friction] = 0.4;
    motion.covariance = Eigen::Vector4d(1e-14, 1e-8, 1e-4, 1e-4).asDiagonal();
    return estimate;
}

Identification of(const Estimate& estimate)
{
    Identification identification;
    identification.estimates = {estimate};
    identification.recommended = estimate.estimator;
    return identification;
}

} // namespace

class DeterminedParametersTest : public QObject {
    Q_OBJECT
private slots:
    void everyParameterHasAUnit()
    {
        const ParameterUnits units = parameterUnits(u"N"_s, u"mm"_s);
        QCOMPARE(unitOf(P::Relaxing, units), u"N/mm"_s);
        QCOMPARE(unitOf(P::Friction, units), u"N"_s);
        QCOMPARE(unitOf(P::RelaxationTime, units), u"s"_s);
        QCOMPARE(unitOf(P::Cubic, units), u"N/mm^3"_s);
        QCOMPARE(unitOf(P::Cubic, parameterUnits(u"1"_s, u"1"_s)), u"1"_s);
        QCOMPARE(unitOf(P::Friction, parameterUnits(u"1"_s, u"1"_s)), u"1"_s);
    }
    void channelsOfAnyUnitAreTakenToSi()
    {
        const std::vector<DeterminedParameter> found = determinedParameters(withFriction(), u"kN"_s, u"mm"_s);
        QCOMPARE(found.size(), std::size_t(4));
        QVERIFY(found[0].parameter == P::Mass);
        QCOMPARE(found[0].unit, u"kg"_s);
        QVERIFY(std::abs(found[0].value / 40 - 1) < 1e-12); // 4e-5 kN s^2/mm
        QVERIFY(std::abs(found[2].value / 1e7 - 1) < 1e-12);
        QVERIFY(found[3].parameter == P::Friction);
        QCOMPARE(found[3].unit, u"N"_s);
        QVERIFY(std::abs(found[3].value / 400 - 1) < 1e-12);
        QVERIFY(std::abs((found[3].interval->upper - found[3].value) / (1.959964 * 10) - 1) < 1e-6);
    }
    void unitsAsPrintedStay()
    {
        const std::vector<DeterminedParameter> found = determinedParameters(withFriction(), u"1"_s, u"1"_s);
        QCOMPARE(found[3].unit, u"1"_s);
        QCOMPARE(found[3].value, 0.4);
    }
    void theBudgetGoesBeforeTheNoise()
    {
        Identification identification = of(withFriction());
        UncertaintyBudget& budget = identification.budget;
        budget.parameters = identification.estimates.front().parameters;
        for (CoverageInterval& interval : budget.intervals)
            interval = {1, 2};
        budget.further = {{P::Friction, 0.3, {}, {0.1, 0.5}}}; // the gripper's own taken off
        const std::vector<DeterminedParameter> found = determinedParameters(identification, u"N"_s, u"mm"_s);
        QCOMPARE(found.size(), std::size_t(4));
        QCOMPARE(found[2].interval->upper, 2000.0);
        QCOMPARE(found[3].value, 0.3);
        QCOMPARE(found[3].interval->lower, 0.1);
    }
    void frictionThatMayBeNoneIsAnUpperBound()
    {
        Estimate estimate = withFriction();
        estimate.motion->values[P::Friction] = 0.01;
        const auto found = determinedParameters(of(estimate), u"N"_s, u"mm"_s);
        QVERIFY(found[3].interval->onlyUpperBound);
        QCOMPARE(found[3].interval->lower, 0.0);
    }
    void aStiffnessThatIsOnlyKnownFromBelowIsABound()
    {
        Estimate held;
        held.estimator = Estimator::Static;
        held.status = EstimateStatus::NotIdentifiable;
        held.stiffnessBounds = StiffnessBounds{1.5, {}};
        const auto found = determinedParameters(of(held), u"N"_s, u"mm"_s);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].isLowerBound && !found[0].interval);
        QCOMPARE(found[0].value, 1500.0);
    }
    void aFailedEstimateTellsNothing()
    {
        QVERIFY(determinedParameters(of(Estimate()), u"N"_s, u"mm"_s).empty());
        QVERIFY(determinedParameters(Identification(), u"N"_s, u"mm"_s).empty());
        Estimate lost = withFriction();
        lost.status = EstimateStatus::NotConverged;
        lost.parameters.reset();
        QVERIFY(determinedParameters(lost, u"N"_s, u"mm"_s).empty());
    }
};

GRIPSCOPE_TEST(DeterminedParametersTest)
#include "determined_parameters_test.moc"
