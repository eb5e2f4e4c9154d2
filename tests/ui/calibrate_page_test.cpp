// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/models/calibration_models.h"
#include "ui/pages/calibrate/calibrate_page.h"
#include "ui/reports/reports.h"
#include "ui/shell/window_bars.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
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
        auto* list = f.find<QTableView>("calibrationList");
        QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 1, longEnough_ms);
        QCOMPARE(list->model()->index(0, 5).data().toString(), u"Mai"_s);
        QVERIFY(f.bench->connection().calibration().record(SensorChannel::Force));
        auto* line = f.window->findChild<StatusLine*>();
        QTRY_VERIFY_WITH_TIMEOUT(line->text().contains(u"force cal. due in 36"_s), longEnough_ms);
        QTRY_VERIFY(f.find<QLabel>("forceCalibrationStatus")->text().startsWith(u"Holds until"_s));
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
        QVERIFY(writeCertificate(record, residualPicture(record), file));
        QFile pdf(file);
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        const QByteArray bytes = pdf.readAll();
        QVERIFY(bytes.startsWith("%PDF-") && bytes.size() > 5000);
        const auto refused = writeCertificate(record, {}, u"/no/such/folder/x.pdf"_s);
        QVERIFY(!refused && refused.error().code == ErrorCode::FileUnwritable);
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
        list.setRows({{record, evaluation}, {record, std::nullopt}});
        QCOMPARE(list.rowCount(), 2);
        QCOMPARE(list.index(1, 2).data().toString(), u"–"_s);
        list.setRows({});
        points.setPoints(u"N"_s, {}, {}, {});
    }
};

GRIPSCOPE_TEST(CalibratePageTest)
#include "calibrate_page_test.moc"
