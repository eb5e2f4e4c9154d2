// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/plot_frame.h"
#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_page.h"
#include "ui/pages/calibrate/calibrate_taking.h"
#include "ui/reports/reports.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/window_bars.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTableView>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

CalibrationRecord exampleRecord()
{
    CalibrationRecord record;
    static_cast<SensorCalibration&>(record) = exampleCalibration();
    record.id = u"0190-1"_s;
    return record;
}

} // namespace

class CalibratePageTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

    /// A gripper on whose force sensor weights are hung one after the other.
    QString weights()
    {
        QFile script(m_folder.filePath(u"weights.txt"_s));
        if (!script.open(QIODevice::WriteOnly))
            qFatal("no script");
        script.write("0 load 0\n8 load 10\n16 load 20\n");
        return u"virtual:?script="_s + script.fileName();
    }
    static bool channelSays(WindowFixture& f, double load_N)
    {
        const LiveHistory& history = f.bench->live().history();
        const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 0.2, 4);
        return !stretches.empty() && !stretches.back().empty() &&
               std::abs(stretches.back().back().y - load_N) < 1 &&
               std::abs(stretches.front().front().y - load_N) < 1;
    }

private slots:
    void everyPlotCanBeSaved()
    {
        WindowFixture f(false, u"virtual:"_s);
        const QList<PlotFrame*> plots = f.page(u"calibrate"_s)->findChildren<PlotFrame*>();
        QVERIFY(plots.size() >= 3);
        for (PlotFrame* plot : plots) {
            QVERIFY2(plot->contextMenuPolicy() == Qt::CustomContextMenu, qPrintable(plot->plotName()));
            QVERIFY(!plot->fileName().isEmpty());
            QVERIFY(toSvg(*plot).contains("<svg"));
        }
    }
    void fromTheFirstWeightToACalibrationInForce()
    {
        WindowFixture f(false, weights());
        f.window->showPage(u"calibrate"_s);
        QVERIFY(!f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, 10, 20"_s);
        QTest::keyClicks(f.find<QLineEdit>("calibrationReference"), u"Weights M1"_s);
        f.find<QSpinBox>("calibrationRuns")->setValue(1);
        for (auto* box : f.page(u"calibrate"_s)->findChildren<QCheckBox*>())
            box->setChecked(false); // up only
        QTRY_VERIFY(f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.click(f.find<QPushButton>("calibrationBegin"));
        auto* points = f.find<QTableView>("calibrationPoints");
        QCOMPARE(points->model()->rowCount(), 3);
        for (const double load_N : {0.0, 10.0, 20.0}) {
            QCOMPARE(f.find<QLabel>("calibrationLoad")->text().replace(QChar(QChar::Nbsp), u' '),
                     u"%1 N"_s.arg(load_N));
            QTRY_VERIFY_WITH_TIMEOUT(channelSays(f, load_N), longEnough_ms);
            auto* steady = f.find<QLabel>("calibrationSteady");
            QTRY_VERIFY_WITH_TIMEOUT(steady->text().contains(u"rests"_s), longEnough_ms);
            QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
            const int row = int(load_N / 10);
            QTRY_VERIFY_WITH_TIMEOUT(!points->model()->index(row, 3).data().toString().isEmpty(),
                                     longEnough_ms);
            QVERIFY2(!f.find<QLabel>("calibrationWords")->isVisible(),
                     qPrintable(f.find<QLabel>("calibrationWords")->text()));
        }
        QTRY_VERIFY(f.find<QPushButton>("calibrationAccept")->isVisible());
        f.click(f.find<QPushButton>("calibrationAccept"));
        f.sayWhy(u"yearly"_s);
        auto* list = f.find<QTableView>("calibrationList");
        QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 1, longEnough_ms);
        QCOMPARE(list->model()->index(0, 5).data().toString(), u"Mai"_s);
        QVERIFY(f.bench->connection().calibration().record(SensorChannel::Force));
        auto* line = f.window->findChild<StatusLine*>();
        QTRY_VERIFY_WITH_TIMEOUT(line->text().contains(u"force cal. due in 36"_s), longEnough_ms);
        QTRY_VERIFY(f.find<QLabel>("forceCalibrationStatus")->text().startsWith(u"Holds until"_s));
    }

    void noHoleIsLeftBetweenTableAndPlot()
    {
        WindowFixture f(false, {});
        Page* page = f.page(u"calibrate"_s);
        f.window->showPage(u"calibrate"_s);
        page->prepareTour(); // one calibration, four checks
        QTRY_VERIFY_WITH_TIMEOUT(page->tourReady(), longEnough_ms);
        constexpr int frames = 12; // around the table, and the line of what has the focus
        const auto isWhole = [&f](const char* name) {
            const auto* table = f.find<QTableView>(name);
            const auto* plot = table->parentWidget()->findChild<PlotFrame*>();
            const int spare = table->viewport()->height() - table->verticalHeader()->length();
            return table->isVisible() && spare <= frames && plot->height() > table->height();
        };
        for (const QSize size : {QSize(1024, 640), QSize(1440, 900), QSize(2048, 1280)}) {
            f.window->resize(size);
            f.find<QTabBar>("calibrateTabs")->setCurrentIndex(0);
            QTRY_VERIFY(isWhole("calibrationList"));
            f.find<QTabBar>("calibrateTabs")->setCurrentIndex(1);
            QTRY_VERIFY_WITH_TIMEOUT(isWhole("checkList"), longEnough_ms);
        }
    }

    void theLastPointCanBeTakenAgainAndALoadCellIsTyped()
    {
        WindowFixture f(false, u"virtual:"_s);
        f.window->showPage(u"calibrate"_s);
        f.find<QComboBox>("calibrationChannel")->setCurrentIndex(1); // a load cell
        QTest::keyClicks(f.find<QLineEdit>("calibrationReference"), u"Load cell 7"_s);
        QTRY_VERIFY(f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.click(f.find<QPushButton>("calibrationBegin"));
        auto* shown = f.find<QDoubleSpinBox>("calibrationShown");
        QVERIFY(shown->isVisible());
        QCOMPARE(shown->value(), 0.0);
        shown->setValue(0.25);
        auto* points = f.find<QTableView>("calibrationPoints");
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!points->model()->index(0, 3).data().toString().isEmpty(), longEnough_ms);
        QCOMPARE(points->model()->index(0, 1).data().toString(), u"0.25"_s);
        QCOMPARE(shown->value(), 10.0); // the next one's
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Backspace);
        QVERIFY(points->model()->index(0, 3).data().toString().isEmpty());
        QCOMPARE(shown->value(), 0.0);
        f.click(f.find<QPushButton>("calibrationAbandon"));
    }

    void whatIsMissingIsSaid()
    {
        WindowFixture f(false);
        f.window->showPage(u"calibrate"_s);
        auto* words = f.find<QLabel>("calibrationSummary");
        QVERIFY(words->text().contains(u"realised"_s));
        f.find<QLineEdit>("calibrationReference")->setText(u"Weights"_s);
        QVERIFY(words->text().startsWith(u"21 points"_s));
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, ten"_s);
        QVERIFY(words->text().contains(u"numbers"_s));
        QVERIFY(!f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, 10, 20"_s);
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(words->text().contains(u"armed"_s), longEnough_ms);
    }

    void anOverdueCalibrationIsToldAndNamed()
    {
        WindowFixture f(false, QString());
        SensorCalibration overdue = exampleCalibration();
        overdue.gripperSerial = u"VG-1"_s;
        overdue.due = QDate::currentDate().addDays(-2);
        bool stored = false;
        f.bench->background().ask<void>(
            nullptr, [overdue](Library& library) { return library.addCalibration(overdue); },
            [&](const Expected<void>& done) { stored = done.has_value(); });
        QTRY_VERIFY_WITH_TIMEOUT(stored, longEnough_ms);
        f.connectTo(u"virtual:"_s);
        f.window->showPage(u"calibrate"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("forceCalibrationStatus")->text().startsWith(u"Overdue"_s),
                                 longEnough_ms);
    }

    void theCertificateSaysWhoWhatAndHowWell()
    {
        const CalibrationRecord record = exampleRecord();
        const QString html = certificateHtml(record, evaluateCalibration(record).value());
        for (const QString& part : {u"VG-1"_s, u"Weights M1, set 4711"_s, u"D-K-17 2026-03"_s, u"Mai"_s,
                                    u"reading ="_s, u"Expanded uncertainty"_s, u"0190-1"_s})
            QVERIFY2(html.contains(part), qPrintable(part));
        const QString file = m_folder.filePath(u"certificate.pdf"_s);
        QVERIFY(writeCertificate(record, residualPicture(record), {}, file));
        QFile pdf(file);
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        const QByteArray bytes = pdf.readAll();
        QVERIFY(bytes.startsWith("%PDF-") && bytes.trimmed().endsWith("%%EOF")); // whole
        QVERIFY(bytes.count("/Type /Page\n") >= 1);
        QVERIFY(bytes.contains("/Subtype /Image")); // the residuals
        QVERIFY(bytes.contains("/Title"));
        const auto refused = writeCertificate(record, {}, {}, u"/no/such/folder/x.pdf"_s);
        QVERIFY(!refused && refused.error().code == ErrorCode::FileUnwritable);
    }

    void theCertificateSaysWhatAnAuditorAsksFor()
    {
        CalibrationRecord record = exampleRecord();
        record.station = u"bench"_s;
        record.certificateNumber = 12;
        const CalibrationEvaluation evaluation = evaluateCalibration(record).value();
        const auto textOf = [&evaluation](const CalibrationRecord& of) {
            return certificateHtml(of, evaluation, {u"Müller & Söhne"_s, {u"20457 Hamburg"_s}, {}})
                .replace(QChar(QChar::Nbsp), u' ');
        };
        const QString html = textOf(record);
        for (const QString& part :
             {u"bench-000012"_s, u"Müller &amp; Söhne"_s, u"20457 Hamburg"_s, u"21.5 °C"_s,
              u"coverage about 95 %"_s, u"k = "_s, u"Tolerance"_s, u"± 200 mN"_s, u"guard band"_s,
              u"by the gripper's own scale"_s, u"valid until "_s + dateText(record.reference.due),
              u"Reading going up (N)"_s, u"Reading going down (N)"_s, u"signature"_s,
              zonedTimeText(record.takenUtc), u"Calibrated by Mai"_s})
            QVERIFY2(html.contains(part), qPrintable(part + u" in "_s + html));
        // 1.2 % of 50 N and 0.05 N: far beyond a fifth of a newton until it was calibrated, and within it
        // then.
        QVERIFY(html.contains(u": does not conform</td>"_s) && html.contains(u": conforms</td>"_s));
        QVERIFY(!html.contains(u"gravity"_s)); // the loads are forces
        QVERIFY(!html.contains(u"check afterwards"_s));

        record.conditions.loadUnit = LoadUnit::Kilogram;
        record.conditions.gravity = 9.8123;
        record.conditions.tolerance.reset();
        record.checkPoints = {{0, 0.05}, {10, 10.17}};
        record.foundCorrection.reset();
        record.certificateNumber = 0;
        const QString other = textOf(record);
        for (const QString& part : {u"local gravity of 9.81230 m/s²"_s, u"Mass (kg)"_s,
                                    u"no statement of conformity"_s, u"Points of the check afterwards"_s,
                                    u"not recorded"_s, u"stored before certificates had numbers"_s})
            QVERIFY2(other.contains(part), qPrintable(part + u" in "_s + other));
    }
    void massesAreTypedAndAskedForInTheirOwnUnit()
    {
        WindowFixture f(false, u"virtual:"_s);
        f.bench->settings().set(setting::gravity, 9.8123);
        f.window->showPage(u"calibrate"_s);
        auto* way = f.find<QComboBox>("calibrationChannel");
        way->setCurrentIndex(way->findText(u"Force, with masses in kilograms"_s));
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, 1, 2, 5"_s);
        f.find<QLineEdit>("calibrationReference")->setText(u"Masses F1"_s);
        auto* setup = f.window->findChild<CalibrateSetup*>();
        QSignalSpy begun(setup, &CalibrateSetup::begun);
        f.click(f.find<QPushButton>("calibrationDetails"));
        auto* dialog = f.window->findChild<QDialog*>(u"certificateDialog"_s);
        QTRY_VERIFY(dialog && dialog->isVisible());
        dialog->findChild<QCheckBox*>(u"certificateHasAmbient"_s)->setChecked(true);
        auto* ambient = dialog->findChild<QDoubleSpinBox*>(u"certificateAmbient"_s);
        ambient->setValue(200); // no temperature to calibrate at
        QCOMPARE(ambient->value(), mostAmbient_C);
        ambient->setValue(22.5);
        dialog->findChild<QCheckBox*>(u"certificateHasTolerance"_s)->setChecked(true);
        dialog->findChild<QDoubleSpinBox*>(u"certificateTolerance"_s)->setValue(0.25);
        dialog->findChild<QCheckBox*>(u"certificateCheckAfter"_s)->setChecked(true);
        dialog->accept();
        QTRY_VERIFY(f.find<QPushButton>("calibrationBegin")->isEnabled());
        f.click(f.find<QPushButton>("calibrationBegin"));
        QCOMPARE(begun.size(), 1);
        const auto plan = begun[0][0].value<CalibrationPlan>();
        QCOMPARE(plan.loads.back(), 5 * 9.8123); // newtons
        QVERIFY(plan.conditions.loadUnit == LoadUnit::Kilogram);
        QCOMPARE(plan.conditions.gravity, 9.8123);
        QCOMPARE(plan.conditions.ambient_C, std::optional(22.5));
        QVERIFY(std::abs(*plan.conditions.tolerance - 0.25) < 1e-9);
        QVERIFY(plan.checkAfter);
        QCOMPARE(f.find<QLabel>("calibrationLoad")->text(), u"0\u00A0kg"_s);
        f.click(f.find<QPushButton>("calibrationAbandon"));
    }

    void roundingOfTheComputerIsNoFigure()
    {
        const CalibrationRecord record = exampleRecord();
        CalibrationEvaluation evaluation = evaluateCalibration(record).value();
        evaluation.figures.linearityPercent = 1.4e-14;
        const std::vector<Fact> figures = CalibrationWords::figures(record, evaluation);
        QCOMPARE(figures[1].name, u"Linearity"_s);
        QCOMPARE(figures[1].text, u"< 0.001\u00A0%"_s);
    }
    void theModelsKeepTheRules()
    {
        const CalibrationRecord record = exampleRecord();
        const CalibrationEvaluation evaluation = evaluateCalibration(record).value();
        CalibrationPointsModel points;
        CalibrationListModel list;
        const QAbstractItemModelTester first(&points, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QAbstractItemModelTester second(&list, QAbstractItemModelTester::FailureReportingMode::QtTest);
        points.setPoints(u"N"_s, {{0, 1, true}, {10, 1, true}, {0, 1, false}},
                         {{{0, 1, true}, {SteadyStatus::Steady, 0.05}, {}}}, {0.001});
        QCOMPARE(points.rowCount(), 3);
        QCOMPARE(points.index(1, 2).data().toString(), u"up"_s);
        QCOMPARE(points.index(1, 5).data().toString(), u"next"_s);
        // What is left of each reading is in the unit of the plot, which shows the uncertainty, too.
        const auto title = [&points] {
            return points.headerData(int(CalibrationPointsModel::Column::Residual), Qt::Horizontal)
                .toString();
        };
        points.setPoints(u"N"_s, {{0, 1, true}}, {{{0, 1, true}, {SteadyStatus::Steady, 0.05}, {}}}, {2e-6},
                         3e-3);
        QVERIFY2(title().contains(u"mN"_s), qPrintable(title()));
        list.setRows({{record, evaluation}, {record, std::nullopt}});
        QCOMPARE(list.rowCount(), 2);
        QCOMPARE(list.index(1, 2).data().toString(), u"–"_s);
        list.setRows({});
        points.setPoints(u"N"_s, {}, {}, {});
    }
};

GRIPSCOPE_TEST(CalibratePageTest)
#include "calibrate_page_test.moc"
