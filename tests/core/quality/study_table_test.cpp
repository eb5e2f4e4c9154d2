// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/table/study_table.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class StudyTableTest : public QObject {
    Q_OBJECT
private slots:
    void namesAreCountedOnce()
    {
        const auto table = StudyTable::parse("part,value\nB,1\nA,2\nB,3.5e0\n", u"t.csv"_s);
        QVERIFY(table);
        QCOMPARE(table->rows(), std::size_t(3));
        const auto parts = table->labels(u"part"_s);
        QVERIFY(parts);
        QCOMPARE(parts->names, QStringList({u"B"_s, u"A"_s}));
        QCOMPARE(parts->index, std::vector<int>({0, 1, 0}));
        QCOMPARE(table->numbers(u"value"_s).value(), std::vector<double>({1, 2, 3.5}));
    }
    void aTableOfALibraryIsTheSame()
    {
        const StudyTable table =
            StudyTable::of(u"the batch"_s, {u"part"_s, u"k"_s}, {{u"1"_s, u"9990"_s}, {u"2"_s, u""_s}});
        QVERIFY(table.labels(u"part"_s));
        const auto none = table.numbers(u"k"_s);
        QVERIFY(!none);
        QVERIFY(none.error().describe().contains(u"the batch:3:2"_s));
    }
    void emptyCellsMayBeMissing()
    {
        const auto table = StudyTable::parse("a,b\nx,1\n,2\ny,3\n", u"t.csv"_s);
        QVERIFY(table && !table->labels(u"a"_s));
        const auto labels = table->labels(u"a"_s, StudyTable::EmptyCells::Missing);
        QVERIFY(labels);
        QCOMPARE(labels->names, QStringList({u"x"_s, u"y"_s}));
        QCOMPARE(labels->index, std::vector<int>({0, -1, 1}));
    }
    void errorsNameThePlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        QTest::newRow("missing column") << QByteArray("part,v\n1,2\n") << u"t.csv:1:1"_s;
        QTest::newRow("column twice") << QByteArray("part,value,value\n1,2,3\n") << u"t.csv:1:3"_s;
        QTest::newRow("no rows") << QByteArray("part,value\n") << u"t.csv:2:1"_s;
        QTest::newRow("a word") << QByteArray("part,value\n1,2\n1,x\n") << u"t.csv:3:2"_s;
        QTest::newRow("infinite") << QByteArray("part,value\n1,inf\n") << u"t.csv:2:2"_s;
        QTest::newRow("too few fields") << QByteArray("part,value\n1\n") << u"t.csv:2:2"_s;
        QTest::newRow("empty part") << QByteArray("part,value\n,2\n") << u"t.csv:2:1"_s;
    }
    void errorsNameThePlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        const auto table = StudyTable::parse(text, u"t.csv"_s);
        QString told = table ? QString() : table.error().describe();
        if (table) {
            const auto parts = table->labels(u"part"_s);
            const auto values = table->numbers(u"value"_s);
            told = !parts ? parts.error().describe() : values ? QString() : values.error().describe();
        }
        QVERIFY2(told.contains(place), qPrintable(told));
    }
};

GRIPSCOPE_TEST(StudyTableTest)
#include "study_table_test.moc"
