// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class CsvCellTest : public QObject {
    Q_OBJECT
private slots:
    void aCellIsTextOrANumberAndNeverAFormula_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("cell");
        QTest::newRow("empty") << u""_s << u""_s;
        QTest::newRow("text") << u"Zoë 3"_s << u"Zoë 3"_s;
        QTest::newRow("comma") << u"a,b"_s << u"\"a,b\""_s;
        QTest::newRow("quote") << u"a\"b"_s << u"\"a\"\"b\""_s;
        QTest::newRow("line end") << u"a\nb"_s << u"\"a\nb\""_s;
        QTest::newRow("number") << u"-1.5e-300"_s << u"-1.5e-300"_s;
        QTest::newRow("number with its sign") << u"+3"_s << u"+3"_s;
        QTest::newRow("equals") << u"=1+1"_s << u"'=1+1"_s;
        QTest::newRow("call") << u"=HYPERLINK(\"x\",\"y\")"_s << u"\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\""_s;
        QTest::newRow("plus") << u"+A1"_s << u"'+A1"_s;
        QTest::newRow("minus") << u"-2+3"_s << u"'-2+3"_s;
        QTest::newRow("at") << u"@SUM(A1)"_s << u"'@SUM(A1)"_s;
        QTest::newRow("tab") << u"\t=1"_s << u"'\t=1"_s;
        QTest::newRow("return") << u"\r=1"_s << u"\"'\r=1\""_s;
    }
    void aCellIsTextOrANumberAndNeverAFormula()
    {
        QFETCH(QString, text);
        QTEST(csvCell(text), "cell");
    }
};

GRIPSCOPE_TEST(CsvCellTest)
#include "csv_cell_test.moc"
