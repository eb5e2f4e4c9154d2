// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/estimate.h"
#include "core/identification/output_error/output_error.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;

namespace {

Eigen::Matrix3d someCovariance()
{
    Eigen::Matrix3d covariance;
    covariance << 4, 1, 0.5, 1, 9, 2, 0.5, 2, 16;
    return covariance;
}

} // namespace

class BaselineTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsShownEnrolledAndJudgedIsTheObjectAlone()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        recording.chain.baseline = GripperBaseline{{0.01, 0.02, 0.03}, {1e-4, 1e-4, 1e-4}};
        const Identification found = identify(recording);
        QVERIFY(found.object() && found.best());
        const Eigen::Vector3d off = found.best()->parameters->vector() - found.object()->parameters.vector();
        QVERIFY((off - Eigen::Vector3d(0.01, 0.02, 0.03)).cwiseAbs().maxCoeff() < 1e-15);
        // The budget's middle is the same, so that its interval belongs to what is judged.
        QVERIFY(
            (found.budget.parameters->vector() - found.object()->parameters.vector()).cwiseAbs().maxCoeff() <
            1e-15);
    }
    void aSqueezeThatIsNotToldFromTheEmptyGripperIsInvalid()
    {
        Recording recording = Synthetic().make();
        recording.chain.baseline = GripperBaseline{{0.01, 0.02, 0.2}, {1e-4, 1e-4, 1e-4}};
        const Identification found = identify(recording);
        QVERIFY(found.best() && !found.object());
        QVERIFY(found.validity.verdict == ValidityVerdict::Invalid);
    }
    void parallelPartsSubtractAndTheirVariancesAdd()
    {
        const auto object =
            withoutGripper({10, 20, 30}, someCovariance(), GripperBaseline{{1, 2, 3}, {0.5, 1, 2}});
        QVERIFY(object.has_value());
        QCOMPARE(object->parameters.m, 9.0);
        QCOMPARE(object->parameters.b, 18.0);
        QCOMPARE(object->parameters.k, 27.0);
        Eigen::Matrix3d wanted = someCovariance();
        wanted.diagonal() += Eigen::Vector3d(0.25, 1, 4);
        QVERIFY((object->covariance - wanted).cwiseAbs().maxCoeff() < 1e-12);
    }
    void anObjectThatIsNotToldFromTheGripperIsNoObject()
    {
        QVERIFY(!withoutGripper({10, 20, 30}, someCovariance(), GripperBaseline{{10, 2, 3}, {}}));
        QVERIFY(!withoutGripper({10, 20, 30}, someCovariance(), GripperBaseline{{1, 2, 31}, {}}));
    }
    void whatIsNotFiniteGivesNothing()
    {
        QVERIFY(!withoutGripper({NAN, 20, 30}, someCovariance(), GripperBaseline{}));
        QVERIFY(!withoutGripper({INFINITY, 20, 30}, someCovariance(), GripperBaseline{}));
        QVERIFY(!withoutGripper({1, 2, 3}, someCovariance(), GripperBaseline{{}, {1e200, 0, 0}}));
    }
    // Without noise the estimate is exact, so the difference must be the object to its accuracy.
    void theObjectIsFoundInTheHandOfAKnownGripper()
    {
        const GripperBaseline gripper{{0.02, 0.05, 0.01}, {}};
        Synthetic record;
        const MassDampingStiffness object = record.truth;
        record.truth = {object.m + 0.02, object.b + 0.05, object.k + 0.01};
        const Recording recording = record.make();
        OutputErrorOptions options;
        options.sampleTime_s = recording.sampleTime_s;
        options.hold = ForceHold::Zero;
        const Estimate both = estimateOutputError(recording.force, recording.position, options);
        const auto alone = withoutGripper(*both.parameters, *both.covariance, gripper);
        QVERIFY(alone.has_value());
        QVERIFY(relativeDifference(alone->parameters, object) < 1e-6);
    }
};

GRIPSCOPE_TEST(BaselineTest)
#include "baseline_test.moc"
