// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_table.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class FeatureTableTest : public QObject {
    Q_OBJECT
private slots:
    void readsTheColumnsAskedForInTheirOrder()
    {
        const auto table = parseFeatureTable("object,m,b,k\nA,1,2,3\nB,4,5e-1,-6\n", u"t.csv"_s,
                                             {u"k"_s, u"m"_s}, u"object"_s);
        QVERIFY(table);
        Eigen::MatrixXd wanted(2, 2);
        wanted << 3, 1, -6, 4;
        QVERIFY(table->values == wanted);
        QCOMPARE(table->truth, QStringList({u"A"_s, u"B"_s}));
        QCOMPARE(table->features, QStringList({u"k"_s, u"m"_s}));
    }
    void acceptsWhatSpreadsheetsWrite()
    {
        const auto table = parseFeatureTable(
            "\xef\xbb\xbf# a comment\r\n\r\n name , m \r\n\"Can, \"\"old\"\"\" , 1.5 \r\n\r\n", u"t.csv"_s,
            {u"m"_s}, u"name"_s);
        QVERIFY(table);
        QCOMPARE(table->truth, QStringList({u"Can, \"old\""_s}));
        QCOMPARE(table->values(0, 0), 1.5);
    }
    void withoutTruthThereAreNoLabels()
    {
        const auto table = parseFeatureTable("m\n1", u"t.csv"_s, {u"m"_s});
        QVERIFY(table);
        QVERIFY(table->truth.isEmpty());
    }
    void errorsNameThePlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        QTest::newRow("empty") << QByteArray() << u"t.csv:1:1"_s;
        QTest::newRow("only comments") << QByteArray("# nothing\n") << u"t.csv:1:1"_s;
        QTest::newRow("header only") << QByteArray("m,b\n") << u"t.csv:2:1"_s;
        QTest::newRow("missing column") << QByteArray("m,c\n1,2\n") << u"t.csv:1:1"_s;
        QTest::newRow("column twice") << QByteArray("m,b,b\n1,2,3\n") << u"t.csv:1:3"_s;
        QTest::newRow("not a number") << QByteArray("m,b\n1,2\n3,x\n") << u"t.csv:3:2"_s;
        QTest::newRow("nan") << QByteArray("m,b\nnan,2\n") << u"t.csv:2:1"_s;
        QTest::newRow("infinite") << QByteArray("m,b\n1,inf\n") << u"t.csv:2:2"_s;
        QTest::newRow("too large") << QByteArray("m,b\n1,1e999\n") << u"t.csv:2:2"_s;
        QTest::newRow("empty field") << QByteArray("m,b\n1,\n") << u"t.csv:2:2"_s;
        QTest::newRow("decimal comma") << QByteArray("m,b\n1,2,5\n") << u"t.csv:2:3"_s;
        QTest::newRow("cut off") << QByteArray("# c\nm,b\n1,2\n3") << u"t.csv:4:2"_s;
        QTest::newRow("open quote") << QByteArray("m,b\n\"1,2\n") << u"t.csv:2:1"_s;
        QTest::newRow("binary") << QByteArray("\x7f\x45\x4c\x46\0\1", 6) << u"t.csv:1:1"_s;
    }
    void errorsNameThePlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        const auto table = parseFeatureTable(text, u"t.csv"_s, {u"m"_s, u"b"_s});
        QVERIFY(!table);
        QCOMPARE(table.error().code, ErrorCode::BadInput);
        QCOMPARE(table.error().arguments.size(), std::size_t(3));
        QCOMPARE(table.error().argument(0), place);
        QVERIFY(table.error().describe().startsWith(place + u": found "_s));
    }
    void aFileThatIsNotThereIsUnreadable()
    {
        QCOMPARE(readFeatureTable(u"/nowhere/t.csv"_s, {u"m"_s}).error().code, ErrorCode::FileUnreadable);
        QCOMPARE(readFeatureTable(u"/"_s, {u"m"_s}).error().code, ErrorCode::FileUnreadable);
        QCOMPARE(parseFeatureTable("m\n1", u"t.csv"_s, {}).error().code, ErrorCode::Usage);
    }
};

GRIPSCOPE_TEST(FeatureTableTest)
#include "feature_table_test.moc"
