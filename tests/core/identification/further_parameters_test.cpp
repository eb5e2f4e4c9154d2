// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/identification_json.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "tests/support/test_registry.h"

#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using P = MotionParameter;

namespace {

MotionEstimate rubbing(double friction, double deviation)
{
    MotionEstimate motion;
    motion.terms.friction = true;
    motion.values[P::Mass] = 1;
    motion.values[P::Damping] = 2;
    motion.values[P::Stiffness] = 3;
    motion.values[P::Friction] = friction;
    motion.covariance = Eigen::MatrixXd::Identity(4, 4) * 1e-4;
    motion.covariance(3, 3) = deviation * deviation;
    return motion;
}

} // namespace

class FurtherParametersTest : public QObject {
    Q_OBJECT
private slots:
    /// 0.5 N, known to 0.03 and its scale to 8 %: sqrt(0.03^2 + 0.04^2) = 0.05.
    void theScaleOfTheForceIsCounted()
    {
        MeasuringChain chain;
        chain.forceScaleUncertainty = 0.08;
        chain.positionScaleUncertainty = 0.5; // friction has no length in it
        const auto further = furtherParameters(rubbing(0.5, 0.03), chain, {}, 0.95);
        QCOMPARE(further.size(), 1U); // m, b and k have their own place
        QVERIFY(further[0].parameter == P::Friction);
        QVERIFY(std::abs(further[0].combined.standardUncertainty - 0.05) < 1e-12);
        QVERIFY(std::abs(further[0].combined.coverageFactor - 1.959964) < 1e-5);
        QVERIFY(std::abs(further[0].interval.upper - (0.5 + 0.05 * 1.959964)) < 1e-6);
        QVERIFY(!further[0].interval.onlyUpperBound);
    }
    void frictionIsNotBelowZero()
    {
        const auto further = furtherParameters(rubbing(0.05, 0.1), {}, {}, 0.95);
        QCOMPARE(further[0].interval.lower, 0.0);
        QVERIFY(further[0].interval.onlyUpperBound);
    }
    /// Three parts of 1, 2 and 3 N, each known to 0.1: the variance of three is 1, of which 0.01 is their
    /// own.
    void partsThatDisagreeWidenIt()
    {
        const std::vector<MotionEstimate> parts{rubbing(1, 0.1), rubbing(2, 0.1), rubbing(3, 0.1)};
        const auto further = furtherParameters(rubbing(2, 0.06), {}, {parts, {}, {}, {}}, 0.95);
        const double expected = std::sqrt(0.0036 + 1 - 0.01);
        QVERIFY(std::abs(further[0].combined.standardUncertainty - expected) < 1e-12);
        QVERIFY(further[0].combined.degreesOfFreedom.has_value());
        const std::vector<MotionEstimate> alike{rubbing(1.9, 0.1), rubbing(2, 0.1), rubbing(2.1, 0.1)};
        QCOMPARE(furtherParameters(rubbing(2, 0.06), {}, {alike, {}, {}, {}}, 0.95)[0]
                     .combined.standardUncertainty,
                 0.06);
    }
    /// 0.5 N, in the other form 0.4 and 0.52 N: 0.04 away, known to 0.03.
    void anotherFormWidensIt()
    {
        MotionEstimate other = rubbing(0.4, 0.03);
        other.terms.eachWay = true;
        other.values[P::FrictionBack] = 0.52;
        const auto further = furtherParameters(rubbing(0.5, 0.03), {}, {{}, other, {}, {}}, 0.95);
        QVERIFY(std::abs(further[0].combined.standardUncertainty - 0.05) < 1e-12);
    }
    /// b 2 and k 3, of which the empty gripper is 0.5 and 1, known to 0.03 and 0.04; and one that is all of
    /// k.
    void theEmptyGripperIsTakenOff()
    {
        MotionEstimate slow = rubbing(0, 0.1);
        slow.terms.friction = false;
        slow.terms.mass = false;
        slow.covariance = Eigen::Vector2d(0.04 * 0.04, 0.03 * 0.03).asDiagonal();
        MeasuringChain chain;
        chain.baseline = GripperBaseline{{0.1, 0.5, 1}, {0.01, 0.03, 0.04}};
        const auto further = furtherParameters(slow, chain, {}, 0.95);
        QCOMPARE(further.size(), 2U);
        QCOMPARE(further[0].value, 1.5);
        QCOMPARE(further[1].value, 2.0);
        for (const FurtherParameter& one : further)
            QVERIFY(std::abs(one.combined.standardUncertainty - 0.05) < 1e-12);
        chain.baseline->parameters[2] = 3;
        QCOMPARE(furtherParameters(slow, chain, {}, 0.95).size(), 1U);
    }
    void withoutAMassAllStandThere()
    {
        MotionEstimate slow = rubbing(0, 0.1);
        slow.terms.friction = false;
        slow.terms.mass = false;
        slow.covariance = Eigen::MatrixXd::Identity(2, 2) * 1e-4;
        UncertaintyBudget budget;
        budget.further = furtherParameters(slow, {}, {}, budget.coverage);
        const QJsonObject json = toJson(budget);
        const QJsonObject parameters = json[u"parameters"_s].toObject();
        QVERIFY(parameters[u"m"_s].isNull());
        QCOMPARE(parameters[u"b"_s].toDouble(), 2.0);
        QCOMPARE(parameters[u"k"_s].toDouble(), 3.0);
        QVERIFY(json[u"intervals"_s][u"m"_s].isNull());
        QVERIFY(json[u"intervals"_s][u"k"_s][u"lower"_s].toDouble() < 3);
        QVERIFY(json[u"covariance"_s].isNull());
    }
};

GRIPSCOPE_TEST(FurtherParametersTest)
#include "further_parameters_test.moc"
