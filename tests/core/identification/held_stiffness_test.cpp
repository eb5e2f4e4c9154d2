// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/result/identification_json.h"
#include "core/signal/preparation/preparation.h"
#include "tests/core/identification/held_squeeze.h"
#include "tests/support/test_registry.h"

#include <QJsonObject>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

Estimate loadingOf(const Recording& recording)
{
    return runEstimator(Estimator::Static, prepare(recording), {});
}

const ValidityCheck* checkOf(const Identification& found, const QString& id)
{
    const auto at = std::ranges::find(found.validity.checks, id, &ValidityCheck::id);
    return at != found.validity.checks.end() ? &*at : nullptr;
}

} // namespace

class HeldStiffnessTest : public QObject {
    Q_OBJECT
private slots:
    void theBoundsHoldTheTruth()
    {
        int holds = 0, told = 0;
        constexpr int runs = 200;
        for (int run = 0; run < runs; ++run) {
            // From 0.3 to 3 N/mm: the loading takes from 4.4 to 0.44 s.
            const double truth = 300 * std::pow(10, run / double(runs));
            const Recording recording = HeldSqueeze::random(truth, std::uint64_t(run) + 1).make();
            const Estimate found = loadingOf(recording);
            QVERIFY2(found.stiffnessBounds.has_value(), qPrintable(found.message.english()));
            const auto& [lower, upper] = *found.stiffnessBounds;
            holds += lower <= truth && truth <= upper.value_or(truth) ? 1 : 0;
            told += upper ? 1 : 0;
            QVERIFY2(upper || truth > 500, qPrintable(QString::number(truth)));
            QVERIFY(!upper || *upper <= 5 * lower); // the travel within a factor of four, and the noise
        }
        QVERIFY2(holds >= 0.95 * runs, qPrintable(QString::number(holds)));
        QVERIFY2(told >= runs / 4 && told < runs, qPrintable(QString::number(told)));
    }
    void aRigidPartIsBoundedFromBelowAlone()
    {
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const HeldSqueeze squeeze = HeldSqueeze::random(1e7, seed);
            const Estimate found = loadingOf(squeeze.make());
            QVERIFY(found.status == EstimateStatus::NotIdentifiable);
            QVERIFY2(found.stiffnessBounds && !found.stiffnessBounds->upper && !found.motion,
                     qPrintable(found.message.english()));
            QVERIFY(found.stiffnessBounds->lower > 0 && found.stiffnessBounds->lower < squeeze.k_NPerM);
        }
    }
    void aKnownLagMakesTheBoundsNarrower()
    {
        HeldSqueeze squeeze;
        squeeze.lag_s = 0.1;
        Recording recording = squeeze.make();
        const Estimate apart = loadingOf(recording);
        recording.forceLag_s = -squeeze.lag_s; // what a row shows was measured before its force
        const Estimate known = loadingOf(recording);
        QVERIFY(apart.stiffnessBounds->upper && known.stiffnessBounds->upper);
        const auto& [lower, upper] = *known.stiffnessBounds;
        QVERIFY(lower < squeeze.k_NPerM && squeeze.k_NPerM < *upper);
        QVERIFY(lower > apart.stiffnessBounds->lower && *upper < *apart.stiffnessBounds->upper);
    }
    void whatTheFrameYieldsIsTakenOff()
    {
        Recording recording = HeldSqueeze().make();
        const Estimate without = loadingOf(recording);
        recording.chain.frameCompliance = 0.2 / 600; // a sixth of what is measured is the frame's
        const Estimate with = loadingOf(recording);
        QVERIFY(with.stiffnessBounds->lower > without.stiffnessBounds->lower);
        QVERIFY(without.message.english().contains(u"fingers together"_s));
        QVERIFY(!with.message.english().contains(u"fingers together"_s));
    }
    void aRecordThatEndsTooSoonIsRefusedWithoutABound()
    {
        const HeldSqueeze squeeze;
        const Recording recording = squeeze.make();
        const double end_s = squeeze.touch_s() + squeeze.loading_s() + 0.1;
        const Estimate found = loadingOf(slice(recording, {0, std::size_t(end_s / squeeze.sampleTime_s)}));
        QVERIFY(found.status == EstimateStatus::NotIdentifiable);
        QVERIFY(!found.stiffnessBounds && !found.message.isEmpty());
    }
    void aPersonIsToldTheStiffnessWithoutAsking()
    {
        const Recording recording = HeldSqueeze().make();
        const Identification found = identify(recording);
        QVERIFY(found.recommended == Estimator::Static);
        QVERIFY(found.validity.verdict == ValidityVerdict::Suspect);
        QCOMPARE(summaryOf(found.validity).checksFailed, QStringList{u"position_held"_s});
        QVERIFY(
            checkOf(found, u"position_held"_s)->message.english().contains(u"while the force rises from"_s));
        for (const Estimate& estimate : found.estimates)
            if (estimate.estimator != Estimator::Static) {
                QVERIFY(estimate.status == EstimateStatus::NotApplicable);
                QVERIFY(estimate.message.english().contains(u"renewed only every"_s));
            }
        QVERIFY(!found.budget.parameters && found.budget.further.size() == 1);
        const FurtherParameter& k = found.budget.further.front();
        const StiffnessBounds& bounds = *found.find(Estimator::Static)->stiffnessBounds;
        QVERIFY(k.parameter == MotionParameter::Stiffness && k.interval.logarithmic);
        QCOMPARE(k.interval.lower, bounds.lower);
        QCOMPARE(k.interval.upper, *bounds.upper);
        const QJsonObject document = toJson(found, recording, u"x"_s);
        const QJsonObject parameters = document[u"budget"_s][u"parameters"_s].toObject();
        QVERIFY(parameters[u"m"_s].isNull() && parameters[u"b"_s].isNull() && parameters[u"k"_s].isDouble());
    }
    void theScalesOfTheChannelsWidenTheInterval()
    {
        Recording recording = HeldSqueeze().make();
        recording.chain.forceScaleUncertainty = 0.05;
        const Identification found = identify(recording);
        QVERIFY(found.budget.further.size() == 1);
        const StiffnessBounds& bounds = *found.find(Estimator::Static)->stiffnessBounds;
        QVERIFY(found.budget.further.front().interval.lower < 0.95 * bounds.lower);
    }
    void whatIsRefusedIsInvalid()
    {
        const Identification found = identify(HeldSqueeze::random(1e7, 3).make());
        QVERIFY(found.recommended == Estimator::Static);
        QVERIFY(found.validity.verdict == ValidityVerdict::Invalid);
        QVERIFY(found.budget.further.empty());
        QVERIFY(summaryOf(found.validity).reasons.front().english().contains(u"k is at least"_s));
    }
};

GRIPSCOPE_TEST(HeldStiffnessTest)
#include "held_stiffness_test.moc"
