// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording_csv.h"
#include "core/signal/stream_account.h"
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
