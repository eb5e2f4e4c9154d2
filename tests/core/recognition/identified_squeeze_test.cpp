// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/models_by_space.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/recognition/verdict/verdict.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using P = MotionParameter;
using Q = TypeQuantity;

namespace {

bool isNear(double found, double expected, double relative = 1e-12)
{
    return std::abs(found / expected - 1) < relative;
}

/// A recommended estimate with these terms, in N and mm: m 4e-5, b 0.04, k 10, k1 2, tau 0.05, Fc 0.4, each
/// known to 1 %.
Identification found(const MotionTerms& terms, Estimator estimator)
{
    Estimate estimate;
    estimate.estimator = estimator;
    estimate.status = EstimateStatus::Converged;
    MotionEstimate& motion = estimate.motion.emplace();
    motion.terms = terms;
    motion.values[P::Mass] = 4e-5;
    motion.values[P::Damping] = 0.04;
    motion.values[P::Stiffness] = 10;
    motion.values[P::Relaxing] = 2;
    motion.values[P::RelaxationTime] = 0.05;
    motion.values[P::Friction] = 0.4;
    const std::vector<P> parameters = terms.parameters();
    const auto count = static_cast<Eigen::Index>(parameters.size());
    motion.covariance = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        motion.covariance(i, i) = std::pow(0.01 * motion.values[parameters[static_cast<std::size_t>(i)]], 2);
    if (terms.mass && terms.spring) {
        estimate.parameters = MassDampingStiffness{4e-5, 0.04, 10};
        estimate.covariance = motion.covariance.topLeftCorner<3, 3>();
    }
    Identification identification;
    identification.estimates = {estimate};
    identification.recommended = estimator;
    return identification;
}

MotionEstimate& motionIn(Identification& identification)
{
    return *identification.estimates.front().motion;
}

TypeSqueeze foam(const QString& type, double tau, double e)
{
    TypeSqueeze squeeze{type, {0.04 * e, 40 / e, 1e4 * e}};
    const QuantitySpace space{{Q::Mass, Q::Damping, Q::Stiffness, Q::RelaxationTime}};
    LogVector log(4);
    log << std::log(0.04 * e), std::log(40 / e), std::log(1e4 * e), std::log(tau / e);
    squeeze.determined = DeterminedQuantities{space, log, {}};
    return squeeze;
}

} // namespace

class IdentifiedSqueezeTest : public QObject {
    Q_OBJECT
private slots:
    void massDampingAndStiffnessAloneNeedNoMore()
    {
        const Identification linear = found({}, Estimator::OutputError);
        QVERIFY(!determinedQuantities(linear, u"N"_s, u"mm"_s));
        const auto squeeze = identifiedSqueeze(u"A"_s, linear, u"N"_s, u"mm"_s);
        QVERIFY(squeeze && !squeeze->determined && squeeze->covariance);
        QCOMPARE(squeeze->parameters.k, 10000.0);
    }

    void aYieldingPartHasAShareAndATime()
    {
        const Identification zener = found({.relaxation = true}, Estimator::Zener);
        const auto determined = determinedQuantities(zener, u"N"_s, u"mm"_s);
        QVERIFY(determined);
        QCOMPARE(toString(determined->space), u"m+b+k+k1/k+tau"_s);
        QVERIFY(isNear(std::exp(determined->log[2]), 1e4));
        QVERIFY(isNear(std::exp(determined->log[3]), 0.2));
        QVERIFY(isNear(std::exp(determined->log[4]), 0.05));
        // One per cent each, the share of two of them: c_ij of log(k1/k) is var k1 + var k, and -var k with
        // k.
        QVERIFY(isNear((*determined->covariance)(3, 3), 2e-4, 1e-9));
        QVERIFY(isNear((*determined->covariance)(2, 3), -1e-4, 1e-9));
        QVERIFY(isNear((*determined->covariance)(4, 4), 1e-4, 1e-9));
        QCOMPARE(identifiedSqueeze({}, zener, u"N"_s, u"mm"_s)->parameters.k, 10000.0);
    }

    void withoutAMassTheRestIsWhatThereIs()
    {
        const Identification slow = found({.mass = false}, Estimator::Static);
        const auto squeeze = identifiedSqueeze(u"A"_s, slow, u"N"_s, u"mm"_s);
        QVERIFY(squeeze && squeeze->determined);
        QCOMPARE(toString(squeeze->determined->space), u"b+k"_s);
        QVERIFY(!coordinatesOf(*squeeze, {}));
    }

    void whatIsHardlyKnownDoesNotCount()
    {
        Identification zener = found({.relaxation = true}, Estimator::Zener);
        motionIn(zener).covariance(4, 4) *= 60 * 60; // tau to 60 %
        QCOMPARE(toString(determinedQuantities(zener, u"N"_s, u"mm"_s)->space), u"m+b+k+k1/k"_s);
        Identification rubbing = found({.friction = true}, Estimator::Friction);
        QCOMPARE(toString(determinedQuantities(rubbing, u"N"_s, u"mm"_s)->space), u"m+b+k+Fc"_s);
        motionIn(rubbing).covariance(3, 3) *= 40 * 40; // Fc to 40 %: it may be none
        QVERIFY(!determinedQuantities(rubbing, u"N"_s, u"mm"_s));
    }

    void theGrippersOwnIsTakenOff()
    {
        Identification rubbing = found({.friction = true}, Estimator::Friction);
        rubbing.budget.parameters = rubbing.estimates.front().parameters;
        rubbing.budget.further = {{P::Friction, 0.3, {}, {0.2, 0.4}}}; // of 0.4 N, 0.1 N the gripper's
        const auto determined = determinedQuantities(rubbing, u"kN"_s, u"mm"_s);
        QVERIFY(determined);
        QVERIFY(isNear(std::exp(determined->log[3]), 300));
        QVERIFY(isNear((*determined->covariance)(3, 3), std::pow(0.004 / 0.3, 2), 1e-9));
    }

    void whatIsToldIsWhatWasDetermined()
    {
        const Identification zener = found({.relaxation = true}, Estimator::Zener);
        const auto determined = determinedQuantities(zener, u"N"_s, u"mm"_s);
        const auto told = determinedParameters(*determined, u"N"_s, u"mm"_s);
        const auto direct = determinedParameters(zener, u"N"_s, u"mm"_s);
        QCOMPARE(told.size(), direct.size());
        for (std::size_t i = 0; i < told.size(); ++i) {
            QVERIFY(told[i].parameter == direct[i].parameter);
            QCOMPARE(told[i].unit, direct[i].unit);
            QVERIFY(isNear(told[i].value, direct[i].value));
            // Askew against symmetric: of 1 % they differ by a half of it squared.
            QVERIFY(isNear(told[i].interval->upper, direct[i].interval->upper, 3e-4));
        }
    }

    void nothingFoundIsNothing()
    {
        QVERIFY(!identifiedSqueeze({}, Identification{}, u"N"_s, u"mm"_s));
        Identification failed = found({.relaxation = true}, Estimator::Zener);
        failed.estimates.front().status = EstimateStatus::NotConverged;
        failed.estimates.front().parameters.reset();
        QVERIFY(!identifiedSqueeze({}, failed, u"N"_s, u"mm"_s));
    }

    void aSpaceIsReadAsItIsWritten()
    {
        for (const QString& text : {u"m+b+k"_s, u"k+k1/k+tau"_s, u"Fc"_s})
            QCOMPARE(toString(quantitySpaceFromString(text).value()), text);
        for (const QString& text : {u""_s, u"m+m"_s, u"m+x"_s, u"m,b"_s, u"m+"_s})
            QVERIFY2(!quantitySpaceFromString(text), qPrintable(text));
    }

    void aSqueezeIsJudgedByAsMuchAsItDetermines()
    {
        std::vector<TypeSqueeze> squeezes;
        for (const double e : {0.97, 0.99, 1.0, 1.02, 1.03, 0.98})
            for (const double tau : {0.02, 0.08})
                squeezes.push_back(foam(tau < 0.05 ? u"quick"_s : u"slow"_s, tau, e));
        const ModelsBySpace types(squeezes);
        QCOMPARE(toString(types.whole()->space), u"m+b+k+tau"_s);
        QCOMPARE(types.modelsFor(squeezes.front()), types.whole());
        const TypeSqueeze plain{{}, {0.04, 40, 1e4}};
        QCOMPARE(types.modelsFor(plain), types.linear());
        const TypeSqueeze soft = squeezeAt({}, QuantitySpace{{Q::Stiffness}}, LogVector::Constant(1, 9.2));
        QCOMPARE(toString(types.modelsFor(soft)->space), u"k"_s);
        QCOMPARE(types.modelsFor(soft), types.modelsFor(soft)); // fitted once
        const TypeSqueeze rubs = squeezeAt({}, QuantitySpace{{Q::Friction}}, LogVector::Constant(1, 0.1));
        QCOMPARE(types.modelsFor(rubs), types.whole()); // none of it: nothing to be judged by
        QVERIFY(judge(*types.whole(), rubs).kind == VerdictKind::Invalid);
        // By m, b and k the two are one; how they yield tells them apart.
        QVERIFY(judge(*types.whole(), foam({}, 0.02, 1.01)).type == u"quick"_s);
        QVERIFY(judge(*types.linear(), plain).kind == VerdictKind::Inconclusive);
    }

    void typesWithNothingMoreAreAsBefore()
    {
        std::vector<TypeSqueeze> squeezes;
        for (const double e : {0.98, 1.0, 1.01, 1.02})
            squeezes.push_back({u"A"_s, {0.04 * e, 40 / e, 1e4}});
        const ModelsBySpace types(squeezes);
        QCOMPARE(types.whole(), types.linear());
        QVERIFY(types.whole()->space == QuantitySpace{});
    }
};

GRIPSCOPE_TEST(IdentifiedSqueezeTest)
#include "identified_squeeze_test.moc"
