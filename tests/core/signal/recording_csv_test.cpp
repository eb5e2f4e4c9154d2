// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

Recording fullRecording()
{
    Recording recording;
    recording.sampleTime_s = 0.0005;
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"\u00b5m"_s;
    recording.hold = ForceHold::Zero;
    recording.forceLag_s = 1.25e-5;
    recording.time_s = {0, 0.0005, 0.0015};
    recording.force = {1.0 / 3, -2.5e-300, 1e22};
    recording.position = {0.1, std::numeric_limits<double>::denorm_min(), -0.0};
    recording.sequence = {7, 8, 10};
    recording.status = {0, 3, 65535};
    recording.provenance = {{u"device"_s, u"virtual: A"_s}, {u"operator"_s, u"Zo\u00eb"_s}};
    return recording;
}

CsvReadOptions uAndY()
{
    CsvReadOptions options;
    options.forceColumn = u"u"_s;
    options.positionColumn = u"y"_s;
    options.sampleTime_s = 0.05;
    return options;
}

} // namespace

class RecordingCsvTest : public QObject {
    Q_OBJECT
private slots:
    void aLagOfZeroIsStatedOnlyWhereTheFileNamesIt()
    {
        const QByteArray rows = "time_s,force,position\n0,1,2\n0.1,1,2\n0.2,1,2\n";
        const auto silent = parseRecordingCsv(rows, u"x.csv"_s);
        QVERIFY(silent && !silent->provenance.contains(forceLagSourceKey()));
        QVERIFY(!toCsv(*silent).contains("force_lag_s"));
        QVERIFY(!lagIsStated(*silent));
        QVERIFY(std::abs(unmeasuredLagBound_s(*silent) - 0.01) < 1e-12); // a tenth of 0.1 s
        const auto stated = parseRecordingCsv("# force_lag_s: 0\n" + rows, u"x.csv"_s);
        QVERIFY(stated && stated->provenance.contains(forceLagSourceKey()));
        QVERIFY(toCsv(*stated).contains("# force_lag_s: 0\n"));
        QVERIFY(lagIsStated(*stated) && unmeasuredLagBound_s(*stated) == 0);
        QVERIFY(*parseRecordingCsv(toCsv(*stated), u"x.csv"_s) == *stated);
    }
    void everythingReadsBackToTheSameBits()
    {
        const Recording recording = fullRecording();
        const Expected<Recording> back = parseRecordingCsv(toCsv(recording), u"x.csv"_s);
        QVERIFY2(back.has_value(), qPrintable(test::whyNot(back)));
        QVERIFY(*back == recording);
        QVERIFY(std::signbit(back->position[2]));
    }
    void optionalColumnsAndSettingsMayBeAbsent()
    {
        Recording recording = fullRecording();
        recording.sequence.clear();
        recording.status.clear();
        recording.hold.reset();
        QVERIFY(*parseRecordingCsv(toCsv(recording), u"x.csv"_s) == recording);
    }
    void aLineBreakInAFactDoesNotBreakTheFile()
    {
        Recording recording = fullRecording();
        recording.provenance = {{u"note"_s, u"two\nlines"_s}};
        const Expected<Recording> back = parseRecordingCsv(toCsv(recording), u"x.csv"_s);
        QVERIFY(back.has_value());
        QCOMPARE(back->provenance[u"note"_s], u"two lines"_s);
    }
    void whatIsReadIsWrittenAndReadTheSame_data()
    {
        QTest::addColumn<QByteArray>("head");
        QTest::newRow("a key behind a space that is none of ASCII") << QByteArray("# \u00a0force_noise: 2\n");
        QTest::newRow("a key behind two byte order marks") << QByteArray("# \ufeff\ufeffforce_noise: 2\n");
        QTest::newRow("a key with a vertical tab") << QByteArray("# \x0bnote\x0b: a\x0b\n");
        QTest::newRow("a key of spaces") << QByteArray("# \u00a0: a\n");
        QTest::newRow("a lone carriage return") << QByteArray("# note: a\rb\n");
        QTest::newRow("line ends of other alphabets") << QByteArray("# note: a\u2028b\u0085c\n");
        QTest::newRow("a unit of spaces") << QByteArray("# force_unit: \u2003\n");
        QTest::newRow("the longest line") << "#k:" + QByteArray(65'536 - 5, 'v') + "\n";
        QByteArray facts;
        for (int i = 0; i < 999; ++i) // one more, the source of the sample time, is added when it is read
            facts += "# " + QByteArray::number(i) + ": x\n";
        QTest::newRow("as many facts as there may be") << facts;
    }
    void whatIsReadIsWrittenAndReadTheSame()
    {
        QFETCH(QByteArray, head);
        const auto read = parseRecordingCsv(head + "time_s,force,position\n0,1,2\n0.1,1,2\n", u"x.csv"_s);
        QVERIFY2(read.has_value(), qPrintable(test::whyNot(read)));
        const QByteArray written = toCsv(*read);
        const auto again = parseRecordingCsv(written, u"x.csv"_s);
        QVERIFY2(again.has_value(), qPrintable(test::whyNot(again)));
        QVERIFY(*again == *read);
        QCOMPARE(toCsv(*again), written);
    }
    void theFileIsWrittenAndReadBack()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"squeeze.csv"_s);
        QVERIFY(writeRecordingCsv(fullRecording(), file).has_value());
        QVERIFY(*readRecordingCsv(file) == fullRecording());
    }
    void aFileThatCannotBeWrittenSaysSo()
    {
        QCOMPARE(writeRecordingCsv(fullRecording(), u"/nowhere/at/all.csv"_s).error().name(),
                 u"file_unwritable"_s);
    }
    void aFileThatIsNotThereSaysSo()
    {
        const Expected<Recording> recording = readRecordingCsv(u"/nowhere/at/all.csv"_s);
        QCOMPARE(recording.error().name(), u"file_unreadable"_s);
        QVERIFY(recording.error().describe().contains(u"/nowhere/at/all.csv"_s));
        QCOMPARE(readRecordingCsv(u"/tmp"_s).error().name(), u"file_unreadable"_s);
    }
    void anyCsvIsReadWithNamedColumns()
    {
        CsvReadOptions options = uAndY();
        options.forceUnit = u"N"_s;
        const Recording recording = *parseRecordingCsv("t,y,u\n0,1,2\n1,3,4\n", u"x.csv"_s, options);
        QVERIFY((recording.force == std::vector<double>{2, 4}));
        QVERIFY((recording.position == std::vector<double>{1, 3}));
        QVERIFY((recording.time_s == std::vector<double>{0, 0.05}));
        QCOMPARE(recording.forceUnit, u"N"_s);
        QCOMPARE(recording.positionUnit, u"1"_s);
        QVERIFY(!recording.hold);
    }
    void formsOfTheSameFileReadAlike_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("u,y\n1,2\n3,4\n");
        QTest::newRow("CR LF") << QByteArray("u,y\r\n1,2\r\n3,4\r\n");
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFu,y\n1,2\n3,4\n");
        QTest::newRow("no last line end") << QByteArray("u,y\n1,2\n3,4");
        QTest::newRow("spaces") << QByteArray(" u , y \n 1 ,\t2\n3 , 4 \n");
        QTest::newRow("quotes") << QByteArray("\"u\",\"y\"\n\"1\",2\n3,\"4\"\n");
        QTest::newRow("plus signs, exponents") << QByteArray("u,y\n+1,2e0\n.3E1,400e-2\n");
        QTest::newRow("blank lines") << QByteArray("\nu,y\n1,2\n\n3,4\n\n\n");
        QTest::newRow("remarks") << QByteArray("# made by hand\n#\nu,y\n1,2\n# half way\n3,4\n");
    }
    void formsOfTheSameFileReadAlike()
    {
        QFETCH(QByteArray, text);
        const Expected<Recording> recording = parseRecordingCsv(text, u"x.csv"_s, uAndY());
        QVERIFY2(recording.has_value(), qPrintable(test::whyNot(recording)));
        QVERIFY((recording->force == std::vector<double>{1, 3}));
        QVERIFY((recording->position == std::vector<double>{2, 4}));
    }
    void quotedFieldsMayHoldCommasAndQuotes()
    {
        const Expected<Recording> recording =
            parseRecordingCsv("\"a \"\"b\"\", c\",u,y\n\"x,y\",1,2\n,3,4\n", u"x.csv"_s, uAndY());
        QVERIFY(recording.has_value());
        QVERIFY((recording->force == std::vector<double>{1, 3}));
    }
    void mistakesAreFoundAtTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const QByteArray& text, const char16_t* place,
                            const char16_t* word) {
            QTest::newRow(name) << text << QString::fromUtf16(place) << QString::fromUtf16(word);
        };
        row("empty", "", u"x.csv:1:1", u"no header");
        row("blank", "\n\n \n", u"x.csv:3:1", u"no header");
        row("remarks only", "# hello\n", u"x.csv:1:1", u"no header");
        row("header only", "u,y\n", u"x.csv:1:1", u"no rows");
        row("a word", "u,y\n1,2\n1,x\n", u"x.csv:3:2", u"\"x\"");
        row("not a number", "u,y\n1,nan\n", u"x.csv:2:2", u"\"nan\"");
        row("infinite", "u,y\n1,2\n-inf,2\n", u"x.csv:3:1", u"\"-inf\"");
        row("too large", "u,y\n1,1e999\n", u"x.csv:2:2", u"\"1e999\"");
        row("hexadecimal", "u,y\n1,0x10\n", u"x.csv:2:2", u"\"0x10\"");
        row("decimal comma", "u,y\n1,5,2\n", u"x.csv:2:2", u"3 fields");
        row("empty field", "u,y\n1,\n", u"x.csv:2:2", u"\"\"");
        row("short row", "u,y\n1,2\n1\n", u"x.csv:3:1", u"1 fields");
        row("cut last row", "u,y\n1,2\n1", u"x.csv:3:1", u"1 fields");
        row("long row", "u,y\n1,2,3\n", u"x.csv:2:2", u"3 fields");
        row("other columns", "a,b\n1,2\n", u"x.csv:1:1", u"a, b");
        row("column twice", "u,y,u\n1,2,3\n", u"x.csv:1:3", u"twice");
        row("semicolons", "u;y\n1;2\n1;zwei\n", u"x.csv:3:2", u"zwei");
        row("open quote", "u,y\n\"1,2\n", u"x.csv:2:1", u"quote");
        row("time stands", "u,y,time_s\n1,2,0\n1,2,1\n1,2,1\n", u"x.csv:4:3", u"later");
        row("time runs back", "time_s,u,y\n1,1,2\n0,1,2\n", u"x.csv:3:1", u"later");
        row("negative sequence", "u,y,sequence\n1,2,-1\n", u"x.csv:2:3", u"whole number");
        row("status too large", "u,y,status\n1,2,65536\n", u"x.csv:2:3", u"65535");
        row("not UTF-8", "u,y\n1,\xFF\xFE\n", u"x.csv:2:1", u"UTF-8");
        row("cut UTF-8", "# who: Zo\xC3\nu,y\n1,2\n", u"x.csv:1:1", u"UTF-8");
        row("binary",
            QByteArray("\x7F"
                       "ELF\x02\0\0\0",
                       8),
            u"x.csv:1:1", u"no column");
        row("newer format", "# gripscope-recording: 2\nu,y\n1,2\n", u"x.csv:1:1", u"version 1");
        row("bad hold", "# force_hold: spline\nu,y\n1,2\n", u"x.csv:1:1", u"zoh or foh");
        row("bad sample time", "# sample_time_s: 0\nu,y\n1,2\n", u"x.csv:1:1", u"from 1e-06 to 1");
        row("sample time too fine", "# sample_time_s: 1e-22\nu,y\n1,2\n", u"x.csv:1:1", u"from 1e-06 to 1");
        row("number too large", "u,y\n1,1e200\n", u"x.csv:2:2", u"1e+30");
        row("lag too long", "# force_lag_s: 5\nu,y\n1,2\n", u"x.csv:1:1", u"from -1 to 1");
        row("long line", "# x: " + QByteArray(70'000, 'x') + "\nu,y\n1,2\n", u"x.csv:1:1", u"65536");
        row("bad lag", "# force_lag_s: soon\nu,y\n1,2\n", u"x.csv:1:1", u"seconds");
    }
    void mistakesAreFoundAtTheirPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        QFETCH(QString, word);
        const Expected<Recording> recording = parseRecordingCsv(text, u"x.csv"_s, uAndY());
        QVERIFY(!recording);
        QCOMPARE(recording.error().name(), u"bad_input"_s);
        const QString message = recording.error().describe();
        QVERIFY2(recording.error().argument(0) == place, qPrintable(message));
        QVERIFY2(message.contains(word), qPrintable(message));
        QVERIFY2(message.startsWith(place + u": "_s), qPrintable(message));
    }
    void theSampleTimeMustComeFromSomewhere()
    {
        CsvReadOptions options = uAndY();
        options.sampleTime_s.reset();
        for (const QByteArray& steps : {QByteArray("1e9"), QByteArray("1e-9")}) {
            const auto odd = parseRecordingCsv("time_s,u,y\n0,1,2\n" + steps + ",1,2\n", u"x.csv"_s, options);
            QVERIFY(!odd && odd.error().describe().contains(u"from 1e-06 to 1"_s));
        }
        QVERIFY(!parseRecordingCsv("u,y\n1,2\n3,4\n", u"x.csv"_s, options));
        QCOMPARE(
            parseRecordingCsv("# sample_time_s: 0.25\nu,y\n1,2\n3,4\n", u"x.csv"_s, options)->sampleTime_s,
            0.25);
        // A time column tells it, lost samples and all, and the recording says where it is from.
        const Recording inferred = *parseRecordingCsv(
            "time_s,u,y\n0,1,2\n0.1,1,2\n0.5,1,2\n0.6,1,2\n0.7,1,2\n", u"x.csv"_s, options);
        QVERIFY(std::abs(inferred.sampleTime_s - 0.1) < 1e-12);
        QVERIFY(inferred.provenance.contains(u"sample_time_source"_s));
        QCOMPARE(findGaps(inferred).size(), std::size_t(1));
        QVERIFY(!parseRecordingCsv("time_s,u,y\n0,1,2\n", u"x.csv"_s, options));
    }
    void theOptionGoesBeforeTheFilesOwnSampleTime()
    {
        QCOMPARE(
            parseRecordingCsv("# sample_time_s: 0.25\nu,y\n1,2\n3,4\n", u"x.csv"_s, uAndY())->sampleTime_s,
            0.05);
    }
    void timesThatContradictTheSampleTimeAreRefused()
    {
        const Expected<Recording> recording =
            parseRecordingCsv("time_s,u,y\n0,1,2\n0.01,1,2\n0.02,1,2\n", u"x.csv"_s, uAndY());
        QVERIFY(!recording);
        QVERIFY(recording.error().describe().contains(u"0.01"_s));
    }
    void aMillionRowsAreRead()
    {
        QByteArray text("u,y\n");
        for (int i = 0; i < 1000000; ++i)
            text += QByteArray::number(i) + ",0.25\n";
        const Expected<Recording> recording = parseRecordingCsv(text, u"x.csv"_s, uAndY());
        QVERIFY(recording.has_value());
        QCOMPARE(recording->size(), std::size_t(1000000));
        QCOMPARE(recording->force.back(), 999999.0);
    }
    void everyCutOfAFileIsReadOrRefused()
    {
        const QByteArray whole = toCsv(fullRecording());
        for (qsizetype size = 0; size < whole.size(); ++size) {
            const Expected<Recording> recording = parseRecordingCsv(whole.left(size), u"x.csv"_s);
            QVERIFY(!recording || recording->size() <= 3);
        }
    }
};

GRIPSCOPE_TEST(RecordingCsvTest)
#include "recording_csv_test.moc"
