// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/foreign_table.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// As a German measuring program writes it: a head, units below the names, semicolons, decimal commas.
QByteArray germanTable()
{
    return "Messung 12;;\nDatum;23.11.2026;\nZeit;Kraft;Weg\nms;N;mm\n"
           "0,0;1,25;0,01\n0,5;2,5;0,02\n1,0;-1,5e1;0,03\n";
}

QString said(const Expected<Recording>& recording)
{
    return recording ? u"read"_s : recording.error().describe();
}

Expected<Recording> readAsProposed(const QByteArray& text)
{
    const Expected<ForeignTable> table = examineTable(text, u"x.csv"_s);
    if (!table)
        return tl::unexpected<Error>(table.error());
    return parseRecordingCsv(text, u"x.csv"_s, proposedReading(*table));
}

} // namespace

class ForeignTableTest : public QObject {
    Q_OBJECT
private slots:
    void aGermanTableIsReadAsProposed()
    {
        const ForeignTable table = *examineTable(germanTable(), u"x.csv"_s);
        QCOMPARE(table.format.delimiter, ';');
        QCOMPARE(table.format.decimalMark, ',');
        QCOMPARE(table.format.skippedLines, std::size_t(2));
        QVERIFY(table.format.header);
        QCOMPARE(table.format.linesBelow, std::size_t(1));
        QCOMPARE(table.columns, QStringList({u"Zeit"_s, u"Kraft"_s, u"Weg"_s}));
        QCOMPARE(table.units, QStringList({u"ms"_s, u"N"_s, u"mm"_s}));
        QCOMPARE(table.rows.front(), QStringList({u"0,0"_s, u"1,25"_s, u"0,01"_s}));

        const Expected<Recording> recording = readAsProposed(germanTable());
        QVERIFY2(recording.has_value(), qPrintable(said(recording)));
        QVERIFY((recording->time_s == std::vector<double>{0, 0.0005, 0.001}));
        QVERIFY((recording->force == std::vector<double>{1.25, 2.5, -15}));
        QVERIFY((recording->position == std::vector<double>{0.01, 0.02, 0.03}));
        QCOMPARE(recording->forceUnit, u"N"_s);
        QCOMPARE(recording->positionUnit, u"mm"_s);
        QCOMPARE(recording->sampleTime_s, 0.0005);
    }
    void whatIsWhatIsProposed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("time"); // -1: none
        QTest::addColumn<int>("force");
        QTest::addColumn<int>("position");
        QTest::newRow("names") << QByteArray("y,u,t\n1,2,0\n3,4,1\n") << 2 << 1 << 0;
        QTest::newRow("units in brackets")
            << QByteArray("A [mm],B [s],C [kN]\n1,0,2\n3,1,4\n") << 1 << 2 << 0;
        QTest::newRow("units alone") << QByteArray("s;N;mm\n0;2;3\n1;4;5\n") << 0 << 1 << 2;
        QTest::newRow("no names, times that increase")
            << QByteArray("0\t5\t2\n1\t4\t3\n2\t4\t1\n") << 0 << 1 << 2;
        QTest::newRow("no names, no times") << QByteArray("5\t2\n4\t3\n4\t1\n") << -1 << 0 << 1;
        QTest::newRow("words beside numbers")
            << QByteArray("part,Weg/mm,Kraft/N\nA 1,2,3\nA 1,4,5\n") << -1 << 2 << 1;
    }
    void whatIsWhatIsProposed()
    {
        QFETCH(QByteArray, text);
        const Expected<ForeignTable> table = examineTable(text, u"x.csv"_s);
        QVERIFY2(table.has_value(), qPrintable(test::whyNot(table)));
        const CsvReadOptions options = proposedReading(*table);
        QTEST(options.columns->time ? int(*options.columns->time) : -1, "time");
        QTEST(int(options.columns->force), "force");
        QTEST(int(options.columns->position), "position");
    }
    void delimitersAndMarksAreTold_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<char>("delimiter");
        QTest::addColumn<char>("mark");
        QTest::newRow("commas") << QByteArray("u,y\n1.5,2\n2,3\n") << ',' << '.';
        QTest::newRow("semicolons, points") << QByteArray("u;y\n1.5;2\n2;3\n") << ';' << '.';
        QTest::newRow("semicolons, commas") << QByteArray("u;y\n1,5;2\n2;3,5\n") << ';' << ',';
        QTest::newRow("tabs, commas") << QByteArray("u\ty\n1,5\t2\n2\t3,5\n") << '\t' << ',';
        QTest::newRow("quoted decimal commas")
            << QByteArray("\"u\",\"y\"\n\"1,5\",\"2\"\n\"2,5\",\"3\"\n") << ',' << ',';
        QTest::newRow("CR LF") << QByteArray("u;y\r\n1,5;2\r\n2;3,5\r\n") << ';' << ',';
    }
    void delimitersAndMarksAreTold()
    {
        QFETCH(QByteArray, text);
        const Expected<ForeignTable> table = examineTable(text, u"x.csv"_s);
        QVERIFY2(table.has_value(), qPrintable(test::whyNot(table)));
        QTEST(table->format.delimiter, "delimiter");
        QTEST(table->format.decimalMark, "mark");
        QCOMPARE(table->columns, QStringList({u"u"_s, u"y"_s}));
    }
    void semicolonsAndDecimalCommasAreReadByNames()
    {
        CsvReadOptions options;
        options.forceColumn = u"u"_s;
        options.positionColumn = u"y"_s;
        options.timeColumn = u"t"_s;
        const Expected<Recording> recording =
            parseRecordingCsv(";t;u;y\n1;0,5;1,5;2\n2;0,75;2,5;3,5\n", u"x.csv"_s, options);
        QVERIFY2(recording.has_value(), qPrintable(said(recording)));
        QVERIFY((recording->time_s == std::vector<double>{0.5, 0.75}));
        QVERIFY((recording->force == std::vector<double>{1.5, 2.5}));
        QVERIFY((recording->position == std::vector<double>{2, 3.5}));
    }
    void errorsNameLineAndColumn_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("words");
        QTest::newRow("a point among commas")
            << QByteArray("1,5;1.234;1,0") << u"x.csv:8:2"_s << u"\"1.234\""_s;
        QTest::newRow("thousands") << QByteArray("1,5;1.234,5;1,0") << u"x.csv:8:2"_s << u"decimal comma"_s;
        QTest::newRow("a word") << QByteArray("1,5;1;ERR") << u"x.csv:8:3"_s << u"\"ERR\""_s;
        QTest::newRow("not a number") << QByteArray("1,5;nan;1") << u"x.csv:8:2"_s << u"\"nan\""_s;
        QTest::newRow("too large") << QByteArray("1,5;1e31;1") << u"x.csv:8:2"_s << u"1e+30"_s;
        QTest::newRow("time stands") << QByteArray("1,0;1;1") << u"x.csv:8:1"_s << u"later"_s;
        QTest::newRow("a field too few") << QByteArray("1,5;1") << u"x.csv:8:2"_s << u"2 fields"_s;
        QTest::newRow("a quote left open") << QByteArray("1,5;\"1;1") << u"x.csv:8:1"_s << u"quote"_s;
    }
    void errorsNameLineAndColumn()
    {
        QFETCH(QByteArray, row);
        QFETCH(QString, place);
        QFETCH(QString, words);
        const ForeignTable table = *examineTable(germanTable(), u"x.csv"_s);
        const Expected<Recording> recording =
            parseRecordingCsv(germanTable() + row + "\n", u"x.csv"_s, proposedReading(table));
        QVERIFY(!recording);
        QVERIFY2(said(recording).contains(place) && said(recording).contains(words),
                 qPrintable(said(recording)));
    }
    void oneMoreDelimiterAtTheEndOfRowsIsLetPass()
    {
        const Expected<Recording> recording = readAsProposed("t;u;y;\n0;1;2;\n1;2;3;\n");
        QVERIFY2(recording.has_value(), qPrintable(said(recording)));
        CsvReadOptions options;
        options.columns = CsvColumns{1, 2, 0};
        QVERIFY(parseRecordingCsv("t;u;y\n0;1;2;\n1;2;3;\n", u"x.csv"_s, options).has_value());
    }
    void anyEncodingIsRead()
    {
        const QString text = u"t (ms)\tF (N)\tx (\u00b5m)\n0\t1.5\t2\n1\t2.5\t3\n"_s;
        QByteArray utf16("\xff\xfe");
        for (const QChar letter : text) {
            utf16 += char(letter.unicode() & 0xFF);
            utf16 += char(letter.unicode() >> 8);
        }
        QTemporaryDir folder;
        for (const QByteArray& bytes : {text.toUtf8(), text.toLatin1(), utf16}) {
            QFile file(folder.filePath(u"x.csv"_s));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
            file.close();
            const Expected<QByteArray> head = readTableHead(file.fileName());
            QVERIFY(head.has_value());
            const CsvReadOptions options = proposedReading(*examineTable(*head, u"x.csv"_s));
            const Expected<Recording> recording = readForeignTable(file.fileName(), options);
            QVERIFY2(recording.has_value(), qPrintable(said(recording)));
            QVERIFY((recording->force == std::vector<double>{1.5, 2.5}));
            QCOMPARE(recording->positionUnit, u"\u00b5m"_s);
            QVERIFY((recording->time_s == std::vector<double>{0, 0.001}));
        }
    }
    void ofALongFileTheHeadHasWholeLines()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(u"long.csv"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QByteArray text("Kraft (N);Weg (\u00b5m)\n");
        for (int i = 0; text.size() < 3 * tableHeadBytes; ++i)
            text += QByteArray::number(i) + ",25;" + QByteArray::number(i % 7) + ",5\n";
        QCOMPARE(file.write(text), qint64(text.size()));
        file.close();
        const QByteArray head = *readTableHead(file.fileName());
        QVERIFY(head.endsWith('\n') && head.size() <= tableHeadBytes && text.startsWith(head));
        QCOMPARE(examineTable(head, u"long.csv"_s)->units[1], u"\u00b5m"_s);
    }
    void whatIsNoTableIsRefusedInWords_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("blank lines") << QByteArray("\n\n  \n\t\n");
        QTest::newRow("comments") << QByteArray("# a\n# b\n");
        QTest::newRow("a letter") << QByteArray("Dear Sir,\nplease find enclosed\n");
        QTest::newRow("one column") << QByteArray("u\n1\n2\n3\n");
        QTest::newRow("zeros") << QByteArray(1000, '\0');
        QTest::newRow("delimiters") << QByteArray(60'000, ';');
        QTest::newRow("a quote") << QByteArray("\"") + QByteArray(1000, ';');
        QTest::newRow("bytes") << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    }
    void whatIsNoTableIsRefusedInWords()
    {
        QFETCH(QByteArray, text);
        const Expected<ForeignTable> table = examineTable(tableText(text), u"x.csv"_s);
        QVERIFY(!table);
        QCOMPARE(table.error().name(), u"bad_input"_s);
        QVERIFY(table.error().describe().contains(u"x.csv:1:1"_s));
    }
    void whatWasGivenIsBelieved()
    {
        CsvFormat format;
        format.delimiter = ';';
        format.decimalMark = ',';
        format.skippedLines = 4;
        format.header = false;
        const ForeignTable table = *examineTable(germanTable(), u"x.csv"_s, format);
        QCOMPARE(table.columns, QStringList({u"1"_s, u"2"_s, u"3"_s}));
        QCOMPARE(table.rows.size(), std::size_t(3));
        CsvReadOptions options;
        options.format = format;
        options.columns = CsvColumns{1, 2, std::nullopt};
        options.sampleTime_s = 0.01;
        const Expected<Recording> recording = parseRecordingCsv(germanTable(), u"x.csv"_s, options);
        QVERIFY2(recording.has_value(), qPrintable(said(recording)));
        QVERIFY((recording->time_s == std::vector<double>{0, 0.01, 0.02}));
    }
    void optionsThatMakeNoSenseAreRefused()
    {
        const QByteArray text = "t,u,y\n0,1,2\n1,2,3\n";
        CsvReadOptions options;
        options.columns = CsvColumns{1, 1, 0};
        QCOMPARE(parseRecordingCsv(text, u"x.csv"_s, options).error().name(), u"usage"_s);
        options.columns = CsvColumns{1, 7, 0};
        const Expected<Recording> beyond = parseRecordingCsv(text, u"x.csv"_s, options);
        QVERIFY2(said(beyond).contains(u"found 3 columns"_s), qPrintable(said(beyond)));
        options.columns = CsvColumns{1, 2, 0};
        for (const double unit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
            options.timeUnit_s = unit;
            QCOMPARE(parseRecordingCsv(text, u"x.csv"_s, options).error().name(), u"usage"_s);
        }
        options = {};
        options.columns = CsvColumns{1, 2, std::nullopt};
        QVERIFY(said(parseRecordingCsv(text, u"x.csv"_s, options)).contains(u"sample time"_s));
        options.format.skippedLines = std::numeric_limits<std::size_t>::max();
        QVERIFY(said(parseRecordingCsv(text, u"x.csv"_s, options)).contains(u"header"_s));
    }
    void layoutsAreToldApart()
    {
        const auto key = [](const QByteArray& text) { return layoutKey(*examineTable(text, u"x.csv"_s)); };
        QCOMPARE(key("t;u;y\n0;1;2\n1;2;3\n"), key("t;u;y\n5;5,5;2\n6;7;3\n7;8;9\n"));
        QVERIFY(key("t;u;y\n0;1;2\n1;2;3\n") != key("t,u,y\n0,1,2\n1,2,3\n"));
        QVERIFY(key("t;u;y\n0;1;2\n1;2;3\n") != key("t;u;z\n0;1;2\n1;2;3\n"));
    }
};

GRIPSCOPE_TEST(ForeignTableTest)
#include "foreign_table_test.moc"
