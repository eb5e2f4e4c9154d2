// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/painted_audit.h"
#include "ui/theme/theme.h"
#include "ui/widgets/row_list.h"

#include <QHeaderView>
#include <QStandardItemModel>
#include <QTableView>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

class RowListTest : public QObject {
    Q_OBJECT
private slots:
    /// Else the last line of a sentence ends in dots. At every width: where a word just fits, what is
    /// measured and what is painted part.
    void rowsAreAsHighAsTheirLinesWhateverTheWidth()
    {
        Theme::instance().apply(ThemeKind::Light);
        QStandardItemModel model;
        const auto item = [](const QString& text) { return new QStandardItem(text); };
        const QString sentence = u"The reading has hardly changed. Was the load put on at all?"_s;
        model.appendRow({item(u"1"_s), item(sentence)});
        QTableView table;
        table.setModel(&model);
        setUpRowList(&table, 32);
        table.horizontalHeader()->setStretchLastSection(true);
        letRowsWrap(&table);
        table.setColumnWidth(0, 60);
        table.resize(900, 400);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const int oneLine = table.rowHeight(0);
        QStringList cut;
        for (int width = 700; width > 200; --width) {
            table.resize(width, 400);
            QCoreApplication::processEvents();
            for (const QString& found : PaintedAudit::of(table))
                cut << u"%1 at %2"_s.arg(found).arg(width);
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        QVERIFY(table.rowHeight(0) > oneLine);
        table.resize(900, 400);
        QTRY_COMPARE(table.rowHeight(0), oneLine);
    }
};

GRIPSCOPE_TEST(RowListTest)

#include "row_list_test.moc"
