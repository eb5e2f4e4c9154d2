// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

const ValidityCheck& check(const Identification& identification, const QString& id)
{
    for (const ValidityCheck& c : identification.validity.checks) {
        if (c.id == id)
            return c;
    }
    qFatal("no check is called %s", qPrintable(id));
}

Identification identifyByOutputError(const Recording& recording)
{
    IdentificationOptions options;
    options.estimators = {Estimator::OutputError};
    options.assess = false; // the checks need no budget
    return identify(recording, options);
}

/// A virtual can in SI: 2 kHz, 1 s, bits of 5 ms.
Synthetic siCan()
{
    Synthetic synthetic;
    synthetic.truth = {0.0396, 43, 9990};
    synthetic.sampleTime_s = 0.0005;
    synthetic.bit_s = 0.005;
    synthetic.samples = 2000;
    synthetic.peak = 10;
    synthetic.bias = 20;
    return synthetic;
}

void drop(Recording& recording, std::size_t first, std::size_t count)
{
    const auto cut = [&](auto& values) {
        if (!values.empty())
            values.erase(values.begin() + std::ptrdiff_t(first),
                         values.begin() + std::ptrdiff_t(first + count));
    };
    cut(recording.time_s);
    cut(recording.force);
    cut(recording.position);
    cut(recording.status);
}

} // namespace

class ValidityTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsNotJudgedIsNotedAndNothingMore()
    {
        int notJudged = 0;
        for (const ValidityCheck& check : identify(siCan().make()).validity.checks) {
            const bool says = check.message.describe().startsWith(u"not judged"_s);
            notJudged += says ? 1 : 0;
            QVERIFY2(!says || (check.ok && check.noted), qPrintable(check.id));
            QVERIFY2(check.ok || !check.noted, qPrintable(check.id));
        }
        QVERIFY(notJudged >= 2); // of a recording without a gripper: its clock, its calibration
    }
    void everyCheckOfTheContractIsThereOnceInOrder()
    {
        const QStringList ids{u"samples_lost"_s,
                              u"saturation"_s,
                              u"stuck"_s,
                              u"device_fault"_s,
                              u"clock"_s,
                              u"sample_time"_s,
                              u"excitation"_s,
                              u"residual_whiteness"_s,
                              u"input_independence"_s,
                              u"hold"_s,
                              u"convergence"_s,
                              u"physical_range"_s,
                              u"fit"_s,
                              u"calibration"_s,
                              u"linearity"_s,
                              u"feedback"_s,
                              u"relaxation"_s,
                              u"preparation"_s};
        for (const bool good : {true, false}) {
            QStringList got;
            for (const ValidityCheck& c : identify(good ? siCan().make() : Recording()).validity.checks) {
                got << c.id;
                QVERIFY(!c.message.isEmpty());
            }
            QCOMPARE(got, ids);
        }
    }
    void goodMeasurementsAreCalledValid()
    {
        // The residual checks share a false-alarm rate of 1 %; of 300 good squeezes with white noise at most
        // as many may be suspect as that rate gives once in 10,000.
        int suspect = 0;
        constexpr int runs = 300;
        for (int run = 0; run < runs; ++run) {
            Synthetic synthetic = siCan();
            synthetic.seed = std::uint64_t(run) + 1;
            synthetic.fitPercent = run % 2 == 0 ? 85 : 95;
            const Identification found = identifyByOutputError(synthetic.make());
            QVERIFY(found.validity.verdict != ValidityVerdict::Invalid);
            suspect += found.validity.verdict == ValidityVerdict::Suspect ? 1 : 0;
        }
        const boost::math::binomial distribution(runs, 0.01);
        QVERIFY2(suspect <= boost::math::quantile(boost::math::complement(distribution, 1e-4)),
                 qPrintable(QString::number(suspect)));
    }
    void positionStepsAreNoReasonForSuspicion_data()
    {
        QTest::addColumn<double>("noise");
        QTest::newRow("no noise besides") << 0.0;
        QTest::newRow("5 um of noise") << 5e-6;
        QTest::newRow("20 um of noise") << 20e-6;
    }
    void positionStepsAreNoReasonForSuspicion()
    {
        QFETCH(double, noise);
        int suspect = 0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Synthetic synthetic = siCan();
            synthetic.seed = seed;
            Recording recording = synthetic.make();
            GaussianNoise random(seed);
            for (double& y : recording.position)
                y = 20e-6 * std::round((y + noise * random()) / 20e-6);
            const Identification found = identifyByOutputError(recording);
            suspect += found.validity.verdict != ValidityVerdict::Valid ? 1 : 0;
        }
        QVERIFY2(suspect <= 5, qPrintable(QString::number(suspect))); // 1 % of 50, once in 10,000
    }
    void lostSamplesMakeAMeasurementSuspectThenInvalid_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("none") << 0 << 0 << u"valid"_s;
        QTest::newRow("one near the end") << 1900 << 1 << u"suspect"_s;
        QTest::newRow("one in the middle") << 1000 << 1 << u"suspect"_s;
        QTest::newRow("a tenth") << 1000 << 200 << u"suspect"_s;
        QTest::newRow("a third") << 1000 << 700 << u"invalid"_s;
    }
    void lostSamplesMakeAMeasurementSuspectThenInvalid()
    {
        QFETCH(int, first);
        QFETCH(int, count);
        QFETCH(QString, verdict);
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        drop(recording, std::size_t(first), std::size_t(count));
        const Identification found = identifyByOutputError(recording);
        QCOMPARE(toString(found.validity.verdict), verdict);
        QCOMPARE(check(found, u"samples_lost"_s).value.value_or(-1), double(count));
        QCOMPARE(check(found, u"samples_lost"_s).ok, count == 0);
    }
    void whatBefellTheStreamIsSeen_data()
    {
        QTest::addColumn<QString>("stream");
        QTest::addColumn<QString>("verdict");
        QTest::addColumn<QString>("word");
        QTest::newRow("nothing") << u"gaps=0"_s << u"valid"_s << u"no sample"_s;
        QTest::newRow("duplicates and damaged reports")
            << u"duplicate_reports=9 bad_reports=3"_s << u"valid"_s << u"no sample"_s;
        QTest::newRow("a stall") << u"stalls=1 longest_stall_s=0.12"_s << u"valid"_s << u"silent"_s;
        QTest::newRow("a clock set back") << u"clock_steps=1"_s << u"suspect"_s << u"clock jumped"_s;
    }
    void whatBefellTheStreamIsSeen()
    {
        QFETCH(QString, stream);
        QFETCH(QString, verdict);
        QFETCH(QString, word);
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        recording.provenance[u"stream"_s] = stream;
        const Identification found = identifyByOutputError(recording);
        QCOMPARE(toString(found.validity.verdict), verdict);
        QVERIFY2(check(found, u"samples_lost"_s).message.describe().contains(word),
                 qPrintable(check(found, u"samples_lost"_s).message.describe()));
        QCOMPARE(check(found, u"samples_lost"_s).ok, verdict == u"valid"_s);
    }
    void aStepOfTheClockMakesAMeasurementSuspectThenInvalid_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("near the end") << 1900 << u"suspect"_s;
        QTest::newRow("in the middle") << 1000 << u"invalid"_s;
    }
    void aStepOfTheClockMakesAMeasurementSuspectThenInvalid()
    {
        QFETCH(int, at);
        QFETCH(QString, verdict);
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        for (std::size_t i = 0; i < recording.size(); ++i) {
            recording.sequence.push_back(i);
            recording.time_s[i] += i >= std::size_t(at) ? 0.1 : 0;
        }
        const Identification found = identifyByOutputError(recording);
        QCOMPARE(toString(found.validity.verdict), verdict);
        QVERIFY(check(found, u"samples_lost"_s).message.describe().contains(u"clock jumped"_s));
        QVERIFY(!check(found, u"samples_lost"_s).message.describe().contains(u"missing"_s));
    }
    void anEstimateOfAPartSaysSo()
    {
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 100;
        Recording recording = synthetic.make();
        drop(recording, 1200, 1);
        IdentificationOptions options;
        options.estimators = {Estimator::Arx221};
        options.assess = false;
        const Identification found = identify(recording, options);
        QVERIFY(found.best());
        QCOMPARE(found.best()->part, (Window{0, 1200}));
        QVERIFY2(check(found, u"samples_lost"_s).message.describe().contains(u"1200 of 2000"_s),
                 qPrintable(check(found, u"samples_lost"_s).message.describe()));
        QVERIFY(!check(identifyByOutputError(recording), u"samples_lost"_s)
                     .message.describe()
                     .contains(u"longest"_s));
    }
    void saturationMakesAMeasurementSuspectThenInvalid()
    {
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        recording.status.assign(recording.size(), StatusArmed | StatusMoving);
        QVERIFY(check(identifyByOutputError(recording), u"saturation"_s).ok);
        recording.status[100] |= StatusForceSaturated;
        QCOMPARE(toString(identifyByOutputError(recording).validity.verdict), u"suspect"_s);
        for (std::size_t i = 0; i < 100; ++i)
            recording.status[i] |= StatusPositionSaturated;
        QCOMPARE(toString(identifyByOutputError(recording).validity.verdict), u"invalid"_s);
    }
    void aLoneStepFailsTheExcitationCheckWithWords()
    {
        Synthetic synthetic = siCan();
        synthetic.kind = ExcitationKind::Step;
        const Identification found = identify(synthetic.make());
        const ValidityCheck& excitation = check(found, u"excitation"_s);
        QVERIFY(!excitation.ok && excitation.decisive);
        QVERIFY(excitation.message.describe().contains(u"constant force"_s));
        QCOMPARE(toString(found.validity.verdict), u"invalid"_s);
    }
    void aMassThatIsHardlyKnownIsSuspect()
    {
        // A mass so small that it moves along within a sixth of a sample.
        Synthetic synthetic = siCan();
        synthetic.truth.m = 0.004;
        synthetic.fitPercent = 60;
        const Identification found = identifyByOutputError(synthetic.make());
        const ValidityCheck& excitation = check(found, u"excitation"_s);
        QVERIFY(!excitation.ok);
        QVERIFY2(excitation.message.describe().contains(u"mass"_s),
                 qPrintable(excitation.message.describe()));
    }
    void noiseThatIsNotWhiteIsCountedInTheErrorsAndSaid()
    {
        Synthetic synthetic = siCan();
        Recording recording = synthetic.make();
        GaussianNoise noise(3);
        double drift = 0;
        for (double& y : recording.position) {
            drift = 0.95 * drift + 2e-5 * noise();
            y += drift;
        }
        const Identification found = identifyByOutputError(recording);
        QVERIFY(found.best()->noise);
        QVERIFY(*found.best()->residuals.errorInflation > 2);
        QVERIFY(check(found, u"residual_whiteness"_s).ok);
        QVERIFY(check(found, u"residual_whiteness"_s).message.describe().contains(u"noise model"_s));
        QCOMPARE(toString(found.validity.verdict), u"valid"_s);
    }
    void aMissingCubicSpringShowsInTheResiduals()
    {
        // The position of a spring that stiffens by half at its largest travel, roughly: x less a share of
        // x^3.
        Synthetic synthetic = siCan();
        synthetic.bias = 0;
        Recording recording = synthetic.make();
        for (double& y : recording.position)
            y -= 0.3 * y * y * y / 1e-6;
        const Identification found = identifyByOutputError(recording);
        QVERIFY(!check(found, u"linearity"_s).ok);
        QVERIFY(check(found, u"linearity"_s).message.describe().contains(u"duffing"_s));
        QCOMPARE(toString(found.validity.verdict), u"suspect"_s);
    }
    void aWrongHoldIsNamedWhereItCanBeTold()
    {
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 95;
        Recording recording = synthetic.make();
        QVERIFY(check(identifyByOutputError(recording), u"hold"_s).ok);
        recording.hold = ForceHold::First;
        const Identification wrong = identifyByOutputError(recording);
        QVERIFY(!check(wrong, u"hold"_s).ok);
        QVERIFY(check(wrong, u"hold"_s).message.describe().contains(u"zoh"_s));
    }
    void aGoodSqueezeIsRarelyAccused_data()
    {
        QTest::addColumn<double>("fit");
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("forceNoise");
        QTest::newRow("95 %, 400") << 95.0 << 400 << 0.0;
        QTest::newRow("90 %, 200") << 90.0 << 200 << 0.0;
        QTest::newRow("95 %, force noise") << 95.0 << 400 << 0.1;
    }
    void aGoodSqueezeIsRarelyAccused()
    {
        QFETCH(double, fit);
        QFETCH(int, samples);
        QFETCH(double, forceNoise);
        constexpr int runs = 100;
        int accused = 0;
        for (int run = 0; run < runs; ++run) {
            Synthetic synthetic;
            synthetic.samples = std::size_t(samples);
            synthetic.fitPercent = fit;
            synthetic.seed = std::uint64_t(run) + 5000;
            Recording recording = synthetic.make();
            GaussianNoise noise(synthetic.seed);
            for (double& u : recording.force)
                u += forceNoise * noise();
            accused += identifyByOutputError(recording).validity.verdict == ValidityVerdict::Valid ? 0 : 1;
        }
        // At most 2 % in all; beyond the 99.9 % point of that binomial law it is more.
        const boost::math::binomial most(runs, 0.02);
        QVERIFY2(accused <= boost::math::quantile(boost::math::complement(most, 1e-3)),
                 qPrintable(QString::number(accused)));
    }
    void forceThatAnswersToThePositionIsFound()
    {
        // A drifting disturbance of the position, which the force follows a sample later.
        int found = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Synthetic synthetic = siCan();
            synthetic.seed = seed;
            Recording recording = synthetic.make();
            GaussianNoise noise(seed);
            std::vector<double> disturbance(recording.size(), 0.0);
            for (std::size_t t = 1; t < recording.size(); ++t) {
                disturbance[t] = 0.9 * disturbance[t - 1] + 2e-5 * noise();
                recording.force[t] -= 40000 * disturbance[t - 1];
            }
            recording.position =
                simulate(synthetic.truth, recording.force, {0.0005, synthetic.hold, 0, 0, 0, 0});
            for (std::size_t t = 0; t < recording.size(); ++t)
                recording.position[t] += disturbance[t];
            found += check(identifyByOutputError(recording), u"feedback"_s).ok ? 0 : 1;
        }
        QVERIFY2(found >= 19, qPrintable(QString::number(found)));
    }
    void contactLossIsNoGoodSqueeze()
    {
        // The fingers cannot pull: whatever of the position is below the unloaded object's is air.
        Synthetic synthetic = siCan();
        synthetic.bias = 4;
        synthetic.fitPercent = 99;
        Recording recording = synthetic.make();
        for (double& y : recording.position)
            y = std::max(y, 0.0);
        QVERIFY(identifyByOutputError(recording).validity.verdict != ValidityVerdict::Valid);
    }
    void aPoorFitIsSuspect()
    {
        Synthetic synthetic = siCan();
        synthetic.fitPercent = 20;
        const Identification found = identifyByOutputError(synthetic.make());
        QVERIFY(!check(found, u"fit"_s).ok);
        QVERIFY(found.validity.verdict != ValidityVerdict::Valid);
    }
    void noEstimateIsInvalid_data()
    {
        QTest::addColumn<int>("samples");
        for (const int samples : {0, 1, 3, 6})
            QTest::addRow("%d samples", samples) << samples;
    }
    void noEstimateIsInvalid()
    {
        QFETCH(int, samples);
        Synthetic synthetic = siCan();
        Recording recording = synthetic.make();
        drop(recording, std::size_t(samples), recording.size() - std::size_t(samples));
        const Identification found = identify(recording);
        QVERIFY(found.best() == nullptr);
        QCOMPARE(toString(found.validity.verdict), u"invalid"_s);
        QVERIFY(!check(found, u"convergence"_s).ok);
    }
    void theVerdictIsTheWorstCheck()
    {
        ValidityCheck good;
        ValidityCheck bad;
        bad.ok = false;
        ValidityCheck decisive = bad;
        decisive.decisive = true;
        QVERIFY(overallVerdict({good, good}) == ValidityVerdict::Valid);
        QVERIFY(overallVerdict({good, bad}) == ValidityVerdict::Suspect);
        QVERIFY(overallVerdict({bad, decisive}) == ValidityVerdict::Invalid);
        QVERIFY(overallVerdict({}) == ValidityVerdict::Valid);
        decisive.ok = true;
        QVERIFY(overallVerdict({bad, decisive}) == ValidityVerdict::Suspect);
    }
};

GRIPSCOPE_TEST(ValidityTest)
#include "validity_test.moc"
