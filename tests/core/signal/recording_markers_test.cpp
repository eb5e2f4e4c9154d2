// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

class RecordingMarkersTest : public QObject {
    Q_OBJECT

    static Recording tenSamples()
    {
        Recording recording;
        recording.sampleTime_s = 0.5;
        for (int i = 0; i < 10; ++i) {
            recording.time_s.push_back(100 + 0.5 * i);
            recording.force.push_back(i);
            recording.position.push_back(-i);
        }
        return recording;
    }

private slots:
    void markersInsideAreNotedInOrderOfTime()
    {
        Recording recording = tenSamples();
        noteMarkers(recording, {{103, QStringLiteral("part turned")},
                                {99.9, QStringLiteral("before")},
                                {101.5, {}},
                                {104.6, QStringLiteral("after")}});
        QCOMPARE(recording.provenance.size(), 2);
        QCOMPARE(recording.provenance[QStringLiteral("marker_001")], QStringLiteral("101.5 s"));
        QCOMPARE(recording.provenance[QStringLiteral("marker_002")], QStringLiteral("103 s: part turned"));
    }
    void whatWasNotedBeforeGoes()
    {
        Recording recording = tenSamples();
        noteMarkers(recording, {{101, {}}, {102, {}}});
        noteMarkers(recording, {{103, {}}});
        QCOMPARE(recording.provenance.keys(), QStringList{QStringLiteral("marker_001")});
        QCOMPARE(recording.provenance[QStringLiteral("marker_001")], QStringLiteral("103 s"));
    }
    void aRecordingWithoutSamplesHasNone()
    {
        Recording recording;
        noteMarkers(recording, {{0, {}}});
        QVERIFY(recording.provenance.isEmpty());
    }
    void theFileKeepsThem()
    {
        Recording recording = tenSamples();
        noteMarkers(recording, {{103, QString::fromUtf8("größer: two\nlines")}});
        const Expected<Recording> read = parseRecordingCsv(toCsv(recording), QStringLiteral("test"));
        QVERIFY(read);
        QCOMPARE(read->provenance[QStringLiteral("marker_001")],
                 QString::fromUtf8("103 s: größer: two lines"));
    }
};

GRIPSCOPE_TEST(RecordingMarkersTest)
#include "recording_markers_test.moc"
