// SPDX-License-Identifier: GPL-3.0-or-later
// Measured records of a public benchmark, read from outside the tree; skipped where they are absent.
#include "core/identification/identification.h"
#include "core/signal/recording_csv.h"
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
