// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/printable.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class PrintableTest : public QObject {
    Q_OBJECT
private slots:
    void whatSteersIsWrittenOut_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        QTest::newRow("plain") << u"Greifer Zoë 3 µm, 手, 😀 <b>&amp;%1"_s
                               << u"Greifer Zoë 3 µm, 手, 😀 <b>&amp;%1"_s;
        QTest::newRow("colour") << u"\x1b[31mred"_s << u"\\x1b[31mred"_s;
        QTest::newRow("zero") << u"a"_s + QChar(0) + u'b' << u"a\\x00b"_s;
        QTest::newRow("line ends") << u"a\r\nb\tc"_s << u"a\\r\\nb\\tc"_s;
        QTest::newRow("eight-bit control") << QString(QChar(0x9b)) + u"31m"_s << u"\\x9b31m"_s;
        QTest::newRow("delete") << QString(QChar(0x7f)) << u"\\x7f"_s;
        QTest::newRow("right to left") << u"gpj.\u202eexe"_s << u"gpj.\\u202eexe"_s;
        QTest::newRow("isolate") << u"\u2066x\u2069"_s << u"\\u2066x\\u2069"_s;
        QTest::newRow("half a pair") << QString(QChar(0xd83d)) + u"x"_s << u"\\ud83dx"_s;
        QTest::newRow("the other half") << u"x"_s + QChar(0xde00) << u"x\\ude00"_s;
    }
    void whatSteersIsWrittenOut()
    {
        QFETCH(QString, text);
        QTEST(printable(text, longestQuote), "shown");
    }
    void linesOfOutputStay() { QCOMPARE(printableLines(u"a\n\tb\x1b"_s), u"a\n\tb\\x1b"_s); }
    void aLongTextKeepsItsEnds()
    {
        const QString text = u"first"_s + QString(100'000, u'.') + u"last"_s;
        const QString shown = printable(text, longestQuote);
        QVERIFY(shown.size() <= longestQuote + 3);
        QVERIFY(shown.startsWith(u"first"_s) && shown.endsWith(u"last"_s));
    }
    void aPairIsNotCutApart()
    {
        const QString text = QString(u"😀"_s).repeated(1000);
        for (qsizetype most = 10; most < 30; ++most)
            QVERIFY(!printable(text, most).contains(u"\\u"_s));
    }
    void adviceOfSeveralLinesKeepsThem()
    {
        const Error error{ErrorCode::DevicePermission, {u"hid:"_s, u"Type this:\nsudo a\nsudo b"_s}};
        QVERIFY(error.describe().endsWith(u"Type this:\nsudo a\nsudo b"_s));
    }
    void noMessageIsFloodedOrSteeredByItsArguments()
    {
        const Error error{ErrorCode::BadInput,
                          {u"x.csv:1:1"_s, QString(50'000'000, u'x'), u"expected \x1b[2J"_s}};
        const QString words = error.describe();
        QVERIFY(words.size() < 1500);
        QVERIFY(!words.contains(QChar(0x1b)));
    }
};

GRIPSCOPE_TEST(PrintableTest)
#include "printable_test.moc"
