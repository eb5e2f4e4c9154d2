// SPDX-License-Identifier: GPL-3.0-or-later
// The cubic spring on measured records of a public benchmark, read from outside the tree; skipped where they
// are absent.
#include "core/signal/recording/recording_csv.h"
#include "tests/core/identification/duffing_simulation.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const QString silverboxFolder = QStringLiteral(GRIPSCOPE_SHARED_DATA "/silverbox");
constexpr double sampleTime_s = 16384 / 1e7;

Recording readSilverbox(const QString& name)
{
    CsvReadOptions options;
    options.forceColumn = u"u"_s;
    options.positionColumn = u"y"_s;
    options.sampleTime_s = sampleTime_s;
    const Expected<Recording> recording = readRecordingCsv(silverboxFolder + u'/' + name, options);
    return recording ? *recording : Recording();
}

Estimate silverboxEstimate(const Recording& recording, Window window)
{
    const Recording part = slice(recording, window);
    return estimateMotion(part.force, part.position, test::duffingOptions(sampleTime_s));
}

double ratio(double a, double b)
{
    return std::abs(a / b - 1);
}

#define SKIP_WITHOUT(name)                                                                                   \
    if (!QFileInfo::exists(silverboxFolder + u"/" name ""_s))                                                \
    QSKIP("the Silverbox record " name " is not in ../shared/data/silverbox")

} // namespace

class DuffingSilverboxTest : public QObject {
    Q_OBJECT
private slots:
    void theMultisineIsACubicSpring()
    {
        SKIP_WITHOUT("multisine_a.csv");
        const Recording recording = readSilverbox(u"multisine_a.csv"_s);
        const Estimate e = silverboxEstimate(recording, {0, recording.size()});
        QCOMPARE(toString(e.status), u"converged"_s);
        const double fit = e.fit.simulationPercent.value_or(0);
        QVERIFY2(fit >= 98.0 && fit < 99, qPrintable(QString::number(fit))); // science.md: 98.2 to 98.5
        // science.md, from other windows: m 5.16e-6, b 2.16e-4, k 0.951, k3 3.8; to their last digits.
        QVERIFY(ratio(e.parameters->m, 5.16e-6) < 0.005);
        QVERIFY(ratio(e.parameters->b, 2.16e-4) < 0.01);
        QVERIFY(ratio(e.parameters->k, 0.951) < 0.005);
        QVERIFY(ratio(test::cubicOf(e), 3.8) < 0.03);
    }
    void smallAndLargeAmplitudesAreTheSameObject()
    {
        SKIP_WITHOUT("arrow_small.csv");
        SKIP_WITHOUT("multisine_a.csv");
        const Recording small = readSilverbox(u"arrow_small.csv"_s);
        const Recording large = readSilverbox(u"multisine_a.csv"_s);
        const Estimate a = silverboxEstimate(small, {0, small.size()});
        const Estimate b = silverboxEstimate(large, {0, large.size()});
        QVERIFY(a.parameters && b.parameters);
        QVERIFY(ratio(a.parameters->m, b.parameters->m) < 0.01);
        QVERIFY(ratio(a.parameters->k, b.parameters->k) < 0.01);
        QVERIFY(ratio(a.parameters->b, b.parameters->b) < 0.03);
    }
    void quartersOfTheMultisineAgree()
    {
        SKIP_WITHOUT("multisine_a.csv");
        const Recording recording = readSilverbox(u"multisine_a.csv"_s);
        const Estimate whole = silverboxEstimate(recording, {0, recording.size()});
        const std::size_t quarter = recording.size() / 4;
        for (std::size_t i = 0; i < 4; ++i) {
            const Estimate e = silverboxEstimate(recording, {i * quarter, quarter});
            QCOMPARE(toString(e.status), u"converged"_s);
            QVERIFY(e.fit.simulationPercent.value_or(0) >= 98.0);
            QVERIFY(ratio(e.parameters->m, whole.parameters->m) < 0.01);
            QVERIFY(ratio(e.parameters->k, whole.parameters->k) < 0.01);
            QVERIFY(ratio(e.parameters->b, whole.parameters->b) < 0.03);
        }
    }
};

GRIPSCOPE_TEST(DuffingSilverboxTest)
#include "duffing_silverbox_test.moc"
