// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

using Change = std::function<void(Recording&)>;
Q_DECLARE_METATYPE(Change)

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Recording good()
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    recording.time_s = {0, 0.001, 0.002};
    recording.force = {1, 2, 3};
    recording.position = {4, 5, 6};
    return recording;
}

} // namespace

class RecordingLimitsTest : public QObject {
    Q_OBJECT
private slots:
    void sampleTimesHaveARange()
    {
        for (const double seconds : {1e-6, 0.0005, 1.0})
            QVERIFY2(isSampleTime(seconds), qPrintable(QString::number(seconds)));
        for (const double seconds : {0.0, -0.001, 1e-22, 9e-7, 1.001, 1e300, infinity, -infinity, none})
            QVERIFY2(!isSampleTime(seconds), qPrintable(QString::number(seconds)));
    }
    void aCountOfSamplesNeverLeavesItsType()
    {
        QCOMPARE(samplesIn(2, 0.001), std::size_t(2000));
        QCOMPARE(samplesIn(0, 0.001), std::size_t(0));
        for (const double seconds : {1e12, 1e300, -1.0, infinity, none})
            QCOMPARE(samplesIn(seconds, 0.001), mostSamples + 1);
        QCOMPARE(samplesIn(1, 0), mostSamples + 1);
        QCOMPARE(samplesIn(0, 0), mostSamples + 1);
    }
    void whatNoRecordingHasIsNamed_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const Change& change, const QString& word) {
            QTest::newRow(name) << change << word;
        };
        row(
            "fine sample time", [](Recording& r) { r.sampleTime_s = 1e-22; }, u"sample time"_s);
        row(
            "no sample time", [](Recording& r) { r.sampleTime_s = 0; }, u"sample time"_s);
        row(
            "sample time that is none", [](Recording& r) { r.sampleTime_s = none; }, u"sample time"_s);
        row(
            "lag", [](Recording& r) { r.forceLag_s = 5; }, u"lag"_s);
        row(
            "lag that is none", [](Recording& r) { r.forceLag_s = none; }, u"lag"_s);
        row(
            "force that is none", [](Recording& r) { r.force[1] = none; }, u"finite"_s);
        row(
            "infinite position", [](Recording& r) { r.position[1] = -infinity; }, u"finite"_s);
        row(
            "huge position", [](Recording& r) { r.position[1] = 1e200; }, u"beyond"_s);
        row(
            "time that is none", [](Recording& r) { r.time_s[1] = none; }, u"finite"_s);
        row(
            "time stands", [](Recording& r) { r.time_s[1] = 0; }, u"increase"_s);
        row(
            "time runs back", [](Recording& r) { r.time_s[2] = -1; }, u"increase"_s);
        row(
            "short channel", [](Recording& r) { r.position.pop_back(); }, u"length"_s);
        row(
            "short numbers", [](Recording& r) { r.sequence = {1}; }, u"length"_s);
        row(
            "noise", [](Recording& r) { r.chain.forceNoiseDeviation = infinity; }, u"chain"_s);
        row(
            "baseline",
            [](Recording& r) {
                r.chain.baseline = GripperBaseline{{1, none, 1}, {}};
            },
            u"chain"_s);
        row(
            "facts",
            [](Recording& r) {
                for (int i = 0; i <= mostFacts; ++i)
                    r.provenance.insert(QString::number(i), {});
            },
            u"facts"_s);
    }
    void whatNoRecordingHasIsNamed()
    {
        QFETCH(Change, change);
        QFETCH(QString, word);
        Recording recording = good();
        QVERIFY(!outOfRange(recording));
        change(recording);
        const std::optional<Finding> reason = outOfRange(recording);
        QVERIFY(reason);
        QVERIFY2(reason->describe().contains(word), qPrintable(reason->describe()));
        QCOMPARE(writeRecordingCsv(recording, u"/nowhere/x.csv"_s).error().code, ErrorCode::Usage);
    }
    void aHeadWithoutSamplesIsARecordingToo() { QVERIFY(!outOfRange(Recording())); }
};

GRIPSCOPE_TEST(RecordingLimitsTest)
#include "recording_limits_test.moc"
