// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"
#include "tests/ui/charting.h"
#include "ui/charts/control_plot.h"
#include "ui/charts/histogram_plot.h"
#include "ui/pages/history/history_page.h"
#include "ui/pages/quality/process/process_view.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QThread>

#include <atomic>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::charting;
using ProcessState = ProcessSession::State;

/// Control charts and capability on the Quality page.
class ProcessViewTest : public QObject {
    Q_OBJECT
private slots:
    void aLibraryWithoutTypesSaysWhatToDo()
    {
        WindowFixture f(false, {});
        openProcess(f);
        auto* empty = f.find<QLabel>("processEmpty");
        QTRY_VERIFY_WITH_TIMEOUT(empty->text().contains(u"No type is enrolled yet"_s), longEnough_ms);
        QVERIFY(!f.find<QPushButton>("processReport")->isEnabled());
        f.clickWhenEnabled(f.find<QPushButton>("processBack"));
        QTRY_VERIFY(f.find<QPushButton>("openProcess")->isVisible());
    }
    void aTypeWithoutInspectionsSaysSo()
    {
        WindowFixture f(true, {});
        openProcess(f);
        auto* empty = f.find<QLabel>("processEmpty");
        QTRY_VERIFY_WITH_TIMEOUT(empty->text().contains(u"No inspection has recognised"_s), longEnough_ms);
    }
    void oneInspectionIsTooFew()
    {
        WindowFixture f(true, {});
        storeParts(f, 1);
        openProcess(f);
        waitFor(f, 1);
        QVERIFY2(f.find<QLabel>("processMissing")->text().contains(u"a chart needs at least 2"_s),
                 qPrintable(f.find<QLabel>("processMissing")->text()));
    }
    void whatIsNotDeterminedIsTold()
    {
        WindowFixture f(true, {});
        storeParts(f, 30);
        RawDatabase(f.bench->library().file()).run(u"UPDATE estimates SET m = NULL"_s);
        openProcess(f);
        waitFor(f, 30);
        QVERIFY2(f.find<QLabel>("processMissing")->text().contains(u"m was not determined"_s),
                 qPrintable(f.find<QLabel>("processMissing")->text()));
        QCOMPARE(f.find<ControlView>("processCharts")->panels().size(), std::size_t(2)); // b and k
    }
    void chartsSignalsAndRunLengthsAreShown()
    {
        WindowFixture f(true, {});
        storeParts(f, 60, 10);
        openProcess(f);
        waitFor(f, 60);
        QCOMPARE(f.find<ControlView>("processCharts")->panels().size(), std::size_t(3));
        auto* table = f.find<QTableWidget>("processSignals");
        QVERIFY(table->rowCount() > 0);
        QVERIFY(f.find<QLabel>("processVerdict")->text().startsWith(u"Not steady"_s));
        QVERIFY(f.find<QLabel>("processRunLengths")->text().contains(u"one point in 92"_s) ||
                f.find<QLabel>("processRunLengths")->text().contains(u"one point in 91.8"_s));
        choose(f, "processRules", u"Limits only"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("processRunLengths")->text().contains(u"one point in 370"_s),
                                 longEnough_ms);
        choose(f, "processQuantity", u"Stiffness k"_s);
        QTRY_COMPARE(f.find<ControlView>("processCharts")->panels().size(), std::size_t(2)); // and its ranges
    }
    void everyKindCanBeChosen()
    {
        WindowFixture f(true, {});
        storeParts(f, 60);
        openProcess(f);
        waitFor(f, 60);
        auto* kinds = f.find<QComboBox>("processKind");
        for (int i = 1; i < kinds->count(); ++i) {
            choose(f, "processKind", kinds->itemText(i));
            QTRY_VERIFY_WITH_TIMEOUT(view(f).session().state() == ProcessState::Shown &&
                                         int(view(f).session().picture()->options.kind) == i,
                                     longEnough_ms);
            QVERIFY(!f.find<ControlView>("processCharts")->panels().empty());
        }
        QVERIFY(!f.find<QComboBox>("processQuantity")->isEnabled()); // T^2 has all three
    }
    void filtersNarrowAndAreCounted()
    {
        WindowFixture f(true, {});
        storeParts(f, 60);
        openProcess(f);
        waitFor(f, 60);
        f.clickWhenEnabled(f.find<QPushButton>("processFilters"));
        QTRY_VERIFY(f.find<QComboBox>("processOperator")->isVisible());
        choose(f, "processOperator", u"Ada"_s);
        waitFor(f, 30);
        QVERIFY(f.find<QPushButton>("processFilters")->text().contains(u'1'));
        choose(f, "processGripper", u"Gripper 0001"_s);
        waitFor(f, 10);
        choose(f, "processPeriod", u"From … to …"_s);
        waitFor(f, 0);
        QVERIFY(f.find<QLabel>("processEmpty")->text().contains(u"No inspection matches"_s));
    }
    void limitsAreFixedFromWhatIsInView()
    {
        WindowFixture f(true, {});
        storeParts(f, 60, 10);
        openProcess(f);
        waitFor(f, 60);
        auto* charts = f.find<ControlView>("processCharts");
        const ControlPlot plot = charts->plot(0);
        const auto at = [&](std::size_t point) {
            return QPoint(int(plot.position(point).x()), int(plot.area().center().y()));
        };
        QTest::mousePress(charts, Qt::LeftButton, {}, at(0));
        QTest::mouseMove(charts, at(25));
        QTest::mouseRelease(charts, Qt::LeftButton, {}, at(49));
        const auto numbers = charts->numbersInView();
        QVERIFY(numbers && numbers->first <= 2 && numbers->second >= 48 && numbers->second <= 51);
        f.clickWhenEnabled(f.find<QPushButton>("processFix"));
        auto* limits = f.find<QLabel>("processLimits");
        QTRY_VERIFY_WITH_TIMEOUT(
            limits->text().contains(u"Limits fixed"_s) && limits->text().contains(u"Mai"_s), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(view(f).session().picture()->options.fixed.has_value(), longEnough_ms);
        f.clickWhenEnabled(f.find<QPushButton>("processRelease"));
        QTRY_VERIFY_WITH_TIMEOUT(limits->text().contains(u"from the inspections shown"_s), longEnough_ms);
    }
    void capabilityGoesByTypedLimits()
    {
        WindowFixture f(true, {});
        storeParts(f, 60);
        openProcess(f);
        waitFor(f, 60);
        auto* words = f.find<QLabel>("processCapability");
        QVERIFY(words->text().contains(u"No tolerance limits"_s));
        auto* upper = f.find<QLineEdit>("processUpper");
        upper->setFocus();
        QTest::keyClicks(upper, u"abc"_s);
        QTest::keyClick(upper, Qt::Key_Return);
        QTRY_VERIFY(f.find<QLabel>("processLimitProblem")->isVisible());
        upper->selectAll();
        QTest::keyClicks(upper, u"10.1"_s); // kN/m
        QTest::keyClick(upper, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(words->text().contains(u"ppm"_s), longEnough_ms);
        QCOMPARE(view(f).session().picture()->options.limits[2]->upper, std::optional(10100.0));
        QVERIFY(f.find<HistogramPlot>("processHistogram")->capability()->limits);
    }
    void aPointLeadsToItsInspection()
    {
        WindowFixture f(true, {});
        storeParts(f, 60);
        openProcess(f);
        waitFor(f, 60);
        auto* charts = f.find<ControlView>("processCharts");
        QTest::mouseClick(charts, Qt::LeftButton, {}, charts->plot(2).position(16).toPoint());
        Page* history = f.page(u"history"_s);
        QTRY_VERIFY_WITH_TIMEOUT(history->isVisible(), longEnough_ms);
        auto* table = history->findChild<QTableView*>();
        QTRY_VERIFY_WITH_TIMEOUT(
            table->currentIndex().isValid() &&
                table->model()->index(table->currentIndex().row(), 0).data().toString() == u"17"_s,
            longEnough_ms);
    }
    void whatIsInspectedJoinsByItself()
    {
        WindowFixture f(true, {});
        storeParts(f, 30);
        openProcess(f);
        waitFor(f, 30);
        storeParts(f, 3);
        waitFor(f, 33);
    }
    void tableAndReportAreWritten()
    {
        WindowFixture f(true, {});
        storeParts(f, 60, 10);
        openProcess(f);
        waitFor(f, 60);
        QTemporaryDir folder;
        const QString csv = folder.filePath(u"chart.csv"_s), pdf = folder.filePath(u"chart.pdf"_s);
        view(f).writeCsv(csv);
        view(f).writeReport(pdf);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(csv) && QFile::exists(pdf), longEnough_ms);
        QFile table(csv);
        QVERIFY(table.open(QIODevice::ReadOnly));
        QCOMPARE(table.readAll().trimmed().count('\n'), 60); // a header and 60 points
    }
    void readingIsCancelledAtOnce()
    {
        WindowFixture f(true, {});
        storeParts(f, 30);
        // The library is busy: what is asked for next waits until it is let go.
        std::atomic<bool> letGo{false};
        f.bench->background().ask<void>(
            nullptr,
            [&letGo](Library&) -> Expected<void> {
                while (!letGo)
                    QThread::msleep(2);
                return {};
            },
            [](const Expected<void>&) {});
        f.window->showPage(u"quality"_s);
        letGo = true;
        openProcess(f);
        waitFor(f, 30);
        letGo = false;
        f.bench->background().ask<void>(
            nullptr,
            [&letGo](Library&) -> Expected<void> {
                while (!letGo)
                    QThread::msleep(2);
                return {};
            },
            [](const Expected<void>&) {});
        choose(f, "processType", u"B"_s);
        auto* cancel = f.find<QPushButton>("processCancel");
        QTRY_VERIFY(cancel->isVisible());
        QVERIFY(f.find<QProgressBar>("processProgress")->isVisible());
        f.click(cancel);
        QCOMPARE(view(f).session().state(), ProcessState::Cancelled);
        QVERIFY(f.find<QPushButton>("processAgain")->isVisible());
        letGo = true;
        f.clickWhenEnabled(f.find<QPushButton>("processAgain"));
        QTRY_VERIFY_WITH_TIMEOUT(view(f).session().state() == ProcessState::Shown, longEnough_ms);
    }
};

GRIPSCOPE_TEST(ProcessViewTest)
#include "process_view_test.moc"
