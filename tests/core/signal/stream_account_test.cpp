// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/stream_account.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class StreamAccountTest : public QObject {
    Q_OBJECT
private slots:
    void comesBackFromItsText()
    {
        const StreamAccount account{12, 3, 4, 5, 6, 7, 0.125};
        QVERIFY(streamAccountFromText(toText(account)) == account);
        QVERIFY(streamAccountFromText({}) == StreamAccount());
        StreamAccount timed = account;
        timed.clocks.compared = true; // a young connection
        QVERIFY(streamAccountFromText(toText(timed)) == timed);
        timed.clocks.clock = RateDifference{-5500.25, 81};
        timed.clocks.sampling = RateDifference{1e6, 1200};
        QVERIFY(streamAccountFromText(toText(timed)) == timed);
        timed.clocks.compared = false; // then there is nothing to tell
        QCOMPARE(toText(timed), toText(account));
        const ClockAccount odd =
            streamAccountFromText(u"clock_compared=1 clock_ppm=nan clock_uncertainty_ppm=3 "
                                  "sampling_ppm=4 sampling_uncertainty_ppm=-1"_s)
                .clocks;
        QVERIFY(odd.compared && !odd.clock && !odd.sampling);
        QVERIFY(streamAccountFromText(u"new=1 gaps=2 odd"_s) == (StreamAccount{0, 2, 0, 0, 0, 0, 0}));
    }

    void staysWithTheRecordingThroughItsFile()
    {
        Recording recording;
        recording.sampleTime_s = 0.001;
        recording.time_s = {0, 0.001};
        recording.force = {1, 2};
        recording.position = {3, 4};
        QVERIFY(!streamAccount(recording));
        const StreamAccount account{12, 3, 0, 1, 0, 2, 0.08};
        recording.provenance[streamAccountKey()] = toText(account);
        const Expected<Recording> back = parseRecordingCsv(toCsv(recording), u"file.csv"_s);
        QVERIFY(back && streamAccount(*back) == account);
    }
};

GRIPSCOPE_TEST(StreamAccountTest)
#include "stream_account_test.moc"
