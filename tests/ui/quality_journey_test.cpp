// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_entry.h"
#include "tests/support/test_registry.h"
#include "tests/ui/choosing.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/people/people_dialogs.h"
#include "ui/reports/reports.h"
#include "ui/widgets/message_bar.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::choosing;

namespace {

/// Of the gripper's time: weights are hung on its force sensor.
constexpr auto weightScript = "0 load 0\n12 load 10\n24 load 20\n";

bool isPdf(const QString& name)
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) && file.read(5) == "%PDF-" && file.size() > 5000;
}

void retype(QLineEdit* field, const QString& text)
{
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
}

void clickCell(QAbstractItemView* table, int row, int column = 0)
{
    const QModelIndex index = table->model()->index(row, column);
    table->scrollTo(index);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(index).center());
}

} // namespace

/// A quality engineer prepares an audit: all by clicks and keys.
class QualityJourneyTest : public QObject {
    Q_OBJECT

    static void showPage(WindowFixture& f, const char* rail)
    {
        WindowFixture::clickWhenEnabled(f.find<QAbstractButton>(rail));
    }

    /// Whether the load that is to be hung on rests on the sensor.
    static bool rests(WindowFixture& f, double load_N)
    {
        const LiveHistory& history = f.bench->live().history();
        const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 0.2, 4);
        return !stretches.empty() && !stretches.back().empty() &&
               std::abs(stretches.back().back().y - load_N) < 1 &&
               std::abs(stretches.front().front().y - load_N) < 1 &&
               f.find<QLabel>("calibrationSteady")->text().contains(u"rests"_s);
    }

    static void calibrate(WindowFixture& f)
    {
        showPage(f, "rail-calibrate");
        retype(f.find<QLineEdit>("calibrationLoads"), u"0, 10, 20"_s);
        retype(f.find<QLineEdit>("calibrationReference"), u"Weights M1"_s);
        auto* runs = f.find<QSpinBox>("calibrationRuns");
        runs->setFocus();
        runs->selectAll();
        QTest::keyClicks(runs, u"1"_s);
        for (auto* box : f.page(u"calibrate"_s)->findChildren<QCheckBox*>())
            if (box->isVisible() && box->isChecked()) // up only
                QTest::keyClick(box, Qt::Key_Space);
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("calibrationBegin"));
        auto* points = f.find<QTableView>("calibrationPoints");
        QCOMPARE(points->model()->rowCount(), 3);
        for (int point = 0; point < 3; ++point) {
            QTRY_VERIFY_WITH_TIMEOUT(rests(f, 10.0 * point), longEnough_ms);
            QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
            QTRY_VERIFY_WITH_TIMEOUT(!points->model()->index(point, 3).data().toString().isEmpty(),
                                     longEnough_ms);
        }
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("calibrationAccept"));
        f.sayWhy();
        QTRY_COMPARE_WITH_TIMEOUT(f.find<QTableView>("calibrationList")->model()->rowCount(), 1,
                                  longEnough_ms);
    }

    static void makeCertificate(WindowFixture& f, const QString& file)
    {
        clickCell(f.find<QTableView>("calibrationList"), 0);
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("certificateButton"));
        chooseFile(f.window.get(), file);
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(file), longEnough_ms);
        const auto* bar = f.window->findChild<MessageBar*>();
        const QString told = u"Certificate written to "_s + file;
        QTRY_VERIFY2_WITH_TIMEOUT(bar->messages().contains(told), qPrintable(bar->message()), longEnough_ms);
        QVERIFY(bar->isGood(told));
    }

    static void giveReason(WindowFixture& f, const QString& reason)
    {
        auto* form = f.window->findChild<TypeChangeForm*>();
        QVERIFY(form);
        auto* accept = child<QPushButton>(form, u"changeAccept"_s);
        QVERIFY(!accept->isEnabled()); // not without one
        retype(child<QLineEdit>(form, u"reasonField"_s), reason);
        WindowFixture::clickWhenEnabled(accept);
        QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<TypeChangeForm*>(), longEnough_ms);
    }

    static void changeATypeAndRollBack(WindowFixture& f)
    {
        showPage(f, "rail-types");
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("manageTypesButton"));
        auto* types = f.find<QTableWidget>("typesTable");
        QTRY_COMPARE_WITH_TIMEOUT(types->rowCount(), 4, longEnough_ms);
        clickCell(types, 0);
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("renameButton"));
        QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<TypeChangeForm*>(), longEnough_ms);
        retype(child<QLineEdit>(f.window->findChild<TypeChangeForm*>(), u"nameField"_s), u"Cola"_s);
        giveReason(f, u"its name on the shelf"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!types->findItems(u"Cola"_s, Qt::MatchExactly).isEmpty(), longEnough_ms);

        auto* dialog = f.window->findChild<EnrolledTypesDialog*>();
        auto* tabs = dialog->findChild<QTabWidget*>()->tabBar();
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
        auto* versions = f.find<QTableWidget>("versionsTable");
        QTRY_VERIFY(versions->isVisible());
        clickCell(versions, 1); // as it was before the last change
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("restoreButton"));
        QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<TypeChangeForm*>(), longEnough_ms);
        giveReason(f, u"the customer calls it A"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!types->findItems(u"A"_s, Qt::MatchExactly).isEmpty(), longEnough_ms);
        QVERIFY(types->findItems(u"Cola"_s, Qt::MatchExactly).isEmpty());
        for (auto* button : dialog->findChildren<QPushButton*>())
            if (button->text() == u"Close"_s)
                WindowFixture::clickWhenEnabled(button);
        QTRY_VERIFY_WITH_TIMEOUT(!f.window->findChild<EnrolledTypesDialog*>(), longEnough_ms);
    }

    static void makeReport(WindowFixture& f, const QString& file)
    {
        f.makeActive();
        showPage(f, "rail-history");
        auto* button = f.find<QPushButton>("historyExport");
        QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), longEnough_ms);
        chooseInMenu(button, button->menu(),
                     [](const QAction* entry) { return entry->text() == u"Report as PDF…"_s; });
        chooseFile(f.window.get(), file);
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(file), longEnough_ms);
    }

    static void verifyFromTheTrail(WindowFixture& f)
    {
        chooseInMenu(f.find<QPushButton>("operatorChip"), f.find<QMenu>("operatorMenu"),
                     [](const QAction* entry) { return entry->objectName() == u"auditAction"_s; });
        QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<AuditDialog*>(), longEnough_ms);
        WindowFixture::clickWhenEnabled(f.find<QPushButton>("auditVerify"));
        auto* result = f.find<QLabel>("auditResult");
        QTRY_VERIFY_WITH_TIMEOUT(result->text().contains(u" rows are as they were written"_s), longEnough_ms);
        QVERIFY2(result->text().contains(u"knows the same end"_s), qPrintable(result->text()));
        auto* text = f.find<QLineEdit>("auditText"); // what an auditor asks for is found by a word
        retype(text, u"shelf"_s);
        QTRY_COMPARE_WITH_TIMEOUT(f.find<QTableView>("auditTable")->model()->rowCount(), 1, longEnough_ms);
    }

    /// The words of both papers, of what the journey left in the library.
    static std::pair<QString, QString> papers(WindowFixture& f)
    {
        using Papers = std::pair<CalibrationRecord, HistoryReport>;
        std::optional<Papers> found;
        const QString serial = f.bench->connection().identity().serial;
        f.bench->background().ask<Papers>(
            nullptr,
            [serial](Library& library) -> Expected<Papers> {
                ASSIGN_OR_RETURN(const auto calibrations, library.calibrations(serial, 1));
                ASSIGN_OR_RETURN(HistoryReport report, readHistoryReport(library, {}));
                return Papers{calibrations.at(0), std::move(report)};
            },
            [&found](Expected<Papers> read) { found = std::move(read.value()); });
        if (!QTest::qWaitFor([&] { return found.has_value(); }, longEnough_ms))
            qFatal("the library did not answer");
        return {certificateHtml(found->first, evaluateCalibration(found->first).value()),
                historyReportHtml(found->second)};
    }

    static std::vector<AuditEntry> trail(WindowFixture& f)
    {
        using Entries = std::vector<AuditEntry>;
        std::optional<Entries> found;
        f.bench->background().ask<Entries>(
            nullptr,
            [](Library& library) {
                return library.auditTrail().entries({{}, {}, 100, 0});
            },
            [&found](Expected<Entries> entries) { found = entries.value(); });
        if (!QTest::qWaitFor([&] { return found.has_value(); }, longEnough_ms))
            qFatal("the library did not answer");
        return *found;
    }

private slots:
    void anAuditIsPrepared()
    {
        const QTemporaryDir folder;
        QFile script(folder.filePath(u"weights.txt"_s));
        QVERIFY(script.open(QIODevice::WriteOnly) && script.write(weightScript) > 0);
        script.close();
        const QString certificate = folder.filePath(u"certificate.pdf"_s);
        const QString report = folder.filePath(u"report.pdf"_s);
        WindowFixture f(true, u"virtual:?script="_s + script.fileName());
        const auto step = [](auto&& work) {
            work();
            return !QTest::currentTestFailed();
        };
        if (!step([&] { calibrate(f); }) || !step([&] { makeCertificate(f, certificate); }) ||
            !step([&] { changeATypeAndRollBack(f); }) || !step([&] { makeReport(f, report); }) ||
            !step([&] { verifyFromTheTrail(f); }))
            return;

        // What an auditor finds afterwards: each thing once, by whom, with its reason.
        const std::vector<AuditEntry> entries = trail(f);
        const auto theOne = [&entries](const QString& action, const QString& subject = {}) {
            std::vector<AuditEntry> found;
            std::copy_if(entries.begin(), entries.end(), std::back_inserter(found),
                         [&](const AuditEntry& entry) {
                             return entry.action == action && (subject.isEmpty() || entry.subject == subject);
                         });
            return found.size() == 1 ? found.front() : AuditEntry();
        };
        for (const QString& action : {u"calibration.accepted"_s, u"type.rename"_s, u"type.restore"_s}) {
            QVERIFY2(theOne(action).number > 0, qPrintable(action));
            QCOMPARE(theOne(action).person, u"Mai"_s);
        }
        QCOMPARE(theOne(u"type.rename"_s).reason, u"its name on the shelf"_s);
        QCOMPARE(theOne(u"type.restore"_s).reason, u"the customer calls it A"_s);
        for (const QString& file : {certificate, report}) {
            QVERIFY2(theOne(u"export.made"_s, file).number > 0, qPrintable(file));
            QCOMPARE(theOne(u"export.made"_s, file).person, u"Mai"_s);
        }
        QVERIFY(theOne(u"type.rename"_s).number < theOne(u"type.restore"_s).number);
        const auto found = verifyLibrary(f.bench->library().file());
        QVERIFY(found && found->whole());
        QVERIFY(found->witness == WitnessState::Matched);
        QVERIFY(isPdf(certificate) && isPdf(report));
        const auto [certified, reported] = papers(f);
        for (const QString& words : {u"Calibration certificate"_s, u"Certificate number"_s, u"Weights M1"_s,
                                     u"k = "_s, u"As found"_s, u"As left"_s, u"asked for by quality"_s,
                                     f.bench->connection().identity().serial})
            QVERIFY2(certified.contains(words), qPrintable(words));
        QVERIFY(!certified.contains(u"none: it was stored before"_s)); // it has a number
        for (const QString& words : {u"Report of squeezes"_s, u"Counts"_s, u"Inspected"_s, u"Enrolled"_s})
            QVERIFY2(reported.contains(words), qPrintable(words));
    }
};

GRIPSCOPE_TEST(QualityJourneyTest)
#include "quality_journey_test.moc"
