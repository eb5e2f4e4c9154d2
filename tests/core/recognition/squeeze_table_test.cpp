// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/squeeze_table.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

SqueezeColumns columnsWithType()
{
    SqueezeColumns columns;
    columns.type = u"object"_s;
    return columns;
}

} // namespace

class SqueezeTableTest : public QObject {
    Q_OBJECT
private slots:
    void rowsBecomeSqueezes()
    {
        SqueezeColumns columns = columnsWithType();
        columns.deviations = {u"sm"_s, u"sb"_s, u"sk"_s};
        const auto rows = parseSqueezeTable("# from the other bench\nobject,k,b,m,sm,sb,sk\n"
                                            "\"A, large\",3,2,1,0.1,0,0.3\nB,30,20,10,1,2,3\n",
                                            u"t.csv"_s, columns);
        QVERIFY(rows && rows->size() == 2);
        const SqueezeRow& first = rows->front();
        QCOMPARE(first.line, 3);
        QCOMPARE(first.squeeze.type, u"A, large"_s);
        QVERIFY(!first.refused);
        QCOMPARE(first.squeeze.parameters.m, 1.0);
        QCOMPARE(first.squeeze.parameters.k, 3.0);
        QCOMPARE((*first.squeeze.covariance)(2, 2), 0.3 * 0.3);
        QCOMPARE((*first.squeeze.covariance)(1, 1), 0.0);
        QCOMPARE((*first.squeeze.covariance)(0, 1), 0.0);
    }
    void oneNameServesAllRows()
    {
        SqueezeColumns columns;
        columns.typeName = u" can "_s;
        const auto rows = parseSqueezeTable("m,b,k\n1,2,3\n", u"t.csv"_s, columns);
        QVERIFY(rows && rows->front().squeeze.type == u"can"_s && !rows->front().squeeze.covariance);
    }
    void eachBadRowIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QString>("place");
        QTest::newRow("not a number") << QByteArray("A,1,two,3") << u"t.csv:3:3"_s;
        QTest::newRow("zero") << QByteArray("A,0,2,3") << u"t.csv:3:2"_s;
        QTest::newRow("negative") << QByteArray("A,1,2,-3") << u"t.csv:3:4"_s;
        QTest::newRow("not finite") << QByteArray("A,1,2,inf") << u"t.csv:3:4"_s;
        QTest::newRow("nan") << QByteArray("A,nan,2,3") << u"t.csv:3:2"_s;
        QTest::newRow("beyond all numbers") << QByteArray("A,1e200,2,3") << u"t.csv:3:2"_s;
        QTest::newRow("no type") << QByteArray(",1,2,3") << u"t.csv:3:1"_s;
        QTest::newRow("a field short") << QByteArray("A,1,2") << u"t.csv:3:4"_s;
        QTest::newRow("a field too many") << QByteArray("A,1,2,3,4") << u"t.csv:3:5"_s;
    }
    void eachBadRowIsRefusedWithItsPlace()
    {
        QFETCH(QByteArray, row);
        QFETCH(QString, place);
        const auto rows =
            parseSqueezeTable("object,m,b,k\nA,1,2,3\n" + row + "\nB,1,2,3\n", u"t.csv"_s, columnsWithType());
        QVERIFY(rows && rows->size() == 3);
        QVERIFY(!(*rows)[0].refused && !(*rows)[2].refused);
        QVERIFY((*rows)[1].refused);
        QVERIFY2((*rows)[1].refused->describe().contains(place), qPrintable((*rows)[1].refused->describe()));
    }
    void whatSpoilsAllRowsIsAnError()
    {
        QVERIFY(!parseSqueezeTable("", u"t.csv"_s, columnsWithType()));
        QVERIFY(!parseSqueezeTable("object,m,b,k\n", u"t.csv"_s, columnsWithType()));
        QVERIFY(!parseSqueezeTable("type,m,b,k\nA,1,2,3\n", u"t.csv"_s, columnsWithType()));
        QVERIFY(!parseSqueezeTable("object,m,b,k\n\"A,1,2,3\n", u"t.csv"_s, columnsWithType()));
        const auto missing = readSqueezeTable(u"/nonexistent/t.csv"_s, columnsWithType());
        QVERIFY(!missing && missing.error().code == ErrorCode::FileUnreadable);
        const auto nameless = parseSqueezeTable("m,b,k\n1,2,3\n", u"t.csv"_s, {});
        QVERIFY(!nameless && nameless.error().code == ErrorCode::Usage);
        SqueezeColumns two = columnsWithType();
        two.parameters = {u"m"_s, u"b"_s};
        QVERIFY(!parseSqueezeTable("object,m,b,k\nA,1,2,3\n", u"t.csv"_s, two));
        two = columnsWithType();
        two.deviations = {u"m"_s};
        QVERIFY(!parseSqueezeTable("object,m,b,k\nA,1,2,3\n", u"t.csv"_s, two));
    }
};

GRIPSCOPE_TEST(SqueezeTableTest)
#include "squeeze_table_test.moc"
