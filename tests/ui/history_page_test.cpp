// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/many_inspections.h"
#include "tests/support/test_registry.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/overlay_plots.h"
#include "ui/charts/trend_plot.h"
#include "ui/models/history_model.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/history/history_page.h"
#include "ui/pages/history/history_parts.h"
#include "ui/pages/page_state.h"
#include "ui/pages/types/reidentify_dialog.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>

using namespace gripscope;
using namespace Qt::StringLiterals;

class HistoryPageTest : public QObject {
    Q_OBJECT

    /// A page with the forty squeezes of the paper's types and eight inspections, one of a stranger.
    struct Filled {
        Filled() : page(fixture.bench), tester(page.model())
        {
            if (!fixture.loadExamples())
                qFatal("the examples were not loaded");
            page.resize(1000, 600);
            page.show();
            page.setActive(true);
            page.prepareTour();
            if (!QTest::qWaitFor([this] { return page.tourReady() && page.model()->rowCount() == 48; },
                                 test::longEnough_ms))
                qFatal("the examples were not inspected");
        }
        [[nodiscard]] int rows() const { return page.model()->rowCount(); }
        [[nodiscard]] const HistoryEntry* at(int row) const { return page.model()->entry(row); }
        [[nodiscard]] QTableView* table() const { return page.findChild<QTableView*>(u"historyTable"_s); }
        void click(const char* button)
        {
            QTest::mouseClick(page.findChild<QPushButton*>(QString::fromLatin1(button)), Qt::LeftButton);
        }
        void choose(const char* box, const QVariant& data)
        {
            auto* chosen = page.findChild<QComboBox*>(QString::fromLatin1(box));
            chosen->setCurrentIndex(chosen->findData(data));
        }
        void clickRow(int row, Qt::KeyboardModifiers keys = {})
        {
            table()->scrollTo(page.model()->index(row, 0));
            QTest::mouseClick(table()->viewport(), Qt::LeftButton, keys,
                              table()->visualRect(page.model()->index(row, 1)).center());
        }
        /// Everything the details say, a line each.
        [[nodiscard]] QString details() const
        {
            QStringList lines;
            for (const QLabel* label : page.findChild<HistoryDetails*>()->findChildren<QLabel*>())
                lines << label->text();
            return lines.join(u'\n');
        }

        test::PageFixture fixture;
        HistoryPage page;
        QAbstractItemModelTester tester;
    };

    static QByteArray bytesOf(const QString& name)
    {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void anEmptyLibrarySaysWhatToDo()
    {
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        page.show();
        page.setActive(true);
        const auto told = [&] {
            for (const QLabel* label : page.findChildren<QLabel*>())
                if (label->isVisible() && label->text() == u"No squeezes yet"_s)
                    return true;
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(told(), test::longEnough_ms);
    }
    void squeezesAreListedNewestFirst()
    {
        Filled f;
        QCOMPARE(f.at(0)->number, 8);
        QCOMPARE(f.at(7)->number, 1);
        QVERIFY(f.at(8)->kind == SqueezeKind::Enrollment);
        QVERIFY(f.fixture.reports.isEmpty());
    }
    void severalAreLaidOverEachOther()
    {
        Filled f;
        const auto* open = f.page.findChild<QPushButton*>(u"historyOpen"_s);
        f.clickRow(0);
        QCOMPARE(open->text(), u"Open in Fit"_s);
        f.clickRow(2, Qt::ControlModifier);
        f.clickRow(3, Qt::ControlModifier);
        QCOMPARE(open->text(), u"Overlay"_s);
        f.click("historyOpen");
        auto* dialog = f.page.findChild<OverlayDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(dialog->plots()->squeezes().size(), std::size_t(3), test::longEnough_ms);
        QCOMPARE(dialog->plots()->legend().front().name, u"Inspection 8"_s);
        QCOMPARE(dialog->plots()->legend().back().name, u"Inspection 5"_s);
        for (const OverlaidSqueeze& squeeze : dialog->plots()->squeezes()) {
            QCOMPARE(squeeze.time_s->front(), 0.0);
            QCOMPARE(squeeze.force->size(), squeeze.time_s->size());
        }
        QVERIFY(f.fixture.reports.isEmpty());
    }
    void filtersNarrowTheList()
    {
        Filled f;
        f.choose("historyOutcome", int(InspectionOutcome::Unknown));
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 1, test::longEnough_ms);
        f.choose("historyOutcome", {});
        f.choose("historyKind", u"inspection"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 8, test::longEnough_ms);
        QTest::keyClicks(f.page.findChild<QLineEdit*>(u"historyText"_s), u"no such type"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 0, test::longEnough_ms);
        f.click("historyMore");
        f.click("historyClear");
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 48, test::longEnough_ms);
        f.choose("historyType", u"A"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.rows() > 9 && f.rows() < 20, test::longEnough_ms);
        QCOMPARE(f.at(0)->type, u"A"_s);
    }
    void aClickOnAHeaderSortsAndKeepsTheSelection()
    {
        Filled f;
        f.clickRow(2);
        const QString chosen = f.at(2)->graspId;
        QHeaderView* header = f.table()->horizontalHeader();
        const int column = int(HistoryModel::Column::Number);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
                          QPoint(header->sectionViewportPosition(column) + 10, header->height() / 2));
        QTRY_COMPARE_WITH_TIMEOUT(f.at(0)->number, 1, test::longEnough_ms);
        const QModelIndexList rows = f.table()->selectionModel()->selectedRows();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(f.page.model()->key(rows[0].row()), chosen);
        f.fixture.bench.tellLibraryChanged();
        QTest::qWait(200);
        QCOMPARE(f.page.model()->key(f.table()->currentIndex().row()), chosen);
    }
    void aLibraryOfManyIsListedWithoutReadingAll()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        test::addManyInspections(fixture.folder.filePath(u"library.db"_s), 25'000);
        HistoryPage page(fixture.bench);
        HistoryModel& model = *page.model();
        auto* table = page.findChild<QTableView*>(u"historyTable"_s);
        page.resize(1000, 600);
        page.show();
        page.setActive(true);
        QTRY_COMPARE_WITH_TIMEOUT(model.rowCount(), 25'040, test::longEnough_ms);
        QVERIFY(model.entry(0)->kind == SqueezeKind::Enrollment);
        QVERIFY(model.key(20'000).isEmpty()); // only what is looked at
        table->scrollTo(model.index(20'000, 0));
        model.index(20'000, 0).data();
        QTRY_COMPARE_WITH_TIMEOUT(model.key(20'000), u"g000005040"_s, test::longEnough_ms);
        table->selectRow(20'000);

        // What was chosen stays so in the next list, wherever it is there.
        QSignalSpy restarted(&model, &QAbstractItemModel::modelReset);
        fixture.bench.tellLibraryChanged();
        QTRY_COMPARE_WITH_TIMEOUT(restarted.size(), 1, test::longEnough_ms);
        QCOMPARE(table->currentIndex().row(), 20'000);
        QCOMPARE(table->selectionModel()->selectedRows().size(), 1);

        table->selectAll();
        QTest::mouseClick(page.findChild<QPushButton*>(u"historyAgain"_s), Qt::LeftButton);
        QVERIFY(!page.findChild<ReidentifyDialog*>());
        QCOMPARE(fixture.reports.size(), 1);
        QVERIFY(fixture.reports[0][0].toString().startsWith(u"More than"_s));

        table->sortByColumn(int(HistoryModel::Column::Stiffness), Qt::DescendingOrder);
        QTRY_COMPARE_WITH_TIMEOUT(model.rowCount(), int(HistoryList::mostCollected), test::longEnough_ms);
        const auto says = [&](const QString& words) {
            for (const QLabel* label : page.findChildren<QLabel*>())
                if (label->text().contains(words))
                    return true;
            return false;
        };
        QVERIFY(says(u"Sorted: only the newest"_s));
        QTest::mouseClick(page.findChild<QPushButton*>(u"historyCharts"_s), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(says(u"One inspection in 2 is drawn"_s), test::longEnough_ms);
    }
    void columnsAreChosenAndRemembered()
    {
        const int column = int(HistoryModel::Column::Fit);
        QJsonObject arrangement;
        {
            Filled f;
            QVERIFY(f.table()->isColumnHidden(column));
            for (QAction* action : f.table()->findChild<QMenu*>()->actions())
                if (action->text() == u"Simulation fit"_s)
                    action->trigger();
            QVERIFY(!f.table()->isColumnHidden(column));
            arrangement = arrangementOf(f.page);
        }
        test::PageFixture fixture;
        HistoryPage page(fixture.bench);
        restoreArrangement(page, arrangement);
        QVERIFY(!page.findChild<QTableView*>(u"historyTable"_s)->isColumnHidden(column));
    }
    void enterOpensTheRecordingOnFit()
    {
        Filled f;
        QSignalSpy requested(&f.fixture.bench.navigator(), &Navigator::pageRequested);
        f.clickRow(2);
        QTest::keyClick(f.table(), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(requested.size(), 1, test::longEnough_ms);
        QCOMPARE(f.fixture.bench.navigator().fitSubject()->title, u"Inspection 6"_s);
        QVERIFY(f.fixture.bench.navigator().fitSubject()->identification.best());
    }
    void theDetailsTellOfTheChosenSqueeze()
    {
        Filled f;
        f.clickRow(1);
        QTRY_VERIFY_WITH_TIMEOUT(f.details().startsWith(u"Inspection 7"_s), test::longEnough_ms);
        const QString told = f.details();
        for (const QString& fact : {u"output error"_s, u"simulated"_s, QStringLiteral(GRIPSCOPE_VERSION),
                                    u"Uncertainty of m, b, k comes from"_s, f.at(1)->reason.describe()})
            QVERIFY2(told.contains(fact), qPrintable(fact));
    }
    void csvAndJsonHoldAllFilteredRows()
    {
        Filled f;
        f.choose("historyKind", u"inspection"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 8, test::longEnough_ms);
        const QString csv = f.fixture.folder.filePath(u"history.csv"_s);
        f.page.exportTo(csv, HistoryFormat::Csv);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(csv), test::longEnough_ms);
        QCOMPARE(bytesOf(csv).count('\n'), 9); // a header and eight rows
        QTRY_VERIFY_WITH_TIMEOUT(f.page.findChild<QPushButton*>(u"historyExport"_s)->isEnabled(),
                                 test::longEnough_ms);
        const QString json = f.fixture.folder.filePath(u"history.json"_s);
        f.page.exportTo(json, HistoryFormat::Json);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(json), test::longEnough_ms);
        const QJsonObject document = QJsonDocument::fromJson(bytesOf(json)).object();
        QCOMPARE(document.value(u"format"_s).toString(), u"gripscope-history"_s);
        QCOMPARE(document.value(u"filter"_s).toObject().value(u"kind"_s).toString(), u"inspection"_s);
        const QJsonArray squeezes = document.value(u"squeezes"_s).toArray();
        QCOMPARE(squeezes.size(), 8);
        for (int i = 0; i < 8; ++i) {
            const QJsonObject one = squeezes[i].toObject();
            QCOMPARE(one.value(u"number"_s).toInt(), int(f.at(i)->number));
            QCOMPARE(one.value(u"type"_s).toString(), f.at(i)->type);
            QCOMPARE(one.value(u"parameters"_s).toObject().value(u"k"_s).toDouble(), f.at(i)->parameters->k);
            QCOMPARE(one.value(u"reason"_s).toString(), f.at(i)->reason.describe());
        }
    }
    void aFileThatCannotBeWrittenIsReported()
    {
        Filled f;
        f.page.exportTo(f.fixture.folder.filePath(u"none/history.csv"_s), HistoryFormat::Csv);
        QTRY_COMPARE_WITH_TIMEOUT(f.fixture.reports.size(), 1, test::longEnough_ms);
        QVERIFY(f.fixture.reports[0][0].toString().contains(u"history.csv"_s));
    }
    void recordingsOfTheSelectedRowsBecomeFiles()
    {
        Filled f;
        f.clickRow(0);
        f.clickRow(2, Qt::ShiftModifier);
        f.page.exportRecordingsTo(f.fixture.folder.path());
        const auto file = [&](int number) {
            return f.fixture.folder.filePath(u"inspection_00000%1.csv"_s.arg(number));
        };
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file(8)) && QFile::exists(file(7)) && QFile::exists(file(6)),
                                 test::longEnough_ms);
        QVERIFY(bytesOf(file(8)).startsWith("# gripscope-recording"));
        // What lies there stays: the next ones get a number.
        QTRY_VERIFY_WITH_TIMEOUT(f.fixture.told.size() == 1, test::longEnough_ms);
        QFile mine(file(8));
        QVERIFY(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
        mine.close();
        f.page.exportRecordingsTo(f.fixture.folder.path());
        const QString again = f.fixture.folder.filePath(u"inspection_000008_2.csv"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.fixture.told.size() == 2, test::longEnough_ms);
        QVERIFY(bytesOf(again).startsWith("# gripscope-recording"));
        QCOMPARE(bytesOf(file(8)), QByteArray("mine"));
    }
    void aReportIsAPdf()
    {
        Filled f;
        const QString file = f.fixture.folder.filePath(u"report.pdf"_s);
        f.page.reportTo(file);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), test::longEnough_ms);
        const QByteArray bytes = bytesOf(file);
        QVERIFY(bytes.startsWith("%PDF") && bytes.trimmed().endsWith("%%EOF")); // whole
        QVERIFY(bytes.count("/Type /Page\n") >= 1);
        QVERIFY(bytes.contains("/Subtype /Image")); // the charts
        QVERIFY(bytes.contains("/Title"));
        QTRY_COMPARE_WITH_TIMEOUT(f.fixture.told.size(), 1, test::longEnough_ms);
        QCOMPARE(f.fixture.reports.size(), 0); // no warning
    }
    void aReportCanBeCancelled()
    {
        Filled f;
        const QString file = f.fixture.folder.filePath(u"report.pdf"_s);
        f.page.reportTo(file);
        f.click("historyCancel");
        QTest::qWait(1000); // what was begun comes to its end, and leaves nothing
        QVERIFY(!QFile::exists(file));
        QVERIFY(f.fixture.reports.isEmpty());
        f.page.reportTo(file);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), test::longEnough_ms);
    }
    void aPointOfTheChartsChoosesItsRow()
    {
        Filled f;
        f.choose("historyKind", u"inspection"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.rows(), 8, test::longEnough_ms);
        f.click("historyCharts");
        f.click("historyByPlace");
        auto* view = f.page.findChild<TrendView*>();
        QTRY_VERIFY_WITH_TIMEOUT(view->content().points && view->content().points->points.size() == 8,
                                 test::longEnough_ms);
        // The oldest is the leftmost.
        const TrendPlot plot(view->content(), 0, QRectF(0, 0, view->width(), (view->height() - 18) / 3.0),
                             false);
        std::optional<QPoint> at;
        for (int x = int(plot.area().left()); x < int(plot.area().right()) && !at; ++x)
            for (int y = int(plot.area().top()); y < int(plot.area().bottom()) && !at; ++y)
                if (plot.pointAt(QPointF(x, y)) == std::size_t(0))
                    at = QPoint(x + 8, y);
        QVERIFY(at);
        QTest::mouseClick(view, Qt::LeftButton, {}, *at);
        QTRY_VERIFY_WITH_TIMEOUT(f.table()->currentIndex().isValid() && f.table()->currentIndex().row() == 7,
                                 test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(f.details().startsWith(u"Inspection 1"_s), test::longEnough_ms);
    }
    void selectedSqueezesAreIdentifiedAgainAndKept()
    {
        Filled f;
        f.fixture.bench.setOperatorName(u"Zoë"_s);
        f.clickRow(0);
        f.clickRow(1, Qt::ControlModifier);
        f.clickRow(47, Qt::ControlModifier); // of the paper: without a recording
        const auto verdict = f.at(1)->outcome();
        f.click("historyAgain");
        auto* dialog = f.page.findChild<ReidentifyDialog*>();
        QVERIFY(dialog);
        auto* estimator = dialog->findChild<QComboBox*>(u"reidentifyEstimator"_s);
        estimator->setCurrentIndex(estimator->findData(int(Estimator::Arx)));
        QTest::mouseClick(dialog->findChild<QPushButton*>(u"reidentifyStart"_s), Qt::LeftButton);
        auto* keep = dialog->findChild<QPushButton*>(u"reidentifyKeep"_s);
        QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), test::longEnough_ms);
        auto* table = dialog->findChild<QTableView*>(u"reidentifyTable"_s);
        const QAbstractItemModelTester tester(table->model());
        QCOMPARE(table->model()->rowCount(), 3);
        QVERIFY(table->model()->index(0, 1).data(Qt::EditRole).isValid());
        QVERIFY(!table->model()->index(2, 1).data(Qt::EditRole).isValid());
        const QString database = f.fixture.folder.filePath(u"library.db"_s);
        QCOMPARE(test::RawDatabase(database).count(u"reidentifications"_s), 0); // nothing until it is kept
        QTest::mouseClick(keep, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(test::RawDatabase(database).count(u"reidentifications"_s), 2,
                                  test::longEnough_ms);
        QCOMPARE(test::RawDatabase(database).run(u"SELECT operator_name FROM reidentifications"_s).toString(),
                 u"Zoë"_s);
        QVERIFY(f.at(1)->outcome() == verdict);
        QTRY_VERIFY_WITH_TIMEOUT(!keep->isEnabled(), test::longEnough_ms);
        dialog->reject();
        f.clickRow(5);
        f.clickRow(1);
        QTRY_VERIFY_WITH_TIMEOUT(f.details().contains(u"Identified again"_s), test::longEnough_ms);
    }
};

GRIPSCOPE_TEST(HistoryPageTest)
#include "history_page_test.moc"
