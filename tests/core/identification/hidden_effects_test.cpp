// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a budget for what a record cannot exclude: friction, how it begins to slide, jitter.
#include "core/identification/output_error/output_error.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/research/truth_study.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

Synthetic held()
{
    Synthetic synthetic;
    synthetic.truth = {0.0396, 43.0, 9990.0};
    synthetic.sampleTime_s = 5e-4;
    synthetic.bit_s = 5e-3;
    synthetic.peak = 10;
    synthetic.samples = 1000;
    synthetic.fitPercent = 97;
    synthetic.hold = ForceHold::Zero;
    return synthetic;
}

struct Fitted {
    Estimate estimate;
    LinearizedRecord record;
    OutputErrorOptions options;
};

Fitted fitted(const Recording& recording)
{
    Fitted out;
    out.options.sampleTime_s = recording.sampleTime_s;
    out.options.hold = ForceHold::Zero;
    out.estimate = estimateOutputError(recording.force, recording.position, out.options);
    out.record = linearizedRecord(out.estimate, recording.force, out.options);
    return out;
}

/// The shifts of (ln m, ln b, ln k) between two fits.
Eigen::Vector3d shiftBetween(const Fitted& before, const Fitted& after)
{
    return (after.estimate.parameters->vector().array() / before.estimate.parameters->vector().array()).log();
}

TruthSetting named(const QString& name)
{
    for (const TruthSetting& setting : truthSettings())
        if (setting.name == name)
            return setting;
    qFatal("there is no such setting: %s", qPrintable(name));
}

TruthRow studied(const QString& name, int runs)
{
    TruthStudyOptions options;
    options.settings = {named(name)};
    options.runs = runs;
    return studyTruth(options).rows.front();
}

} // namespace

class HiddenEffectsTest : public QObject {
    Q_OBJECT
private slots:
    /// What the line says friction does to m, b and k is what the fit does when friction's effect is added to
    /// the position: to first order, so for a small one (the second order is (2 %)^2).
    void frictionMovesTheEstimateByWhatTheLineHas()
    {
        const Recording plain = held().make();
        const Fitted before = fitted(plain);
        QVERIFY(before.record.usable());
        const std::vector<double> effect = frictionEffect(before.estimate, before.record, 5e-4);
        constexpr double friction = 0.1;
        Recording rubbed = plain;
        for (std::size_t i = 0; i < effect.size(); ++i)
            rubbed.position[i] += friction * effect[i];
        const Eigen::Vector3d moved = shiftBetween(before, fitted(rubbed));
        const Eigen::Vector3d said =
            friction * shiftsBy(before.record, std::vector<std::vector<double>>{effect}).col(0);
        QVERIFY2((moved - said).norm() < 0.03 * said.norm(),
                 qPrintable(u"%1 %2 %3"_s.arg(moved(2)).arg(said(2)).arg(moved.norm())));
        QVERIFY(moved(2) > 0.003); // it acts as stiffness
    }
    /// Friction of ten of its own deviations: the line's standard uncertainty is the shift that it made.
    void theLineIsAsLargeAsTheShift()
    {
        const Recording plain = held().make();
        const Fitted before = fitted(plain);
        const std::vector<double> effect = frictionEffect(before.estimate, before.record, 5e-4);
        Recording rubbed = plain;
        constexpr double friction = 1;
        for (std::size_t i = 0; i < effect.size(); ++i)
            rubbed.position[i] += friction * effect[i];
        const Fitted after = fitted(rubbed);
        const auto lines = hiddenFrictionLines(after.estimate, after.record,
                                               frictionEffect(after.estimate, after.record, 5e-4));
        QCOMPARE(lines.size(), 1U);
        QCOMPARE(lines[0].id, u"friction"_s);
        const double shift = after.estimate.parameters->k - before.estimate.parameters->k;
        const double said = lines[0].standardUncertainties()(2);
        QVERIFY2(std::abs(said / shift - 1) < 0.35, qPrintable(u"%1 for %2"_s.arg(said).arg(shift)));
        // One effect moves all three: the covariance has one direction.
        const Eigen::Matrix3d c = lines[0].covariance;
        QVERIFY(std::abs(c(1, 2) * c(1, 2) - c(1, 1) * c(2, 2)) < 1e-9 * c(1, 1) * c(2, 2));
    }
    void knownFrictionHasNoLine()
    {
        const Recording plain = held().make();
        const Fitted fit = fitted(plain);
        BudgetOptions options;
        const auto budget = [&] {
            return uncertaintyBudget(fit.estimate, plain.force, plain.position, fit.options, {}, options);
        };
        QVERIFY(budget().find(u"friction"_s) == nullptr);
        options.frictionIsKnown = false;
        QVERIFY(budget().find(u"friction"_s) != nullptr);
    }
    /// Two levels of force hide friction in the stiffness, four do not (physics.md: 0.4 against 0.06 %).
    void fourLevelsTellWhatTwoHide()
    {
        const TruthRow two = studied(u"friction 0.3 N, 2 levels"_s, 6);
        const TruthRow four = studied(u"friction 0.3 N, 4 levels"_s, 6);
        for (const TruthRow* row : {&two, &four}) {
            QCOMPARE(row->lies, 0);
            QVERIFY(row->valid >= 5);
            for (const double error : row->largestError)
                QVERIFY(error < 4);
        }
        QCOMPARE(four.widened, 0);
    }
    void hysteresisIsNotTakenForExactFriction()
    {
        const TruthRow row = studied(u"hysteresis 1 N over 0.1 mm"_s, 6);
        QVERIFY2(row.lies <= row.valid / 6, qPrintable(u"%1 of %2"_s.arg(row.lies).arg(row.valid)));
    }
    /// A part that yields for as long as the squeeze lasts has no stiffness that is left in the end.
    void slowYieldingIsSuspect()
    {
        const TruthRow row = studied(u"relaxes 20 % over 1000 ms, 2 levels"_s, 4);
        QCOMPARE(row.lies, 0);
        QVERIFY(row.suspect >= 3);
    }
    /// Noise that grows with speed: the mean of the stated covariance with the line is that of the estimates,
    /// and without it less. 300 runs: each variance is known to 8 %, four of that are allowed.
    void jitterIsCounted()
    {
        constexpr int runs = 300;
        constexpr double jitter_s = 2e-4;
        Synthetic synthetic = held();
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        Eigen::Vector3d stated = Eigen::Vector3d::Zero();
        Eigen::Vector3d withoutLine = Eigen::Vector3d::Zero();
        GaussianNoise noise(5);
        synthetic.fitPercent = 100;
        const Recording clean = synthetic.make();
        const Fitted truth = fitted(clean);
        int found = 0;
        for (int run = 0; run < runs; ++run) {
            Recording recording = clean;
            for (std::size_t i = 0; i < recording.size(); ++i)
                recording.position[i] += (jitter_s * truth.record.velocity[i]) * noise() + 1e-6 * noise();
            const Fitted fit = fitted(recording);
            const Eigen::Vector3d error =
                fit.estimate.parameters->vector() - truth.estimate.parameters->vector();
            squares += error.cwiseAbs2() / runs;
            const auto lines = jitterLines(fit.estimate, fit.record);
            found += lines.empty() ? 0 : 1;
            withoutLine += fit.estimate.covariance->diagonal() / runs;
            stated += fit.estimate.covariance->diagonal() / runs;
            if (!lines.empty())
                stated += lines[0].covariance.diagonal() / runs;
        }
        QVERIFY2(found > 0.99 * runs, qPrintable(QString::number(found)));
        const Eigen::Vector3d ratio = stated.cwiseQuotient(squares);
        // k is found where the part is slow, where there is less noise than the mean: it keeps the mean's.
        QVERIFY2(ratio.minCoeff() > 0.68 && ratio.head<2>().maxCoeff() < 1.32 && ratio(2) < 3,
                 qPrintable(u"%1 %2 %3"_s.arg(ratio(0)).arg(ratio(1)).arg(ratio(2))));
        QVERIFY(withoutLine.cwiseQuotient(squares).minCoeff() < 0.68);
    }
    /// p < 0.001 for each record: more than 3 of 300 once in 400 tests; the seeds are fixed.
    void evenNoiseIsNoJitter()
    {
        int found = 0;
        Synthetic synthetic = held();
        for (std::uint64_t run = 1; run <= 300; ++run) {
            synthetic.seed = run;
            const Fitted fit = fitted(synthetic.make());
            found += jitterLines(fit.estimate, fit.record).empty() ? 0 : 1;
        }
        QVERIFY2(found <= 3, qPrintable(QString::number(found)));
    }
};

GRIPSCOPE_TEST(HiddenEffectsTest)
#include "hidden_effects_test.moc"
