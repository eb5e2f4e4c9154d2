// SPDX-License-Identifier: GPL-3.0-or-later
// Measured records of a public benchmark, read from outside the tree; skipped where they are absent.
#include "core/identification/identification.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const QString folder = QStringLiteral(GRIPSCOPE_SHARED_DATA "/silverbox");

Recording read(const QString& name)
{
    CsvReadOptions options;
    options.forceColumn = u"u"_s;
    options.positionColumn = u"y"_s;
    options.sampleTime_s = 16384 / 1e7;
    const Expected<Recording> recording = readRecordingCsv(folder + u'/' + name, options);
    return recording ? *recording : Recording();
}

bool failed(const Identification& identification, const QString& id)
{
    for (const ValidityCheck& check : identification.validity.checks) {
        if (check.id == id)
            return !check.ok;
    }
    return false;
}

#define SKIP_WITHOUT(name)                                                                                   \
    if (!QFileInfo::exists(folder + u"/" name ""_s))                                                         \
    QSKIP("the Silverbox record " name " is not in ../shared/data/silverbox")

} // namespace

class SilverboxTest : public QObject {
    Q_OBJECT
private slots:
    void smallAmplitudeIsALinearObjectWithStraightForce()
    {
        SKIP_WITHOUT("arrow_small.csv");
        IdentificationOptions options;
        options.hold = ForceHold::First;
        const Identification found = identify(read(u"arrow_small.csv"_s), options);
        QCOMPARE(toString(found.recommended), u"oe"_s);
        const Estimate& e = *found.best();
        QVERIFY2(*e.fit.simulationPercent >= 97.4, qPrintable(QString::number(*e.fit.simulationPercent)));
        // science.md, with a cubic spring: m 5.16e-6, b 2.16e-4, k 0.951; the linear spring is within 3 %.
        QVERIFY(std::abs(e.parameters->m / 5.16e-6 - 1) < 0.03);
        QVERIFY(std::abs(e.parameters->b / 2.16e-4 - 1) < 0.03);
        QVERIFY(std::abs(e.parameters->k / 0.951 - 1) < 0.03);
        // The missing cubic term shows in the residuals: the errors stated are too small, and that is said.
        QVERIFY(failed(found, u"residual_whiteness"_s));
        QVERIFY(!failed(found, u"hold"_s));
        QVERIFY(found.validity.verdict == ValidityVerdict::Suspect);
    }
    void largeAmplitudeIsAStiffeningSpringAndTheLinearModelSaysSo()
    {
        SKIP_WITHOUT("multisine_a.csv");
        IdentificationOptions options;
        options.hold = ForceHold::First;
        options.estimators = {Estimator::OutputError, Estimator::Duffing};
        const Identification found = identify(read(u"multisine_a.csv"_s), options);
        QCOMPARE(toString(found.recommended), u"duffing"_s);
        QVERIFY(*found.best()->fit.simulationPercent >= 98.0);
        QVERIFY2(found.comparison.sentence.describe().contains(u"stiffening"_s),
                 qPrintable(found.comparison.sentence.describe()));
        options.estimators = {Estimator::OutputError};
        const Identification linear = identify(read(u"multisine_a.csv"_s), options);
        QCOMPARE(toString(linear.recommended), u"oe"_s);
        QVERIFY(linear.validity.verdict == ValidityVerdict::Suspect);
        QVERIFY(failed(linear, u"residual_whiteness"_s) || failed(linear, u"input_independence"_s));
        // The linear k is 3 % off what the cubic model finds; the interval that is stated holds it.
        const CoverageInterval& k = linear.budget.intervals[2];
        QVERIFY(k.lower < found.best()->parameters->k && found.best()->parameters->k < k.upper);
    }
    void amplitudesAgreeWithinWhatIsStated()
    {
        SKIP_WITHOUT("arrow_small.csv");
        SKIP_WITHOUT("multisine_a.csv");
        IdentificationOptions options;
        options.hold = ForceHold::First;
        options.estimators = {Estimator::OutputError, Estimator::Duffing};
        const Identification small = identify(read(u"arrow_small.csv"_s), options);
        const Identification large = identify(read(u"multisine_a.csv"_s), options);
        const Eigen::Vector3d a = small.find(Estimator::Duffing)->parameters->vector();
        const Eigen::Vector3d b = large.find(Estimator::Duffing)->parameters->vector();
        const Eigen::Vector3d allowed(0.01, 0.03, 0.01);
        QVERIFY(((a - b).cwiseAbs().array() < allowed.array() * b.array()).all());
        for (std::size_t i = 0; i < 3; ++i) {
            const CoverageInterval& one = small.budget.intervals[i];
            const CoverageInterval& other = large.budget.intervals[i];
            QVERIFY2(one.lower <= other.upper && other.lower <= one.upper, qPrintable(QString::number(i)));
        }
    }
    void theWrongHoldIsFoundOut()
    {
        SKIP_WITHOUT("arrow_small.csv");
        IdentificationOptions options;
        options.hold = ForceHold::Zero;
        const Identification found = identify(read(u"arrow_small.csv"_s), options);
        QVERIFY(std::abs(*found.best()->fit.simulationPercent - 76) < 1); // science.md
        QVERIFY(failed(found, u"hold"_s));
    }
    void largeAmplitudeMeetsTheLimitOfALinearSpring()
    {
        SKIP_WITHOUT("multisine_a.csv");
        IdentificationOptions options;
        options.hold = ForceHold::First;
        const Identification found = identify(read(u"multisine_a.csv"_s), options);
        const double fit = *found.best()->fit.simulationPercent;
        QVERIFY2(fit > 76 && fit < 87, qPrintable(QString::number(fit))); // science.md: 76 to 86 %
        QVERIFY(failed(found, u"residual_whiteness"_s));
        QVERIFY(found.validity.verdict == ValidityVerdict::Suspect);
    }
};

GRIPSCOPE_TEST(SilverboxTest)
#include "silverbox_test.moc"
