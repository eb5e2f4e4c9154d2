// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/science_pages.h"
#include "ui/models/history_model.h"
#include "ui/pages/history_page.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

using namespace gripscope;

class HistoryPageTest : public QObject {
    Q_OBJECT

    static void open(HistoryPage& page)
    {
        page.resize(1000, 600);
        page.show();
        page.setActive(true);
    }
    /// A page with the eight inspections that it makes for the tour, one of them of a stranger.
    static void fill(test::PageFixture& fixture, HistoryPage& page)
    {
        QVERIFY(fixture.loadExamples());
        open(page);
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady() && page.model()->rowCount() == 8, test::patience_ms);
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void anEmptyLibrarySaysWhatToDo()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        open(page);
        const auto told = [&] {
            for (const QLabel* label : page.findChildren<QLabel*>())
                if (label->isVisible() && label->text() == QStringLiteral("No inspections yet"))
                    return true;
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(told(), test::patience_ms);
    }
    void inspectionsAreListedNewestFirst()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        const QAbstractItemModelTester tester(page.model(),
                                              QAbstractItemModelTester::FailureReportingMode::QtTest);
        fill(fixture, page);
        QCOMPARE(page.model()->record(0).number, 8);
        QCOMPARE(page.model()->record(7).number, 1);
        QVERIFY(fixture.reports.isEmpty());
    }
    void filtersNarrowTheList()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        fill(fixture, page);
        auto* verdict = page.findChild<QComboBox*>();
        verdict->setCurrentIndex(verdict->findData(int(VerdictKind::Unknown)));
        QTRY_COMPARE_WITH_TIMEOUT(page.model()->rowCount(), 1, test::patience_ms);
        verdict->setCurrentIndex(0);
        QTRY_COMPARE_WITH_TIMEOUT(page.model()->rowCount(), 8, test::patience_ms);
        page.findChild<QLineEdit*>()->setText(QStringLiteral("no such type"));
        QTRY_COMPARE_WITH_TIMEOUT(page.model()->rowCount(), 0, test::patience_ms);
    }
    void enterOpensTheRecordingOnFit()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        fill(fixture, page);
        QSignalSpy requested(&fixture.bench, &Workbench::fitRequested);
        auto* table = page.findChild<QTableView*>();
        table->selectRow(2);
        QTest::keyClick(table, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(requested.size(), 1, test::patience_ms);
        QCOMPARE(fixture.bench.fitSubject()->title, QStringLiteral("Inspection 6"));
        QVERIFY(fixture.bench.fitSubject()->identification.best());
    }
    void exportWritesTheFilteredRows()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        fill(fixture, page);
        auto* verdict = page.findChild<QComboBox*>();
        verdict->setCurrentIndex(verdict->findData(int(VerdictKind::Type)));
        QTRY_COMPARE_WITH_TIMEOUT(page.model()->rowCount(), 7, test::patience_ms);
        const QString file = fixture.folder.filePath(QStringLiteral("history.csv"));
        page.exportTo(file);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), test::patience_ms);
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll().count('\n'), 8); // a header and seven rows
    }
};

GRIPSCOPE_TEST(HistoryPageTest)
#include "history_page_test.moc"
