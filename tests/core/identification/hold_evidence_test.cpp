// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/comparison/hold_evidence.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

#include <array>

using namespace gripscope;
using test::Synthetic;

namespace {

ForceHold otherThan(ForceHold hold)
{
    return hold == ForceHold::Zero ? ForceHold::First : ForceHold::Zero;
}

HoldEvidence weigh(const Recording& recording, ForceHold declared, double lagUncertainty_s = 0)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = declared;
    options.lag_s = recording.forceLag_s;
    const Estimate oe = estimateOutputError(recording.force, recording.position, options);
    const Estimate other = estimateOtherHold(recording.force, recording.position, options, oe);
    return weighHolds(recording.force, options, oe, other, lagUncertainty_s);
}

/// wn T = 0.1 at 0.05 s: the holds differ in about the noise of a 92 to 96 % fit (science of 400 samples).
Synthetic object(double fitPercent, ForceHold hold, std::uint64_t seed)
{
    Synthetic synthetic;
    synthetic.truth = {0.04, 2 * 0.5 * 2 * 0.04, 4 * 0.04};
    synthetic.hold = hold;
    synthetic.fitPercent = fitPercent;
    synthetic.seed = seed;
    return synthetic;
}

constexpr int evidenceRuns = 40;

} // namespace

class HoldEvidenceTest : public QObject {
    Q_OBJECT
private slots:
    void aWrongHoldIsFoundWhereItCanBeToldARightOneIsLeftAlone_data()
    {
        QTest::addColumn<double>("fit");
        QTest::addColumn<bool>("held");
        for (const double fit : {88.0, 97.0}) {
            QTest::addRow("%g %%, held", fit) << fit << true;
            QTest::addRow("%g %%, straight", fit) << fit << false;
        }
    }
    void aWrongHoldIsFoundWhereItCanBeToldARightOneIsLeftAlone()
    {
        QFETCH(double, fit);
        QFETCH(bool, held);
        const ForceHold truth = held ? ForceHold::Zero : ForceHold::First;
        int tellable = 0;
        int found = 0;
        int accused = 0;
        for (int run = 0; run < evidenceRuns; ++run) {
            const Recording recording = object(fit, truth, std::uint64_t(run) + 1).make();
            const HoldEvidence right = weigh(recording, truth);
            const HoldEvidence wrong = weigh(recording, otherThan(truth));
            QVERIFY(right.gain && wrong.gain);
            accused += right.verdict() == HoldVerdict::Contradicts ? 1 : 0;
            if (wrong.expectedGain > 10) {
                ++tellable;
                found += wrong.verdict() == HoldVerdict::Contradicts ? 1 : 0;
            }
        }
        // Asked for: at most 2 % false alarms, at least 95 % found; the binomial law's 99.9 % points.
        const boost::math::binomial alarms(evidenceRuns, 0.02);
        QVERIFY2(accused <= boost::math::quantile(boost::math::complement(alarms, 1e-3)),
                 qPrintable(QString::number(accused)));
        if (fit > 95)
            QVERIFY2(tellable > evidenceRuns * 0.9, qPrintable(QString::number(tellable)));
        if (tellable > 0) {
            const boost::math::binomial power(tellable, 0.95);
            QVERIFY2(found >= boost::math::quantile(power, 1e-3),
                     qPrintable(QStringLiteral("%1 of %2").arg(found).arg(tellable)));
        }
    }
    void theGainIsAsExpected()
    {
        // Mean -E for the right hold, scatter sqrt(2 E): with E about 20, the mean of 120 gains is known to
        // 0.6.
        double gain = 0;
        double expected = 0;
        for (int run = 0; run < evidenceRuns; ++run) {
            const HoldEvidence e =
                weigh(object(94, ForceHold::Zero, std::uint64_t(run) + 1).make(), ForceHold::Zero);
            gain += *e.gain / evidenceRuns;
            expected += e.expectedGain / evidenceRuns;
        }
        QVERIFY2(std::abs(gain + expected) < 4 * std::sqrt(2 * expected / evidenceRuns),
                 qPrintable(QStringLiteral("%1 for -%2").arg(gain).arg(expected)));
    }
    void aLagKnownToHalfASampleTellsNothing()
    {
        const Recording recording = object(97, ForceHold::Zero, 1).make();
        const HoldEvidence known = weigh(recording, ForceHold::Zero);
        const HoldEvidence vague = weigh(recording, ForceHold::Zero, 0.025);
        QVERIFY(known.verdict() == HoldVerdict::Agrees);
        QVERIFY2(vague.expectedGain < 0.1 * known.expectedGain,
                 qPrintable(QString::number(vague.expectedGain)));
        QVERIFY(weigh(recording, ForceHold::First, 0.025).verdict() == HoldVerdict::Ambiguous);
        QVERIFY(vague.otherParameters);
    }
    void squeezesAddUpUntilItIsSettled()
    {
        std::vector<HoldEvidence> right;
        std::vector<HoldEvidence> wrong;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Recording recording = object(85, ForceHold::Zero, seed).make();
            right.push_back(weigh(recording, ForceHold::Zero));
            wrong.push_back(weigh(recording, ForceHold::First));
        }
        QVERIFY(wrong.front().verdict() == HoldVerdict::Ambiguous);
        const HoldEvidence all = combine(wrong);
        QCOMPARE(all.squeezes, 40);
        QVERIFY(all.verdict() == HoldVerdict::Contradicts);
        QVERIFY(all.otherProbability() > 0.99);
        QVERIFY(combine(right).verdict() == HoldVerdict::Agrees);
        QVERIFY(combine({}).verdict() == HoldVerdict::NotJudged);
        QCOMPARE(combine({}).otherProbability(), 0.5);
    }
    void whatWasDeclaredOtherwiseDoesNotCount()
    {
        const Recording recording = object(90, ForceHold::Zero, 1).make();
        const HoldEvidence last = weigh(recording, ForceHold::Zero);
        HoldEvidence otherLag = last;
        otherLag.lag_s = 1e-4;
        HoldEvidence otherUncertainty = last;
        otherUncertainty.lagUncertainty_s = 1e-4;
        const HoldEvidence all = combine(
            std::array{weigh(recording, ForceHold::First), otherLag, otherUncertainty, HoldEvidence(), last});
        QCOMPARE(all.squeezes, 1);
        QCOMPARE(*all.gain, *last.gain);
        QVERIFY(all.otherParameters);
        // A last squeeze that says nothing leaves what the earlier ones said.
        HoldEvidence silent;
        silent.declared = ForceHold::Zero;
        const HoldEvidence kept = combine(std::array{last, silent});
        QCOMPARE(*kept.gain, *last.gain);
        QVERIFY(!kept.otherParameters);
    }
    void aLagThatAllSqueezesShareBoundsWhatTheyCanTell()
    {
        // The other hold is half a sample of lag, T/2. Known to u, however many squeezes there are, that is
        // worth (T / 2u)^2 / 2 = 3.1 for u = T/5; a hundredth more comes from where the holds differ
        // otherwise.
        std::vector<HoldEvidence> squeezes;
        for (std::uint64_t seed = 1; seed <= 30; ++seed)
            squeezes.push_back(weigh(object(90, ForceHold::Zero, seed).make(), ForceHold::Zero, 0.01));
        const HoldEvidence all = combine(squeezes);
        QCOMPARE(all.squeezes, 30);
        QVERIFY2(all.expectedGain < 3.5, qPrintable(QString::number(all.expectedGain)));
        QVERIFY(all.expectedGain > squeezes.front().expectedGain);
        QVERIFY(all.verdict() == HoldVerdict::Ambiguous);
    }
    void aRightHoldIsSeldomAccusedHoweverOftenTheSumIsLookedAt()
    {
        // At most 1.2 % of sessions by the law of the random walk; sums of ten squeezes each, looked at after
        // every one.
        constexpr int sessions = 60;
        int accused = 0;
        for (int session = 0; session < sessions; ++session) {
            HoldEvidence sum;
            bool ever = false;
            for (int squeeze = 0; squeeze < 10; ++squeeze) {
                const auto seed = std::uint64_t(100 * session + squeeze) + 1;
                const Recording recording = object(88, ForceHold::Zero, seed).make();
                sum = combine(std::array{sum, weigh(recording, ForceHold::Zero)});
                ever = ever || sum.verdict() == HoldVerdict::Contradicts;
            }
            accused += ever ? 1 : 0;
            QVERIFY(sum.verdict() == HoldVerdict::Agrees);
        }
        const boost::math::binomial alarms(sessions, 0.012);
        QVERIFY2(accused <= boost::math::quantile(boost::math::complement(alarms, 1e-3)),
                 qPrintable(QString::number(accused)));
    }
    void eitherDeclarationSaysTheSame()
    {
        for (const double lagUncertainty_s : {0.0, 0.01}) {
            const Recording recording = object(92, ForceHold::Zero, 5).make();
            const HoldEvidence zero = weigh(recording, ForceHold::Zero, lagUncertainty_s);
            const HoldEvidence first = weigh(recording, ForceHold::First, lagUncertainty_s);
            // Both searches end within about 1e-6 of their minimum.
            QVERIFY(std::abs(*zero.gain + *first.gain) < 1e-3 * zero.expectedGain);
            QVERIFY(std::abs(zero.expectedGain - first.expectedGain) < 1e-3 * zero.expectedGain);
        }
    }
    void scaleDoesNotMatter()
    {
        const Recording recording = object(94, ForceHold::Zero, 3).make();
        const HoldEvidence plain = weigh(recording, ForceHold::First);
        for (const double scale : {1e-6, 1e6}) {
            Recording scaled = recording;
            for (double& u : scaled.force)
                u *= scale;
            for (double& y : scaled.position)
                y /= scale;
            QVERIFY(std::abs(*weigh(scaled, ForceHold::First).gain / *plain.gain - 1) < 1e-4);
        }
    }
    void nothingIsJudgedWithoutAnEstimate()
    {
        OutputErrorOptions options;
        options.sampleTime_s = 0.05;
        QVERIFY(weighHolds({}, options, Estimate(), Estimate(), 0).verdict() == HoldVerdict::NotJudged);
        const std::vector<double> constant(50, 1.0);
        const Estimate none = estimateOutputError(constant, constant, options);
        QVERIFY(!weighHolds(constant, options, none, estimateOtherHold(constant, constant, options, none), 0)
                     .gain);
        const Recording good = object(94, ForceHold::First, 1).make();
        options.sampleTime_s = good.sampleTime_s;
        const Estimate oe = estimateOutputError(good.force, good.position, options);
        QVERIFY(!weighHolds(good.force, options, oe, Estimate(), 0).gain);
    }
    void noNoiseGivesFiniteNumbers()
    {
        const HoldEvidence e = weigh(object(100, ForceHold::Zero, 1).make(), ForceHold::Zero);
        QVERIFY(e.gain && std::isfinite(*e.gain) && std::isfinite(e.expectedGain));
        QVERIFY(e.verdict() == HoldVerdict::Agrees);
    }
};

GRIPSCOPE_TEST(HoldEvidenceTest)
#include "hold_evidence_test.moc"
