// SPDX-License-Identifier: GPL-3.0-or-later
// What changes around the work (an approval, another window, gravity, another library) and what is cancelled
// in the middle of it.
#include "core/library/audit/audit_trail.h"
#include "core/library/ledger/library_witness.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/ui/inspecting.h"
#include "tests/ui/people_window.h"
#include "tests/ui/science_pages.h"
#include "ui/library/library_dialog.h"
#include "ui/pages/calibrate/calibrate_taking.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/history/history_page.h"
#include "ui/pages/history/history_parts.h"
#include "ui/settings/values/settings.h"
#include "ui/settings/values/shift_start.h"
#include "ui/shell/desktop_session.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QPointer>
#include <QSemaphore>
#include <QTimer>

#include <functional>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::PageFixture;
using gripscope::test::PeopleWindow;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

namespace {

constexpr MassDampingStiffness softCan{0.0396, 43.0, 9990};

/// Changes the type A of the library, and tells all.
void changeA(WindowFixture& f, const std::function<Expected<void>(Library&, const QString& id)>& change)
{
    bool done = false;
    f.bench->background().ask<void>(
        nullptr, [change](Library& library) { return change(library, (*library.findType(u"A"_s))->id); },
        [&done](const Expected<void>& answer) { done = answer.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(done, longEnough_ms);
    f.bench->tellLibraryChanged();
}

/// As each squeeze that comes to it does; of the types there is one less each time.
void voidApprovalOfA(WindowFixture& f)
{
    changeA(f, [](Library& library, const QString& id) -> Expected<void> {
        return library.mergeTypes(library.types()->back().id, id, {u"Mai"_s, u"a test"_s})
            .map([](const TypeRecord&) {});
    });
}

void approveA(WindowFixture& f)
{
    changeA(f, [](Library& library, const QString& id) { return library.approveType(id, u"Mai"_s); });
}

void makeWindowAnew(WindowFixture& f)
{
    f.window = std::make_unique<MainWindow>(*f.bench);
    f.window->show();
    f.makeActive();
}

constexpr int longestGate_ms = longEnough_ms; ///< a test that fails is to end all the same

/// Its library does nothing else until the gate is opened.
void keepLibraryBusy(Background& background, const std::shared_ptr<QSemaphore>& gate)
{
    background.ask<void>(
        nullptr,
        [gate](Library&) {
            (void)gate->tryAcquire(1, longestGate_ms);
            return Expected<void>();
        },
        [](const Expected<void>&) {});
}

/// The same of a thread of its pool.
void keepPoolBusy(Background& background, const std::shared_ptr<QSemaphore>& gate)
{
    background.compute<bool>(
        nullptr, [gate] { return gate->tryAcquire(1, longestGate_ms); }, [](bool) {});
}

void beginCalibration(MainWindow& window)
{
    window.showPage(u"calibrate"_s);
    auto* begin = window.findChild<QPushButton*>(u"calibrationBegin"_s);
    if (auto* reference = window.findChild<QLineEdit*>(u"calibrationReference"_s);
        reference->text().isEmpty()) {
        window.findChild<QComboBox*>(u"calibrationChannel"_s)->setCurrentIndex(1); // a load cell
        QTest::keyClicks(reference, u"Load cell 7"_s);
    }
    QTRY_VERIFY_WITH_TIMEOUT(begin->isEnabled(), longEnough_ms);
    QTest::mouseClick(begin, Qt::LeftButton);
    QVERIFY(window.currentPage()->underWay());
}

/// The program on a library in a folder of its own.
struct Program {
    QTemporaryDir folder;
    QString file = folder.filePath(u"line 1.db"_s);
    std::unique_ptr<DesktopSession> session;
    Program()
    {
        session = std::make_unique<DesktopSession>(
            DesktopSession::Start{file, folder.filePath(u"settings.ini"_s),
                                  [](Settings& settings) { settings.set(setting::stopExplained, true); }});
        session->window().show();
        if (!QTest::qWaitFor([this] { return bench().inspection().state() == InspectSession::State::Ready; },
                             longEnough_ms))
            qFatal("the library was not read");
    }
    ~Program()
    {
        session.reset();
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files))
            QFile::remove(witnessFile(folder.filePath(name)));
    }
    [[nodiscard]] Workbench& bench() const { return session->workbench(); }
    [[nodiscard]] LibraryDialog* openDialog() const
    {
        auto* dialog = new LibraryDialog(bench(), &session->window());
        dialog->open();
        return dialog;
    }
    [[nodiscard]] static QString stateOf(const LibraryDialog* dialog)
    {
        return dialog->findChild<QLabel*>(u"libraryState"_s)->text();
    }
};

} // namespace

class WorkplaceChangesTest : public QObject {
    Q_OBJECT
private slots:
    void theExpectedTypeWaitsForItsApproval();
    void aPageThatIsHiddenTakesNoFocus();
    void massesAreWeighedByTheGravityOfNow();
    void thePartsNumberIsTypedOnWhileTheVerdictComes();
    void aWindowThatWasMadeAnewAsksOnce();
    void aCalibrationIsNotLeftForAnotherLibrary();
    void aSqueezeThatIsJudgedIsNotLeftForAnotherLibrary();
    void aShiftThatBeganBehindTheLibrarysEndBeginsThere();
    void theShiftOfAnotherLibraryIsNone();
    void recordingsAreToldBeforeTheFirstIsWritten();
    void aReportThatIsCancelledBeforeItIsReadIsNoExport();
    void theWindowAnswersWhileTheWorkOfBeforeEnds_data();
    void theWindowAnswersWhileTheWorkOfBeforeEnds();
    void anEmptyFileIsNoLibrary();
    void aCalibrationBegunWhileTheUnitsWaitIsTold();
    void theIdentificationOfAFileCanBeCancelled();
};

void WorkplaceChangesTest::theExpectedTypeWaitsForItsApproval()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    voidApprovalOfA(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().expectedType(), QString(), longEnough_ms);
    QCOMPARE(armed.expected(), QString());
    approveA(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().expectedType(), u"A"_s, longEnough_ms);
    QCOMPARE(armed.expected(), u"A"_s);
    // Whoever has chosen another one meanwhile keeps that.
    voidApprovalOfA(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().expectedType(), QString(), longEnough_ms);
    expectType(f, u"B"_s);
    approveA(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().approvedTypes().size(), std::size_t(2), longEnough_ms);
    QTest::qWait(50);
    QCOMPARE(armed.expected(), u"B"_s);
}

void WorkplaceChangesTest::aPageThatIsHiddenTakesNoFocus()
{
    Armed armed;
    WindowFixture& f = armed.f;
    expectType(f, u"A"_s);
    f.window->showPage(u"enroll"_s);
    auto* field = f.find<QLineEdit>("typeName");
    field->setFocus();
    voidApprovalOfA(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().expectedType(), QString(), longEnough_ms);
    QCOMPARE(focusOf(f), static_cast<QWidget*>(field));
    f.find<QPushButton>("squeezeButton")->click();
    QVERIFY(!armed.squeezed());
    QVERIFY(f.bench->connection().armed());
}

void WorkplaceChangesTest::massesAreWeighedByTheGravityOfNow()
{
    WindowFixture f(false, u"virtual:"_s);
    f.window->showPage(u"calibrate"_s);
    auto* way = f.find<QComboBox>("calibrationChannel");
    way->setCurrentIndex(way->findText(u"Force, with masses in kilograms"_s));
    f.find<QLineEdit>("calibrationLoads")->setText(u"0, 1, 2, 5"_s);
    f.find<QLineEdit>("calibrationReference")->setText(u"Masses F1"_s);
    auto* uncertainty = f.find<QDoubleSpinBox>("calibrationUncertainty");
    uncertainty->setValue(0.002);
    f.bench->settings().set(setting::gravity, 9.8123); // a supervisor saw that it was not the local one
    QCOMPARE(f.find<QLineEdit>("calibrationLoads")->text(), u"0, 1, 2, 5"_s);
    QCOMPARE(uncertainty->value(), 0.002);
    const QSignalSpy begun(f.window->findChild<CalibrateSetup*>(), &CalibrateSetup::begun);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("calibrationBegin")->isEnabled(), longEnough_ms);
    f.click(f.find<QPushButton>("calibrationBegin"));
    QCOMPARE(begun.size(), 1);
    const auto plan = begun[0][0].value<CalibrationPlan>();
    QCOMPARE(plan.conditions.gravity, 9.8123);
    QCOMPARE(plan.loads.back(), 5 * 9.8123);
    QCOMPARE(plan.reference.standardUncertainty, 0.002 * 9.8123);
    f.click(f.find<QPushButton>("calibrationAbandon"));
}

void WorkplaceChangesTest::thePartsNumberIsTypedOnWhileTheVerdictComes()
{
    Armed armed;
    WindowFixture& f = armed.f;
    f.bench->settings().set(setting::partNumbers, true);
    auto* field = f.find<QLineEdit>("partNumberField");
    f.click(f.find<QPushButton>("squeezeButton"));
    QVERIFY(f.bench->inspection().state() == InspectSession::State::Squeezing);
    field->setFocus();
    QTest::keyClicks(field, u"4711"_s);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, qint64(1), longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("squeezeButton")->isEnabled(), longEnough_ms);
    QCOMPARE(focusOf(f), static_cast<QWidget*>(field));
    QTest::keyClicks(focusOf(f), u"-0815"_s);
    QCOMPARE(field->text(), u"4711-0815"_s);
    QCOMPARE(f.bench->inspection().partNumber(), u"4711-0815"_s);
}

void WorkplaceChangesTest::aWindowThatWasMadeAnewAsksOnce()
{
    PeopleWindow f;
    for (int i = 0; i < 2; ++i) // with other units, and then in another language
        makeWindowAnew(f);
    const auto questions = [&f] { return f.window->findChildren<SignInDialog*>().size(); };
    emit f.bench->signInNeeded(f.window.get());
    QCOMPARE(questions(), 1);
    f.typeSecret(u"Olli"_s, u"ein langes Wort"_s);
    QTRY_VERIFY_WITH_TIMEOUT(!f.dialog() && f.bench->signIn().current(), longEnough_ms);
    emit f.bench->consentNeeded(f.window.get(), Permission::ChangeSettings, [] {});
    QCOMPARE(questions(), 1);
}

void WorkplaceChangesTest::aCalibrationIsNotLeftForAnotherLibrary()
{
    const Program p;
    p.bench().setLinkLimits(gripscope::test::patientLimits());
    p.bench().connectTo(u"virtual:"_s);
    beginCalibration(p.session->window());
    LibraryDialog* dialog = p.openDialog();
    dialog->openLibrary(p.file);
    QVERIFY2(Program::stateOf(dialog).contains(u"calibration is under way"_s),
             qPrintable(Program::stateOf(dialog)));
    dialog->restoreFrom(p.file);
    QVERIFY(Program::stateOf(dialog).contains(u"calibration is under way"_s));
}

void WorkplaceChangesTest::aSqueezeThatIsJudgedIsNotLeftForAnotherLibrary()
{
    const Program p;
    LibraryDialog* dialog = p.openDialog();
    QVERIFY(p.bench().inspection().judgeRecording(simulatedSqueeze(softCan, 1), u"simulated"_s));
    QVERIFY(p.bench().inspection().state() == InspectSession::State::Judging);
    dialog->openLibrary(p.file);
    QVERIFY2(Program::stateOf(dialog).contains(u"squeeze is under way"_s),
             qPrintable(Program::stateOf(dialog)));
}

void WorkplaceChangesTest::aShiftThatBeganBehindTheLibrarysEndBeginsThere()
{
    Armed armed;
    WindowFixture& f = armed.f;
    const QString file = f.bench->library().file();
    f.bench->settings().set(setting::shiftStart, ShiftStart{file, 1000}.text()); // a backup was put back
    makeWindowAnew(f);
    f.window->showPage(u"inspect"_s);
    QTRY_COMPARE_WITH_TIMEOUT(ShiftStart::afterIn(file, f.bench->settings().get(setting::shiftStart)),
                              qint64(0), longEnough_ms);
    QCOMPARE(f.find<QLabel>("periodLabel")->text(), u"This shift"_s);
    expectType(f, u"A"_s);
    squeezeBySpace(f);
    QTRY_COMPARE_WITH_TIMEOUT(f.find<QLabel>("goodCount")->text(), u"1 of 1"_s, longEnough_ms);
}

void WorkplaceChangesTest::theShiftOfAnotherLibraryIsNone()
{
    WindowFixture f;
    const auto period = [&f](const QString& library) {
        f.bench->settings().set(setting::shiftStart, ShiftStart{library, 0}.text());
        makeWindowAnew(f);
        return f.find<QLabel>("periodLabel")->text();
    };
    QCOMPARE(period(u"/another.gripscope"_s), u"All so far"_s);
    QCOMPARE(period(f.bench->library().file()), u"This shift"_s); // it began with the library
}

void WorkplaceChangesTest::recordingsAreToldBeforeTheFirstIsWritten()
{
    const QTemporaryDir folder;
    const auto library = Library::open(folder.filePath(u"library.db"_s));
    QVERIFY(library);
    const auto entries = [&library] {
        const auto found = (*library)->auditTrail().entries({{}, {}, 100, 0});
        return found ? *found : std::vector<AuditEntry>();
    };
    const std::size_t before = entries().size();
    const SteppedWork::Step step = recordingExport({u"one"_s, u"two"_s, u"three"_s}, folder.path());
    const auto done = step(**library); // and then it is cancelled
    QVERIFY(done && done->more);
    QCOMPARE(entries().size(), before + 1);
    QCOMPARE(entries().front().action, u"export.made"_s);
    QCOMPARE(entries().front().subject, folder.path());
    QVERIFY(step(**library) && step(**library));
    QCOMPARE(entries().size(), before + 1); // once
}

void WorkplaceChangesTest::aReportThatIsCancelledBeforeItIsReadIsNoExport()
{
    PageFixture fixture;
    QVERIFY(fixture.loadExamples());
    HistoryPage page(fixture.bench);
    page.resize(1000, 600);
    page.show();
    page.setActive(true);
    const auto gate = std::make_shared<QSemaphore>();
    keepLibraryBusy(fixture.bench.background(), gate);
    page.reportTo(fixture.folder.filePath(u"report.pdf"_s));
    QTest::mouseClick(page.findChild<QPushButton*>(u"historyCancel"_s), Qt::LeftButton);
    gate->release();
    std::optional<std::vector<AuditEntry>> entries;
    fixture.bench.background().ask<std::vector<AuditEntry>>(
        nullptr,
        [](Library& library) {
            return library.auditTrail().entries({{}, {}, 100, 0});
        },
        [&entries](const Expected<std::vector<AuditEntry>>& found) { entries = found.value(); });
    QTRY_VERIFY_WITH_TIMEOUT(entries, longEnough_ms);
    for (const AuditEntry& entry : *entries)
        QVERIFY(entry.action != u"export.made"_s);
    QVERIFY(fixture.reports.isEmpty());
}

void WorkplaceChangesTest::theWindowAnswersWhileTheWorkOfBeforeEnds_data()
{
    QTest::addColumn<bool>("inPool");
    QTest::newRow("library") << false;
    QTest::newRow("pool") << true;
}

void WorkplaceChangesTest::theWindowAnswersWhileTheWorkOfBeforeEnds()
{
    QFETCH(bool, inPool);
    const Program p;
    const QString other = p.folder.filePath(u"line 2.db"_s);
    QVERIFY(Library::open(other));
    const QPointer<Workbench> before = &p.bench();
    const auto gate = std::make_shared<QSemaphore>();
    inPool ? keepPoolBusy(p.bench().background(), gate) : keepLibraryBusy(p.bench().background(), gate);
    p.bench().navigator().openLibrary(other, u"It is open."_s);
    QTest::qWait(500);
    QVERIFY(before); // it would not answer until that work has come to its end
    QVERIFY(p.session->window().isVisible());
    gate->release();
    QTRY_VERIFY_WITH_TIMEOUT(!before, longEnough_ms);
    QCOMPARE(p.bench().library().file(), other);
}

void WorkplaceChangesTest::anEmptyFileIsNoLibrary()
{
    const Program p;
    const QString empty = p.folder.filePath(u"empty.db"_s);
    QFile file(empty);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    LibraryDialog* dialog = p.openDialog();
    const QPointer<Workbench> before = &p.bench();
    dialog->openLibrary(empty);
    QTRY_VERIFY_WITH_TIMEOUT(!before || Program::stateOf(dialog).contains(u"nothing in it"_s), longEnough_ms);
    QVERIFY(before);
    QCOMPARE(QFileInfo(empty).size(), qint64(0));
}

void WorkplaceChangesTest::aCalibrationBegunWhileTheUnitsWaitIsTold()
{
    WindowFixture f(false, u"virtual:"_s);
    f.window.reset();
    f.bench->settings().set(setting::stopExplained, true);
    const WindowHost host(*f.bench);
    host.window().show();
    f.bench->setTrialRunning(true); // a squeeze
    f.bench->settings().set(setting::forceUnit, u"lbf"_s);
    QTest::qWait(100); // it waits for the end of that
    QVERIFY(!host.window().message().contains(u"Calibrate page"_s));
    beginCalibration(host.window());
    QTRY_VERIFY_WITH_TIMEOUT(host.window().message().contains(u"Calibrate page"_s), longEnough_ms);
    f.bench->settings().set(setting::forceUnit, u"N"_s);
    f.bench->setTrialRunning(false);
    QTRY_VERIFY_WITH_TIMEOUT(!host.window().message().contains(u"Calibrate page"_s), longEnough_ms);
}

void WorkplaceChangesTest::theIdentificationOfAFileCanBeCancelled()
{
    PageFixture fixture;
    const QString file = fixture.folder.filePath(u"squeeze.csv"_s);
    QVERIFY(writeRecordingCsv(simulatedSqueeze(softCan, 4), file));
    FitPage page(fixture.bench);
    page.show();
    auto* button = page.findChild<QPushButton*>(u"identifyAgain"_s);
    bool cancelled = false;
    QTimer look; // what was found is told by a later event than the one that began it
    connect(&look, &QTimer::timeout, this, [&] {
        if (button->text() != u"Cancel"_s)
            return;
        look.stop();
        cancelled = button->isEnabled();
        QTest::mouseClick(button, Qt::LeftButton);
    });
    look.start(0);
    page.openRecordings({file});
    QTRY_VERIFY_WITH_TIMEOUT(cancelled || fixture.bench.navigator().fitSubject(), longEnough_ms);
    QVERIFY(cancelled);
    QVERIFY(!button->isEnabled()); // there is nothing to identify
    QTest::qWait(1500);
    QVERIFY(!fixture.bench.navigator().fitSubject());
    page.openRecordings({file});
    QTRY_VERIFY_WITH_TIMEOUT(fixture.bench.navigator().fitSubject().has_value(), longEnough_ms);
    QCOMPARE(button->text(), u"Identify again"_s);
    QVERIFY(button->isEnabled());
}

GRIPSCOPE_TEST(WorkplaceChangesTest)
#include "workplace_changes_test.moc"
