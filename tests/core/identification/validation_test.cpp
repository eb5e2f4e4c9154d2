// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/result/identification_json.h"
#include "core/identification/validation/validation.h"
#include "tests/core/identification/controlled_gripper.h"
#include "tests/core/identification/duffing_simulation.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

IdentificationOptions outputErrorOnly()
{
    IdentificationOptions options;
    options.estimators = {Estimator::OutputError};
    options.assess = false;
    return options;
}

Validation against(const Recording& first, const Recording& second)
{
    const Identification found = identify(first, outputErrorOnly());
    return validateOnRecording(*found.best(), first, second, u"other.csv"_s, outputErrorOnly().hold);
}

Synthetic squeeze(std::uint64_t seed, double fitPercent = 90)
{
    Synthetic synthetic;
    synthetic.seed = seed;
    synthetic.fitPercent = fitPercent;
    synthetic.x0 = 2;
    synthetic.offset = 5;
    return synthetic;
}

/// A spring m x'' + b x' + k x + k3 x^3 = F under a force of this size, with noise of 1 % of the position.
Recording cubicSqueeze(double k3, double peak, std::uint64_t seed)
{
    Synthetic synthetic = squeeze(seed, 100);
    synthetic.peak = peak;
    synthetic.x0 = synthetic.offset = 0;
    Recording recording = synthetic.make();
    recording.position = test::simulateDuffing(synthetic.truth, k3, recording.force,
                                               {recording.sampleTime_s, *recording.hold, 0, 0, 0, 0});
    GaussianNoise noise(seed);
    for (double& y : recording.position)
        y += 0.05 * noise();
    return recording;
}

bool finite(const Validation& v)
{
    const auto good = [](const std::optional<double>& p) { return !p || std::isfinite(*p); };
    return good(v.fit.simulationPercent) && good(v.fit.predictionPercent) && good(v.expectedPercent) &&
           good(v.whitenessP) && good(v.inputIndependenceP) && good(v.misfitP) && good(v.misfit) &&
           (!v.change || (v.change->allFinite() && v.changeErrors->allFinite()));
}

} // namespace

class ValidationTest : public QObject {
    Q_OBJECT
private slots:
    void withoutNoiseTheModelExplainsAnotherSqueezeToTheLastDigit()
    {
        const Validation found = against(squeeze(1, 100).make(), squeeze(2, 100).make());
        QVERIFY(found.asExpected.value_or(false));
        QVERIFY(*found.fit.simulationPercent > 99.999);
        QVERIFY(std::abs(*found.nuisance.offset - 5) < 1e-6 && std::abs(*found.nuisance.x0 - 2) < 1e-6);
    }
    void theFalseAlarmsAreAsManyAsStated()
    {
        // Squeezes of one object: the p-values of the misfit and of the input must be uniform. With 400
        // pairs the counts under 0.05 and 0.5 are binomial, 20 +- 4.4 and 200 +- 10; bounds of four
        // deviations.
        constexpr int pairs = 400;
        int misfitLow = 0, misfitHalf = 0, inputLow = 0, whiteLow = 0, alarms = 0;
        for (int i = 0; i < pairs; ++i) {
            const Validation found =
                against(squeeze(std::uint64_t(2 * i + 1)).make(), squeeze(std::uint64_t(2 * i + 2)).make());
            QVERIFY(found.misfitP && found.inputIndependenceP && found.whitenessP);
            misfitLow += *found.misfitP < 0.05;
            misfitHalf += *found.misfitP < 0.5;
            inputLow += *found.inputIndependenceP < 0.05;
            whiteLow += *found.whitenessP < 0.05;
            alarms += !*found.asExpected;
        }
        const QByteArray counts = QByteArray::number(misfitLow) + ' ' + QByteArray::number(misfitHalf) + ' ' +
                                  QByteArray::number(inputLow) + ' ' + QByteArray::number(whiteLow) + ' ' +
                                  QByteArray::number(alarms);
        QVERIFY2(misfitLow <= 38 && misfitHalf >= 160 && misfitHalf <= 240, counts);
        QVERIFY2(inputLow <= 38 && whiteLow <= 38, counts);
        QVERIFY2(alarms <= 13, counts); // 1 %: 4 +- 2
    }
    void theExpectedFitIsTheOneFoundOnTheAverage()
    {
        // Short records first, so that their errors count. The squares of the misfit, whose expectation it
        // is: with 200 pairs the mean of the excess, some tenths of the whole, is known to a tenth of
        // itself.
        double found = 0, expected = 0;
        for (int i = 0; i < 200; ++i) {
            Synthetic shortOne = squeeze(std::uint64_t(1000 + i));
            shortOne.samples = 150;
            const Validation validation = against(shortOne.make(), squeeze(std::uint64_t(5000 + i)).make());
            QVERIFY(validation.expectedPercent);
            found += std::pow(100 - *validation.fit.simulationPercent, 2);
            expected += std::pow(100 - *validation.expectedPercent, 2);
        }
        QVERIFY2(std::abs(found / expected - 1) < 0.05, QByteArray::number(found / expected));
    }
    void anotherStiffnessIsFoundOut()
    {
        Synthetic stiffer = squeeze(8);
        stiffer.truth.k *= 1.1;
        const Validation found = against(squeeze(7).make(), stiffer.make());
        QVERIFY(found.asExpected.has_value() && !*found.asExpected);
        QVERIFY(*found.misfitP < 1e-4);
        // Within three of its standard errors, and a hundredth for the linearisation.
        QVERIFY(found.change);
        QVERIFY(std::abs((*found.change)(2) - 0.1) < 3 * (*found.changeErrors)(2) + 0.01);
        QVERIFY(*found.fit.simulationPercent < *found.expectedPercent);
        QVERIFY(found.message.describe().contains(u"k by +"_s));
    }
    void quiteAnotherObjectIsFoundOut()
    {
        Synthetic other = squeeze(8);
        other.truth = {0.2, 0.5, 0.4};
        const Validation found = against(squeeze(7).make(), other.make());
        QVERIFY(found.asExpected.has_value() && !*found.asExpected);
    }
    void aCubicSpringHoldsAtAnotherAmplitudeAndALinearOneDoesNot()
    {
        const double k3 = 0.02 * 0.1022911; // as much as the linear spring at a motion of seven
        const Recording first = cubicSqueeze(k3, 0.5, 3);
        IdentificationOptions options = outputErrorOnly();
        options.estimators = {Estimator::Duffing, Estimator::OutputError};
        const Identification found = identify(first, options);
        const Recording second = cubicSqueeze(k3, 1, 4);
        const Validation cubic = validateOnRecording(*found.find(Estimator::Duffing), first, second, {}, {});
        QVERIFY2(cubic.asExpected.value_or(false), qPrintable(cubic.message.describe()));
        QVERIFY(cubic.k3.has_value());
        const Validation linear =
            validateOnRecording(*found.find(Estimator::OutputError), first, second, {}, {});
        QVERIFY2(linear.asExpected.has_value() && !*linear.asExpected, qPrintable(linear.message.describe()));
        QVERIFY(*linear.fit.simulationPercent < *cubic.fit.simulationPercent);
    }
    void aMissingTermThatRepeatsIsNamedAsColour()
    {
        const double k3 = 0.02 * 0.1022911;
        const Recording first = cubicSqueeze(k3, 1, 3);
        const Identification found = identify(first, outputErrorOnly());
        const Validation linear = validateOnRecording(*found.best(), first, cubicSqueeze(k3, 1, 4), {}, {});
        QVERIFY(*linear.whitenessP < 1e-4);
        QVERIFY2(linear.message.describe().contains(u"not white"_s), qPrintable(linear.message.describe()));
    }
    void anArxEstimateThatPredictsWellIsFoundOut()
    {
        // Noise biases the paper's mapping although its one-step fit stays above 80 %.
        Synthetic first = squeeze(5), second = squeeze(6);
        first.samples = second.samples = 1000;
        const Recording recording = first.make();
        const Identification found = identify(recording);
        const Estimate& arx = *found.find(Estimator::Arx);
        QVERIFY(arx.parameters && *arx.fit.predictionPercent > 75);
        const Validation validation = validateOnRecording(arx, recording, second.make(), {}, {});
        QVERIFY(!validation.asExpected.value_or(false));
        QVERIFY(*validation.fit.simulationPercent < 75);
    }
    void aSecondWindowIsTheDefault()
    {
        const Identification found = identify(squeeze(9).make());
        QVERIFY(found.validation.available());
        QVERIFY2(found.validation.asExpected.value_or(false),
                 qPrintable(found.validation.message.describe()));
        QCOMPARE(found.validation.estimatedOn, (Window{0, 240}));
        QCOMPARE(found.validation.validatedOn, (Window{240, 160}));
        QCOMPARE(found.validation.time_s.front(), found.time_s[240]);
        QCOMPARE(found.validation.time_s.size(), found.validation.simulated.size());
    }
    void aRecordTooShortForTwoWindowsSaysSo()
    {
        Synthetic shortOne = squeeze(1);
        shortOne.samples = 60;
        const Identification found = identify(shortOne.make());
        QVERIFY(!found.validation.available());
        QVERIFY(found.validation.message.describe().contains(u"too few"_s));
    }
    void unitsAreBroughtTogetherOrRefused()
    {
        Recording first = squeeze(1).make(), second = squeeze(2).make();
        first.forceUnit = second.forceUnit = u"N"_s;
        first.positionUnit = u"mm"_s;
        second.positionUnit = u"um"_s;
        for (double& y : second.position)
            y *= 1000;
        QVERIFY(against(first, second).asExpected.value_or(false));
        second.positionUnit = u"1"_s;
        const Validation refused = against(first, second);
        QVERIFY(!refused.available() && !refused.asExpected);
        QVERIFY(refused.message.describe().contains(u"cannot be compared"_s));
    }
    void lostSamplesAreLeftOut()
    {
        Recording second = squeeze(2).make();
        second.time_s.erase(second.time_s.begin() + 100);
        second.force.erase(second.force.begin() + 100);
        second.position.erase(second.position.begin() + 100);
        const Validation found = against(squeeze(1).make(), second);
        QCOMPARE(found.validatedOn, (Window{101, 299}));
        QVERIFY(found.asExpected.value_or(false));
    }
    void colouredNoiseIsNoMisfit()
    {
        // An autoregression of 0.8: without a noise model the misfit would be called too large in half the
        // pairs. 60 pairs at 0.5 %: more than four alarms have a probability below 1e-4, and the noise
        // model, fitted to 400 samples, may double the rate.
        int alarms = 0;
        for (int i = 0; i < 60; ++i) {
            std::array<Recording, 2> pair;
            for (std::size_t j = 0; j < 2; ++j) {
                pair[j] = squeeze(std::uint64_t(100 + 2 * std::size_t(i) + j), 100).make();
                GaussianNoise noise(std::uint64_t(900 + 2 * std::size_t(i) + j));
                double e = 0;
                for (double& y : pair[j].position)
                    y += e = 0.8 * e + 0.3 * noise();
            }
            const Validation found = against(pair[0], pair[1]);
            QVERIFY(found.misfitP);
            QVERIFY(*found.fit.predictionPercent > *found.fit.simulationPercent);
            alarms += *found.misfitP < validationLimit;
        }
        QVERIFY2(alarms <= 4, QByteArray::number(alarms));
    }
    void aPeriodicEstimateIsShownButNotJudged()
    {
        const Recording recording = test::ControlledGripper().make();
        IdentificationOptions options;
        options.estimators = {Estimator::Periodic};
        const Identification found = identify(recording, options);
        QVERIFY(found.repetition && found.repetition->periods >= 6); // of 8; the servo settles in the first
        QVERIFY(found.best());
        const Validation validation =
            validateOnRecording(*found.best(), recording, recording, {}, options.hold);
        QVERIFY(validation.available() && !validation.asExpected);
        QVERIFY(validation.message.describe().contains(u"not judged"_s));
    }
    void nothingBreaksOnOddRecords()
    {
        const Recording first = squeeze(1).make();
        const Identification found = identify(first, outputErrorOnly());
        std::vector<Recording> odd(6, squeeze(2).make());
        odd[0] = Recording();
        std::fill(odd[1].position.begin(), odd[1].position.end(), 3.0);
        std::fill(odd[2].force.begin(), odd[2].force.end(), 1.0);
        for (double& y : odd[3].position)
            y *= 1e300;
        for (double& f : odd[4].force)
            f *= 1e-300;
        odd[5].force[7] = std::numeric_limits<double>::quiet_NaN();
        for (const Recording& one : odd) {
            const Validation validation = validateOnRecording(*found.best(), first, one, {}, {});
            QVERIFY(!validation.message.isEmpty());
            QVERIFY(finite(validation));
        }
    }
    void theJsonHasNamesForAllOfIt()
    {
        const QJsonObject object = toJson(against(squeeze(1).make(), squeeze(2).make()));
        QCOMPARE(object[u"on"].toString(), u"other_recording"_s);
        QCOMPARE(object[u"file"].toString(), u"other.csv"_s);
        QVERIFY(object[u"as_expected"].toBool());
        QVERIFY(object[u"fit"][u"expected_percent"].isDouble());
        QVERIFY(object[u"residuals"][u"input_independence_p"].isDouble());
        QVERIFY(object[u"misfit"][u"change"][u"k"].isDouble());
        QCOMPARE(object[u"validated_on"][u"samples"].toInt(), 400);
        const QJsonObject none = toJson(Validation());
        QVERIFY(none[u"as_expected"].isNull() && none[u"parameters"].isNull());
    }
};

GRIPSCOPE_TEST(ValidationTest)
#include "validation_test.moc"
