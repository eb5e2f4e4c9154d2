// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using P = MotionParameter;

namespace {

/// Of the size of can A, swinging at 80 Hz; a bit takes a sample at least.
constexpr MassDampingStiffness ofACan{0.0396, 43, 9990};

Synthetic squeezeAt(double rate_Hz, std::uint64_t seed, const MassDampingStiffness& truth = ofACan)
{
    Synthetic synthetic;
    synthetic.truth = truth;
    synthetic.sampleTime_s = 1 / rate_Hz;
    synthetic.bit_s = std::max(0.005, synthetic.sampleTime_s);
    synthetic.samples = static_cast<std::size_t>(2 * rate_Hz);
    synthetic.bias = 20;
    synthetic.peak = 10;
    synthetic.x0 = 20 / truth.k;
    synthetic.fitPercent = 99.2;
    synthetic.seed = seed;
    synthetic.kind = ExcitationKind::FourLevel;
    return synthetic;
}

const FurtherParameter* furtherOf(const Identification& found, P parameter)
{
    const auto& all = found.budget.further;
    const auto at = std::ranges::find(all, parameter, &FurtherParameter::parameter);
    return at != all.end() ? &*at : nullptr;
}

bool holds(const CoverageInterval& interval, double value)
{
    return value >= interval.lower && value <= interval.upper;
}

bool checkFailed(const Identification& found, const QString& id)
{
    const auto& checks = found.validity.checks;
    const auto at = std::ranges::find(checks, id, &ValidityCheck::id);
    return at == checks.end() || !at->ok;
}

} // namespace

/// Where the samples are too far apart to tell a mass none is made up, and k is told as well as it is known.
class SlowGripperTest : public QObject {
    Q_OBJECT
private slots:
    void noMassIsMadeUp_data()
    {
        QTest::addColumn<double>("rate");
        QTest::newRow("20 Hz") << 20.0;
        QTest::newRow("50 Hz") << 50.0;
    }
    /// Of 40 intervals with 95 % each fewer than 33 hold the truth once in 25,000 such tests.
    void noMassIsMadeUp()
    {
        QFETCH(double, rate);
        constexpr std::uint64_t runs = 40;
        int valid = 0, covered = 0, dampingCovered = 0, withDamping = 0;
        for (std::uint64_t seed = 1; seed <= runs; ++seed) {
            const Identification found = identify(squeezeAt(rate, seed).make());
            QCOMPARE(toString(found.recommended), toString(Estimator::Static));
            QVERIFY(found.best() == nullptr && !found.budget.parameters);
            QVERIFY(!found.comparison.sentence.isEmpty());
            valid += found.validity.verdict == ValidityVerdict::Valid ? 1 : 0;
            const FurtherParameter* const k = furtherOf(found, P::Stiffness);
            QVERIFY(k != nullptr && k->combined.standardUncertainty < 0.01 * k->value);
            covered += holds(k->interval, ofACan.k) ? 1 : 0;
            if (const FurtherParameter* const b = furtherOf(found, P::Damping)) {
                ++withDamping;
                dampingCovered += holds(b->interval, ofACan.b) ? 1 : 0;
            }
        }
        QVERIFY2(covered >= 33, qPrintable(QString::number(covered)));
        QVERIFY2(dampingCovered >= 0.8 * withDamping,
                 qPrintable(u"%1 of %2"_s.arg(dampingCovered).arg(withDamping)));
        // The checks share a rate of 2 %: 36 and more of 40 but once in 1,000.
        QVERIFY2(valid >= 36, qPrintable(QString::number(valid)));
    }
    /// At 100 Hz some squeezes tell it, some do not. (Those that do are those in which noise makes it large:
    /// fewer than 95 % of their intervals hold it.)
    void aMassThatIsToldDoesNotLie()
    {
        int withMass = 0, lies = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Identification found = identify(squeezeAt(100, seed).make());
            if (!found.budget.parameters)
                continue;
            ++withMass;
            const double away = std::abs(found.budget.parameters->m - ofACan.m);
            lies += away > 4 * found.budget.combined[0].standardUncertainty ? 1 : 0;
        }
        QVERIFY(withMass > 0);
        QCOMPARE(lies, 0);
    }
    void aHeavyPartKeepsItsMassOnTheSameGripper()
    {
        const MassDampingStiffness heavy{2, 60, 9990}; // swings at 11 Hz
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const Identification found = identify(squeezeAt(100, seed, heavy).make());
            QCOMPARE(toString(found.recommended), toString(Estimator::OutputError));
            QVERIFY(std::abs(found.best()->parameters->m - 2) < 0.1);
        }
    }
    void aFastGripperIsAsBefore()
    {
        const Identification found = identify(squeezeAt(2000, 1).make());
        QCOMPARE(toString(found.recommended), toString(Estimator::OutputError));
        QVERIFY(found.find(Estimator::Static) == nullptr); // nobody had to ask
    }
    /// It has settled long before the next sample.
    void theSpringAloneWhereNotEvenTheDampingIsTold()
    {
        const MassDampingStiffness stiff{0.002, 10, 10000};
        int alone = 0, covered = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Identification found = identify(squeezeAt(20, seed, stiff).make());
            QCOMPARE(toString(found.recommended), toString(Estimator::Static));
            const MotionTerms& terms = found.find(Estimator::Static)->motion->terms;
            alone += terms.parameters() == std::vector<P>{P::Stiffness} ? 1 : 0;
            // What noise lets it be, where that happens to be told: an upper bound, which holds.
            if (const FurtherParameter* const b = furtherOf(found, P::Damping))
                QVERIFY(terms.damping && b->interval.onlyUpperBound && b->interval.upper > stiff.b);
            covered += holds(furtherOf(found, P::Stiffness)->interval, stiff.k) ? 1 : 0;
            QVERIFY(!checkFailed(found, u"excitation"_s) && !checkFailed(found, u"convergence"_s));
        }
        QVERIFY2(alone > 5, qPrintable(QString::number(alone)));
        QVERIFY2(covered >= 33, qPrintable(QString::number(covered)));
    }
    /// Exact where nothing is uncertain, for both holds and between samples.
    void theSpringAloneIsExact_data()
    {
        QTest::addColumn<bool>("zero");
        QTest::addColumn<double>("lag");
        QTest::newRow("held") << true << 0.0;
        QTest::newRow("held, between") << true << 0.3;
        QTest::newRow("straight") << false << 0.0;
        QTest::newRow("straight, between") << false << 0.3;
    }
    void theSpringAloneIsExact()
    {
        QFETCH(bool, zero);
        QFETCH(double, lag);
        Recording recording = squeezeAt(20, 1).make();
        recording.hold = zero ? ForceHold::Zero : ForceHold::First;
        recording.forceLag_s = lag * recording.sampleTime_s;
        const auto at = [&](std::size_t i) { return recording.force[std::min(i, recording.size() - 1)]; };
        for (std::size_t i = 0; i < recording.size(); ++i) {
            // What acts at the position's time; held forces act until the next one comes.
            const double force =
                zero ? (lag > 0 ? at(i) : at(i > 0 ? i - 1 : 0)) : at(i) + lag * (at(i + 1) - at(i));
            recording.position[i] = 0.01 + force / 5000;
        }
        IdentificationOptions options;
        options.estimators = {Estimator::Static};
        const Identification found = identify(recording, options);
        const Estimate& spring = found.estimates.front();
        QVERIFY2(spring.status == EstimateStatus::Converged, qPrintable(spring.message.describe()));
        QVERIFY(!spring.motion->terms.damping);
        QVERIFY(std::abs(spring.motion->values[P::Stiffness] / 5000 - 1) < 1e-9);
    }
    /// It is k times that in b where the part creeps over some samples, and next to nothing in k.
    void theLagIsInTheDampingsInterval()
    {
        // Creeps over three samples.
        Recording recording = squeezeAt(50, 2, {ofACan.m, 600, ofACan.k}).make();
        const Identification sure = identify(recording);
        constexpr double lag_s = 1e-4;
        recording.chain.forceLagUncertainty_s = lag_s;
        const Identification unsure = identify(recording);
        const FurtherParameter *b = furtherOf(sure, P::Damping), *wider = furtherOf(unsure, P::Damping);
        QVERIFY(b != nullptr && wider != nullptr);
        QVERIFY(holds(b->interval, 600));
        const double more = std::sqrt(std::pow(wider->combined.standardUncertainty, 2) -
                                      std::pow(b->combined.standardUncertainty, 2));
        QVERIFY2(more > 0.5 * ofACan.k * lag_s && more < 3 * ofACan.k * lag_s,
                 qPrintable(QString::number(more)));
    }
    /// Each of two levels is always reached from the same side: k is off by Fc over 10 N, and nothing shows
    /// it.
    void frictionHidesBehindTwoLevels()
    {
        Synthetic two = squeezeAt(20, 4);
        two.kind = ExcitationKind::Prbs;
        Recording recording = two.make();
        const Identification unsure = identify(recording);
        QVERIFY(unsure.validity.verdict == ValidityVerdict::Suspect && checkFailed(unsure, u"excitation"_s));
        recording.chain.friction = GripperFriction{0.2, 0.05};
        const Identification sure = identify(recording);
        QVERIFY(!checkFailed(sure, u"excitation"_s));
        const FurtherParameter* const k = furtherOf(sure, P::Stiffness);
        // The root of the mean square of 0.2 +- 0.05 N over 10 N.
        QVERIFY(std::abs(k->combined.standardUncertainty / k->value - std::hypot(0.02, 0.005)) < 0.003);
    }
    /// 0.3 N at rest after each of four levels, that the part hangs back by.
    void frictionBehindFourLevelsIsInTheStiffnesssInterval()
    {
        constexpr double friction = 0.3;
        int covered = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            Recording recording = squeezeAt(20, seed).make();
            double way = 0, before = recording.force[0];
            for (std::size_t i = 1; i < recording.size(); ++i) {
                const double force = recording.force[i - 1];
                way = force > before ? 1 : force < before ? -1 : way;
                before = force;
                recording.position[i] -= way * friction / ofACan.k;
            }
            const Identification found = identify(recording);
            const FurtherParameter* const k = furtherOf(found, P::Stiffness);
            QVERIFY(k != nullptr);
            covered += holds(k->interval, ofACan.k) ? 1 : 0;
        }
        QVERIFY2(covered >= 33, qPrintable(QString::number(covered)));
    }
    /// Two levels of ten samples each, that move a parameter by 3 and -2 a unit of position: where nothing
    /// hides the counts each level errs by step^2 / 12 for itself. Half a step of noise hides them.
    void countsWithoutNoiseAreCountedLevelByLevel()
    {
        constexpr double step = 0.1;
        Estimate estimate;
        estimate.motion.emplace();
        estimate.motion->influences.resize(20, 1);
        for (int i = 0; i < 20; ++i) {
            estimate.simulated.push_back(i < 10 ? 1.0 : 2.0);
            estimate.motion->influences(i, 0) = i < 10 ? 0.3 : -0.2;
        }
        estimate.residuals.degreesOfFreedom = 18;
        const Eigen::VectorXd sharp = roundingVariances(estimate, step);
        QCOMPARE(sharp.size(), Eigen::Index(1));
        QVERIFY(std::abs(sharp(0) - step * step / 12 * (9 + 4)) < 1e-12);
        estimate.residuals.sse = 18 * (0.25 + 1.0 / 12) * step * step;
        QCOMPARE(roundingVariances(estimate, step).size(), Eigen::Index(0));
        QCOMPARE(roundingVariances(estimate, 0).size(), Eigen::Index(0));
    }
};

GRIPSCOPE_TEST(SlowGripperTest)
#include "slow_gripper_test.moc"
