// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/comparison/hold_evidence.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/identification.h"
#include "core/identification/result/identification_json.h"
#include "tests/core/identification/duffing_simulation.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

Synthetic comparedCan()
{
    Synthetic synthetic;
    synthetic.truth = {0.0396, 43, 9990};
    synthetic.sampleTime_s = 5e-4;
    synthetic.bit_s = 5e-3;
    synthetic.peak = 10;
    synthetic.samples = 500;
    synthetic.fitPercent = 97;
    synthetic.hold = ForceHold::First;
    return synthetic;
}

ModelComparison compare(const Recording& recording, OutputErrorOptions options, bool cubic = false)
{
    options.sampleTime_s = recording.sampleTime_s;
    const Estimate linear = estimateOutputError(recording.force, recording.position, options);
    std::vector<Estimate> motions;
    if (cubic)
        motions.push_back(estimateMotion(recording.force, recording.position,
                                         test::duffingOptions(recording.sampleTime_s)));
    return compareModels(recording.force, recording.position, options, linear,
                         estimateOtherHold(recording.force, recording.position, options, linear), motions);
}

} // namespace

class ModelComparisonTest : public QObject {
    Q_OBJECT
private slots:
    /// They are as long as the record, and only the budget needs them.
    void whatIsComparedKeepsNoInfluences()
    {
        IdentificationOptions options;
        options.estimators = {Estimator::OutputError, Estimator::Duffing};
        const Identification found = identify(comparedCan().make(), options);
        QVERIFY(found.comparison.find(u"cubic_spring"_s) != nullptr);
        for (const ComparedModel& model : found.comparison.ranked)
            QVERIFY(!model.estimate.motion || model.estimate.motion->influences.size() == 0);
        QCOMPARE(found.find(Estimator::Duffing)->motion->influences.size(), Eigen::Index(0));
    }
    void theTrueLinearModelIsEnough()
    {
        // A superfluous parameter gains chi-square with one degree over 2 ln L: to gain 10 + ln N it needs
        // 16, which happens once in 15,000.
        Synthetic synthetic = comparedCan();
        for (int run = 0; run < 25; ++run) {
            synthetic.seed = static_cast<std::uint64_t>(run) + 1;
            const ModelComparison found = compare(synthetic.make(), {}, run < 5);
            QVERIFY2(!found.decisive, qPrintable(found.sentence.describe()));
            QCOMPARE(found.sentence.describe(), u"The linear model is enough."_s);
            double sum = 0;
            for (const ComparedModel& model : found.ranked)
                sum += model.weight;
            QVERIFY(std::abs(sum - 1) < 1e-12);
            QCOMPARE(found.ranked.front().delta, 0.0);
        }
    }

    void aStiffeningSpringIsNamed()
    {
        Recording recording = comparedCan().make();
        recording.position = test::simulateDuffing({0.0396, 43, 9990}, 1e9, recording.force,
                                                   {recording.sampleTime_s, ForceHold::First, 0, 0, 0, 0});
        GaussianNoise draw(2);
        for (double& y : recording.position)
            y += 1e-5 * draw();
        const ModelComparison found = compare(recording, {}, true);
        QVERIFY(found.decisive);
        QCOMPARE(found.ranked.front().id, u"cubic_spring"_s);
        QCOMPARE(found.sentence.describe(), u"A stiffening spring explains this squeeze better."_s);
    }

    void aDelayIsNamedAndMeasured()
    {
        Synthetic synthetic = comparedCan();
        synthetic.lag_s = 2e-4;
        const ModelComparison found = compare(synthetic.make(), {});
        QVERIFY(found.decisive);
        const ComparedModel* delay = found.find(u"delay"_s);
        QVERIFY(delay != nullptr && delay->delay_s);
        // Its standard error is 5 us here (the bound, one nuisance more).
        QVERIFY2(std::abs(*delay->delay_s - 2e-4) < 2e-5, qPrintable(QString::number(*delay->delay_s)));
        QVERIFY(delay->delta < decisiveDelta);
    }

    void theOtherHoldIsNamed()
    {
        Synthetic synthetic = comparedCan();
        synthetic.fitPercent = 99;
        OutputErrorOptions held;
        held.hold = ForceHold::Zero;
        const ModelComparison found = compare(synthetic.make(), held);
        QVERIFY(found.decisive);
        QVERIFY(found.find(u"other_hold"_s)->delta < decisiveDelta);
    }

    void aMissingOffsetIsNamed()
    {
        Synthetic synthetic = comparedCan();
        synthetic.offset = 5e-4; // a share of the travel: with more there is no linear estimate at all
        OutputErrorOptions fixed;
        fixed.freeOffset = false;
        const ModelComparison found = compare(synthetic.make(), fixed);
        QVERIFY(found.decisive);
        QCOMPARE(found.sentence.describe(), u"An offset of the position explains this squeeze better."_s);
    }

    void aModelThatHasNowhereToSettleIsLeftOut()
    {
        // Without the offset that there is, twenty times the travel, the stiffness runs away.
        Synthetic synthetic = comparedCan();
        synthetic.samples = 200;
        synthetic.offset = 0.02;
        const ModelComparison found = compare(synthetic.make(), {});
        QVERIFY(found.find(u"without_offset"_s) == nullptr);
        QVERIFY(found.find(u"delay"_s) != nullptr && found.find(u"smooth_force"_s) != nullptr);
        QVERIFY(!found.decisive);
    }

    void nothingToCompareSaysNothing()
    {
        const ModelComparison found = compareModels({}, {}, {}, {}, {});
        QVERIFY(found.ranked.empty());
        QVERIFY(found.sentence.isEmpty());
        QVERIFY(toJson(found)[u"models"_s].toArray().isEmpty());
        const ModelComparison one = compare(comparedCan().make(), {});
        QVERIFY(toJson(one)[u"models"_s][0][u"criterion"_s].isDouble());
    }
};

GRIPSCOPE_TEST(ModelComparisonTest)
#include "model_comparison_test.moc"
