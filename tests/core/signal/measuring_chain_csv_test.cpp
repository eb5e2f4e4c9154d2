// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

MeasuringChain fullChain()
{
    MeasuringChain chain;
    chain.forceLagUncertainty_s = 1e-5 / 3;
    chain.forceNoiseDeviation = 0.02;
    chain.forceScaleUncertainty = 0.001;
    chain.positionScaleUncertainty = 2e-300;
    chain.frameCompliance = 1e-5;
    chain.frameComplianceUncertainty = 3e-7;
    chain.baseline = GripperBaseline{{0.0025, 1.0 / 7, 0}, {1e-5, 0, 2}};
    chain.friction = GripperFriction{0.3, 0.001 / 3};
    return chain;
}

Recording recordingWith(const MeasuringChain& chain)
{
    Recording recording;
    recording.sampleTime_s = 1;
    recording.chain = chain;
    recording.time_s = {0, 1};
    recording.force = {1, 2};
    recording.position = {3, 4};
    return recording;
}

} // namespace

class MeasuringChainCsvTest : public QObject {
    Q_OBJECT
private slots:
    void everyBitComesBack()
    {
        const Recording recording = recordingWith(fullChain());
        const Expected<Recording> back = parseRecordingCsv(toCsv(recording), u"x.csv"_s);
        QVERIFY2(back.has_value(), qPrintable(test::whyNot(back)));
        QVERIFY(*back == recording);
    }
    void eachKeyStandsAlone_data()
    {
        QTest::addColumn<QByteArray>("line");
        for (const QByteArray& line : measuringLines())
            QTest::newRow(line.constData()) << line;
    }
    void eachKeyStandsAlone()
    {
        QFETCH(QByteArray, line);
        const Expected<Recording> read =
            parseRecordingCsv("# sample_time_s: 1\n" + line + "\nforce,position\n1,3\n2,4\n", u"x.csv"_s);
        QVERIFY2(read.has_value(), qPrintable(test::whyNot(read)));
        QVERIFY(!(read->chain == MeasuringChain()));
        QVERIFY(read->provenance.isEmpty());
        QVERIFY(*parseRecordingCsv(toCsv(*read), u"x.csv"_s) == *read);
    }
    void absentKeysAreTheDefaultsAndTheDefaultWritesNone()
    {
        const QByteArray text = toCsv(recordingWith(MeasuringChain()));
        for (const char* key : {"uncertainty", "compliance", "baseline", "friction"})
            QVERIFY(!text.contains(key));
        QVERIFY(parseRecordingCsv(text, u"x.csv"_s)->chain == MeasuringChain());
    }
    void aBadValueIsFoundAtItsPlace_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("word");
        const QString number = u"a number from 0 to 1e+30"_s;
        const QString three = u"three numbers from 0 to 1e+30"_s;
        QTest::newRow("a word") << QByteArray("# force_lag_uncertainty_s: some") << number;
        QTest::newRow("below zero") << QByteArray("# force_scale_uncertainty: -0.01") << number;
        QTest::newRow("infinite") << QByteArray("# position_scale_uncertainty: inf") << number;
        QTest::newRow("huge") << QByteArray("# force_noise: 2.2e60") << number;
        QTest::newRow("friction below zero") << QByteArray("# friction: -0.1") << number;
        QTest::newRow("empty") << QByteArray("# frame_compliance:") << number;
        QTest::newRow("two numbers") << QByteArray("# frame_compliance_uncertainty: 1,2") << number;
        QTest::newRow("two of three") << QByteArray("# baseline: 1,2") << three;
        QTest::newRow("four") << QByteArray("# baseline: 1,2,3,4") << three;
        QTest::newRow("a word among three") << QByteArray("# baseline: 1,b,3") << three;
        QTest::newRow("a comma at the end") << QByteArray("# baseline: 1,2,") << three;
        QTest::newRow("negative") << QByteArray("# baseline_uncertainty: 1,2,-3") << three;
        QTest::newRow("a huge one") << QByteArray("# baseline: 1,2e31,3") << three;
        QTest::newRow("empty three") << QByteArray("# baseline_uncertainty:") << three;
    }
    void aBadValueIsFoundAtItsPlace()
    {
        QFETCH(QByteArray, line);
        QFETCH(QString, word);
        const Expected<Recording> read =
            parseRecordingCsv("# sample_time_s: 1\n" + line + "\nforce,position\n1,3\n2,4\n", u"x.csv"_s);
        QVERIFY(!read);
        QCOMPARE(read.error().name(), u"bad_input"_s);
        const QString message = read.error().describe();
        QVERIFY2(message.startsWith(u"x.csv:2:1: "_s), qPrintable(message));
        QVERIFY2(message.contains(word), qPrintable(message));
    }

private:
    static QList<QByteArray> measuringLines()
    {
        return {"# force_lag_uncertainty_s: 1e-5",      "# force_scale_uncertainty: 0.001",
                "# position_scale_uncertainty: 0.002",  "# frame_compliance: 1e-5",
                "# frame_compliance_uncertainty: 1e-7", "# baseline: 0.0025, 0.3, 12",
                "# baseline_uncertainty: 1e-5,0.01,2",  "# friction: 0.3",
                "# friction_uncertainty: 0.01"};
    }
};

GRIPSCOPE_TEST(MeasuringChainCsvTest)
#include "measuring_chain_csv_test.moc"
