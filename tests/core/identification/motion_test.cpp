// SPDX-License-Identifier: GPL-3.0-or-later
// The family of motions against a simulator that shares nothing with it.
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/motion/motion.h"
#include "core/identification/motion/motion_search.h"
#include "tests/core/identification/real_squeeze.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using P = MotionParameter;

namespace {

MotionProblem problemOf(const RealSqueeze& squeeze)
{
    return {makeOutputErrorProblem(squeeze.force(), squeeze.position(), squeeze.options()), squeeze.terms};
}

MotionPoint truthOf(const RealSqueeze& squeeze, const MotionProblem& problem)
{
    MotionPoint point;
    MotionValues values;
    for (const P parameter : squeeze.terms.parameters())
        values[parameter] = squeeze.truthOf(parameter);
    point.values = inProblemUnits(problem, values);
    const std::vector<double> start =
        simulateRealPart(squeeze.part, squeeze.times(), squeeze.force(), squeeze.hold, {0});
    point.x0 = start.front() / problem.positionScale;
    point.offset = (0.01 - problem.positionShift) / problem.positionScale;
    return point;
}

} // namespace

class MotionTest : public QObject {
    Q_OBJECT
private slots:
    void motionIsThatOfAnotherSimulator_data() { partRows(); }
    void motionIsThatOfAnotherSimulator()
    {
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
            RealSqueeze squeeze = rowSqueeze();
            squeeze.hold = hold;
            squeeze.noise_m = 0;
            const MotionProblem problem = problemOf(squeeze);
            const std::vector<double> own = positionsAt(problem, truthOf(squeeze, problem));
            QCOMPARE(own.size(), problem.position.size());
            double largest = 0;
            double size = 0;
            for (std::size_t i = 0; i < own.size(); ++i) {
                largest = std::max(largest, std::abs(own[i] - problem.position[i]));
                size = std::max(size, std::abs(problem.position[i]));
            }
            // The other one's steps of 5 us leave 1e-6 where it sticks and slips, far less where it does not.
            QVERIFY2(largest < 2e-6 * size, qPrintable(QString::number(largest / size)));
        }
    }

    void derivativesAreThoseOfTheMotion_data() { partRows(); }
    void derivativesAreThoseOfTheMotion()
    {
        const RealSqueeze squeeze = rowSqueeze();
        const MotionProblem problem = problemOf(squeeze);
        // It moves at the start: from rest within the friction a speed of either sign comes to the same.
        MotionPoint point = truthOf(squeeze, problem);
        point.v0 = 0.01;
        const auto rows = motionRows(problem, point);
        QVERIFY(rows);
        for (int column = 0; column < problem.unknowns(); ++column) {
            constexpr double step = 1e-6;
            Eigen::VectorXd by = Eigen::VectorXd::Zero(problem.unknowns());
            by(column) = step;
            const std::vector<double> above = positionsAt(problem, point.moved(problem, by));
            const std::vector<double> below = positionsAt(problem, point.moved(problem, -by));
            double error = 0;
            double size = 0;
            for (std::size_t i = 0; i < above.size(); ++i) {
                const double slope = (above[i] - below[i]) / (2 * step);
                const double own = rows->sensitivities(static_cast<Eigen::Index>(i), column);
                error = std::max(error, std::abs(slope - own));
                size = std::max(size, std::abs(own));
            }
            // Central differences of a motion near 1 in double precision: 1e-16 / 1e-6, and curvature.
            QVERIFY2(error < 1e-6 * std::max(size, 1.0),
                     qPrintable(u"column %1: %2"_s.arg(column).arg(error)));
        }
    }

    void withoutAnOffsetTheTruthComesBack_data() { partRows(); }
    void withoutAnOffsetTheTruthComesBack()
    {
        // From rest where no force is, so that nothing of the start is sought; the position some samples
        // later.
        const RealSqueeze squeeze = rowSqueeze();
        std::vector<double> force = squeeze.force();
        const double first = force.front();
        for (double& value : force)
            value -= first;
        MotionOptions options = squeeze.options();
        options.freeOffset = false;
        options.freeInitialState = false;
        options.lag_s = 12.4 * squeezeSampleTime_s;
        std::vector<double> later = squeeze.times();
        for (double& time : later)
            time += options.lag_s;
        const std::vector<double> position =
            simulateRealPart(squeeze.part, squeeze.times(), force, squeeze.hold, later);
        const Estimate found = estimateMotion(force, position, options);
        QVERIFY2(found.status == EstimateStatus::Converged, qPrintable(found.message.describe()));
        QVERIFY(!found.nuisance.offset && !found.nuisance.x0);
        for (const P parameter : squeeze.terms.parameters()) {
            const double truth = squeeze.truthOf(parameter);
            const double value = found.motion->values[parameter];
            // The other simulator is good to 1e-8 of the motion; tau and k1 are the worst determined.
            QVERIFY2(std::abs(value / truth - 1) < 1e-5,
                     qPrintable(u"%1: %2 of %3"_s.arg(toString(parameter)).arg(value).arg(truth)));
        }
    }

    void forcesThatWereLostAreFoundBesideFurtherTerms_data() { partRows(); }
    void forcesThatWereLostAreFoundBesideFurtherTerms()
    {
        // One sample in fifty, each by itself. The whole record's own errors are the measure: where the
        // forces are found without the further terms, they move k by many of them.
        const RealSqueeze squeeze = rowSqueeze();
        const Estimate whole = squeeze.estimate();
        QVERIFY(whole.status == EstimateStatus::Converged);
        MotionOptions options = squeeze.options();
        for (std::size_t i = 33; i < squeeze.samples; i += 50)
            options.lost.push_back(i);
        std::vector<double> force = squeeze.force();
        for (const std::size_t lost : options.lost)
            force[lost] = 1e3;
        const Estimate found = estimateMotion(force, squeeze.position(), options);
        QVERIFY2(found.status == EstimateStatus::Converged, qPrintable(found.message.describe()));
        for (const P parameter : {P::Mass, P::Damping, P::Stiffness}) {
            const double moved = (found.motion->values[parameter] - whole.motion->values[parameter]) /
                                 *found.motion->standardError(parameter);
            QVERIFY2(std::abs(moved) < 1, qPrintable(toString(parameter) + QString::number(moved)));
        }
    }

    void startsWrongByTenTimesAreMended_data() { partRows(); }
    void startsWrongByTenTimesAreMended()
    {
        const RealSqueeze squeeze = rowSqueeze();
        const Estimate right = squeeze.estimate();
        QVERIFY(right.status == EstimateStatus::Converged);
        for (const double factor : {0.1, 10.0}) {
            MotionOptions options = squeeze.options();
            options.start = MassDampingStiffness{squeeze.part.m * factor, squeeze.part.b / factor,
                                                 squeeze.part.k * factor};
            const Estimate found = estimateMotion(squeeze.force(), squeeze.position(), options);
            QVERIFY(found.status == EstimateStatus::Converged);
            const double moved = found.motion->values[P::Stiffness] - right.motion->values[P::Stiffness];
            const double error = std::sqrt(right.motion->covariance(2, 2));
            QVERIFY2(std::abs(moved) < 0.02 * error, qPrintable(QString::number(moved / error)));
        }
    }

    void aSlowGripperGetsNoMass()
    {
        // 100 readings a second of a soft part: its mass answers within a sample.
        RealSqueeze squeeze;
        squeeze.part = {.m = 0.001, .b = 30, .k = 1000};
        std::vector<double> times;
        std::vector<double> force;
        for (int i = 0; i < 300; ++i) {
            times.push_back(0.01 * i);
            force.push_back(10 + 5 * std::sin(0.11 * i) + 3 * std::sin(0.031 * i * i / 10));
        }
        std::vector<double> position = simulateRealPart(squeeze.part, times, force, ForceHold::First, times);
        GaussianNoise noise(3);
        for (double& x : position)
            x += 1e-5 * noise();
        MotionOptions options;
        options.sampleTime_s = 0.01;
        options.terms = {.mass = false};
        options.estimator = Estimator::Static;
        const Estimate estimate = estimateMotion(force, position, options);
        QVERIFY(estimate.status == EstimateStatus::Converged);
        QVERIFY(!estimate.parameters && !estimate.covariance);
        const double k = estimate.motion->values[P::Stiffness];
        const double error = std::sqrt(estimate.motion->covariance(1, 1));
        QVERIFY2(std::abs(k - 1000) < 4 * error && error < 1, qPrintable(QString::number(k)));
    }

    void constantOrShortRecordsSaySo()
    {
        RealSqueeze squeeze;
        squeeze.terms.friction = true;
        const std::vector<double> force(500, 20.0);
        Estimate estimate = estimateMotion(force, squeeze.position(), squeeze.options());
        QVERIFY(estimate.status == EstimateStatus::NotApplicable); // of different lengths
        squeeze.samples = 500;
        estimate = estimateMotion(force, squeeze.position(), squeeze.options());
        QVERIFY(estimate.status == EstimateStatus::NotIdentifiable);
        estimate = estimateMotion(squeeze.force(), force, squeeze.options());
        QVERIFY(estimate.status == EstimateStatus::NotIdentifiable);
        squeeze.samples = 6;
        QVERIFY(squeeze.estimate().status == EstimateStatus::TooFewSamples);
    }

    void whatNeverMovesBackHasNoFrictionBack()
    {
        constexpr int substeps = 100;
        std::vector<double> force;
        std::vector<double> position;
        double x = 0;
        double v = 0;
        for (int i = 0; i < 600; ++i) {
            force.push_back(1 + 0.5 * std::sin(0.07 * i) + 0.3 * std::sin(0.0004 * i * i));
            position.push_back(x);
            for (int j = 0; j < substeps; ++j) { // 0.2 kg, 4 N s/m, 0.1 N, always forwards
                v += 0.001 / substeps * (force.back() - 4 * v - 0.1) / 0.2;
                x += 0.001 / substeps * v;
            }
        }
        QVERIFY(std::ranges::is_sorted(position));
        GaussianNoise noise(8);
        for (double& measured : position)
            measured += 1e-6 * noise();
        MotionOptions options;
        options.sampleTime_s = 0.001;
        options.hold = ForceHold::First;
        options.estimator = Estimator::Carriage;
        options.terms = {.spring = false, .friction = true, .eachWay = true};
        MotionProblem problem{makeOutputErrorProblem(force, position, options), options.terms};
        MotionPoint point;
        point.values[P::Mass] = 0.2;
        point.values[P::Damping] = point.values[P::DampingBack] = 4;
        point.values[P::Friction] = point.values[P::FrictionBack] = 0.1;
        point.values = inProblemUnits(problem, point.values);
        MotionSearchResult there;
        there.linear = linearize(problem, point);
        QVERIFY(there.linear.finite && !there.linear.movesEveryParameter());
        QVERIFY(!there.isDetermined());
        const Estimate estimate = estimateMotion(force, position, options);
        QVERIFY(estimate.status == EstimateStatus::NotIdentifiable);
        QVERIFY(!estimate.motion);
    }

    void termsOfASumComeInAnyOrder()
    {
        QVERIFY(estimatorFromString(u"zener+friction"_s) == Estimator::FrictionZener);
        QVERIFY(estimatorFromString(u"friction+zener"_s) == Estimator::FrictionZener);
        QVERIFY(!estimatorFromString(u"friction+carriage"_s));
        QVERIFY(!estimatorFromString(QString()));
    }
};

GRIPSCOPE_TEST(MotionTest)
#include "motion_test.moc"
