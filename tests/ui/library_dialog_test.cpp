// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/library_backup.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/merge/library_merge.h"
#include "tests/support/patient_limits.h"
#include "tests/support/test_registry.h"
#include "tests/ui/choosing.h"
#include "tests/ui/people_window.h"
#include "ui/library/library_dialog.h"
#include "ui/library/recent_libraries.h"
#include "ui/library/station_conflicts.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/widgets/message_bar.h"

#include <QDir>
#include <QFileDialog>
#include <QListWidget>
#include <QMenu>
#include <QPointer>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::choosing;

namespace {

/// The program on a library in a folder of its own, and its dialog of the library.
struct Session {
    QTemporaryDir folder;
    QString file = folder.filePath(u"line 1.db"_s);
    std::unique_ptr<DesktopSession> session;
    Session()
    {
        session = std::make_unique<DesktopSession>(
            DesktopSession::Start{file, folder.filePath(u"settings.ini"_s),
                                  [](Settings& settings) { settings.set(setting::stopExplained, true); }});
        window().show();
        if (!QTest::qWaitForWindowActive(&window(), longEnough_ms))
            window().activateWindow();
        bench().setOperatorName(u"Mai"_s);
        addBatch(1);
    }
    ~Session()
    {
        const QString library = bench().library().file();
        session.reset();
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files))
            QFile::remove(witnessFile(folder.filePath(name)));
        QFile::remove(witnessFile(library));
    }
    [[nodiscard]] MainWindow& window() const { return session->window(); }
    [[nodiscard]] Workbench& bench() const { return session->workbench(); }
    template <typename T>
    T answer(std::function<Expected<T>(Library&)> work) const
    {
        std::optional<Expected<T>> got;
        bench().background().ask<T>(nullptr, std::move(work),
                                    [&got](Expected<T> value) { got = std::move(value); });
        if (!QTest::qWaitFor([&got] { return got.has_value(); }, longEnough_ms) || !*got)
            qFatal("the library did not answer");
        if constexpr (!std::is_void_v<T>)
            return std::move(**got);
    }
    /// A type more in the library.
    void addBatch(int number) const
    {
        answer<void>([number](Library& library) {
            return library.addType(u"Type %1"_s.arg(number), {}, u"N"_s, u"m"_s).map([](const TypeRecord&) {
            });
        });
    }
    [[nodiscard]] std::size_t types() const
    {
        return answer<std::vector<TypeRecord>>([](Library& library) { return library.types(); }).size();
    }
    [[nodiscard]] QStringList actions() const
    {
        QStringList all;
        for (const AuditEntry& entry : answer<std::vector<AuditEntry>>([](Library& library) {
                 return library.auditTrail().entries({{}, {}, 100, 0});
             }))
            all += entry.action;
        return all;
    }
    /// By the header's menu, as a person does.
    [[nodiscard]] LibraryDialog* openDialog() const
    {
        chooseInMenu(child<QPushButton>(&window(), u"operatorChip"_s),
                     child<QMenu>(&window(), u"operatorMenu"_s),
                     [](const QAction* entry) { return entry->objectName() == u"libraryAction"_s; });
        auto* dialog = window().findChild<LibraryDialog*>();
        if (!dialog)
            qFatal("the dialog did not open");
        return dialog;
    }
    /// In the message bar, whatever else is there.
    [[nodiscard]] bool told(const QString& words) const
    {
        return !window().findChild<MessageBar*>()->messages().filter(words).isEmpty();
    }
    static void click(QWidget* over, const QString& name)
    {
        QTest::mouseClick(child<QPushButton>(over, name), Qt::LeftButton);
    }
};

QString stateOf(const LibraryDialog* dialog)
{
    return dialog->findChild<QLabel*>(u"libraryState"_s)->text();
}

} // namespace

/// Another library, a backup, and the way back, in the window.
class LibraryDialogTest : public QObject {
    Q_OBJECT
private slots:
    void whatStationsDecidedApartIsToldUntilItIsSeen()
    {
        const Session s;
        const QString other = s.folder.filePath(u"other.db"_s);
        {
            const auto there = Library::open(other);
            QVERIFY(there && (*there)->addType(u"Type 1"_s, {}, u"N"_s, u"m"_s));
        }
        s.answer<void>([other](Library& library) {
            return library.mergeLibrary(other, {u"Mai"_s, u"one plant"_s}).map([](const MergeReport&) {});
        });
        LibraryDialog* dialog = s.openDialog();
        auto* conflicts = dialog->findChild<StationConflicts*>();
        QTRY_VERIFY_WITH_TIMEOUT(conflicts->isVisible(), longEnough_ms);
        QVERIFY(conflicts->findChild<QLabel*>(u"stationConflictsText"_s)->text().contains(u"Type 1"_s));
        conflicts->findChild<QPushButton*>(u"stationConflictsSeen"_s)->click();
        QTRY_VERIFY_WITH_TIMEOUT(!conflicts->isVisible(), longEnough_ms);
        QVERIFY(s.actions().contains(QString::fromUtf16(audit_action::conflictsSeen)));
    }
    void aBackupIsWrittenVerifiedAndTold()
    {
        const Session s;
        LibraryDialog* dialog = s.openDialog();
        QTRY_VERIFY_WITH_TIMEOUT(
            child<QLabel>(dialog, u"libraryContents"_s)->text().startsWith(u"Types: 1"_s), longEnough_ms);
        const QString copy = s.folder.filePath(u"copy.db"_s);
        Session::click(dialog, u"libraryBackUp"_s);
        chooseFile(dialog, copy);
        QTRY_VERIFY_WITH_TIMEOUT(stateOf(dialog).contains(u"written and verified"_s), longEnough_ms);
        QVERIFY(typesIn(copy) == 1);
        QTRY_VERIFY_WITH_TIMEOUT(s.actions().contains(u"library.backed_up"_s), longEnough_ms);
        dialog->backUpTo(copy); // a second time
        QTRY_VERIFY_WITH_TIMEOUT(stateOf(dialog).contains(u"already"_s), longEnough_ms);
    }
    void anotherLibraryIsOpenedAndTheOneBeforeIsOneClickAway()
    {
        const Session s;
        const QString other = s.folder.filePath(u"line 2.db"_s);
        QVERIFY(Library::open(other));
        s.bench().setLinkLimits(patientLimits());
        s.bench().connectTo(unhurriedA);
        QTRY_VERIFY_WITH_TIMEOUT(s.bench().connection().state() == ConnectSession::State::Connected,
                                 longEnough_ms);
        const QPointer<Workbench> before = &s.bench();
        LibraryDialog* dialog = s.openDialog();
        Session::click(dialog, u"libraryOpen"_s);
        chooseFile(dialog, other);
        QTRY_VERIFY_WITH_TIMEOUT(!before, longEnough_ms);
        QCOMPARE(s.bench().library().file(), other);
        QVERIFY(s.window().isVisible());
        QCOMPARE(s.types(), std::size_t(0));
        QTRY_VERIFY_WITH_TIMEOUT(s.bench().connection().state() == ConnectSession::State::Connected,
                                 longEnough_ms);
        QVERIFY(!s.bench().connection().armed());
        QVERIFY(s.told(u"line 2.db"_s));

        dialog = s.openDialog();
        auto* recent = child<QListWidget>(dialog, u"recentLibraries"_s);
        QCOMPARE(recent->count(), 1);
        recent->setCurrentRow(0);
        recent->setFocus();
        QTest::keyClick(recent, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(s.bench().library().file(), s.file, longEnough_ms);
        QCOMPARE(s.types(), std::size_t(1));
    }
    void whatIsNoLibraryIsNotOpened()
    {
        const Session s;
        const QString text = s.folder.filePath(u"letter.db"_s);
        QFile file(text);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("a letter to somebody") > 0);
        file.close();
        LibraryDialog* dialog = s.openDialog();
        dialog->openLibrary(text);
        QTRY_VERIFY_WITH_TIMEOUT(stateOf(dialog).contains(u"another kind"_s), longEnough_ms);
        dialog->openLibrary(s.folder.filePath(u"none.db"_s));
        QTRY_VERIFY_WITH_TIMEOUT(stateOf(dialog).contains(u"no such file"_s), longEnough_ms);
        QVERIFY(!QFile::exists(s.folder.filePath(u"none.db"_s)));
        s.bench().setTrialRunning(true);
        dialog->openLibrary(s.file);
        QVERIFY(stateOf(dialog).contains(u"squeeze is under way"_s));
        s.bench().setTrialRunning(false);
    }
    void aBackupIsPutBackWithAReasonAndTheTrailSaysSo()
    {
        const Session s;
        const QString copy = s.folder.filePath(u"copy.db"_s);
        QVERIFY(backUpLibrary(s.file, copy, [](double) { return true; }));
        s.addBatch(2);
        const QPointer<Workbench> before = &s.bench();
        LibraryDialog* dialog = s.openDialog();
        Session::click(dialog, u"libraryRestore"_s);
        chooseFile(dialog, copy);
        QTRY_VERIFY_WITH_TIMEOUT(s.window().findChild<RestoreDialog*>(), longEnough_ms);
        auto* restore = s.window().findChild<RestoreDialog*>();
        QVERIFY(child<QLabel>(restore, u"restoreConsequence"_s)->text().contains(u"types: 1"_s));
        auto* accept = child<QPushButton>(restore, u"restoreAccept"_s);
        QVERIFY(!accept->isEnabled()); // not without a reason
        QTest::keyClicks(child<QLineEdit>(restore, u"restoreReason"_s), u"a wrong type"_s);
        QVERIFY(accept->isEnabled());
        QTest::mouseClick(accept, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!before, longEnough_ms);
        QCOMPARE(s.bench().library().file(), s.file);
        QCOMPARE(s.types(), std::size_t(1));
        QVERIFY(s.told(u"is kept as"_s));
        QVERIFY(s.actions().startsWith(u"library.restored"_s));
        const auto found = verifyLibrary(s.file);
        QVERIFY(found && found->whole() && found->restores.size() == 1);
        QCOMPARE(found->restores[0].reason, u"a wrong type"_s);
        QCOMPARE(found->restores[0].person, u"Mai"_s);
    }
    void aDamagedBackupIsRefusedInWords()
    {
        const Session s;
        const QString copy = s.folder.filePath(u"copy.db"_s);
        QVERIFY(backUpLibrary(s.file, copy, [](double) { return true; }));
        QVERIFY(QFile::resize(copy, QFile(copy).size() / 2));
        LibraryDialog* dialog = s.openDialog();
        dialog->restoreFrom(copy);
        QTRY_VERIFY_WITH_TIMEOUT(stateOf(dialog).contains(u"damaged"_s), longEnough_ms);
        QVERIFY(!s.window().findChild<RestoreDialog*>());
        QCOMPARE(s.types(), std::size_t(1));
    }
    void anOperatorNeedsASupervisorToPutABackupBack()
    {
        const PeopleWindow f;
        f.signInOlli();
        const QTemporaryDir folder;
        const QString copy = folder.filePath(u"copy.db"_s);
        const QString library = f.bench->library().file();
        QVERIFY(backUpLibrary(library, copy, [](double) { return true; }));
        auto* dialog = new LibraryDialog(*f.bench, f.window.get());
        dialog->open();
        dialog->restoreFrom(copy);
        QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<RestoreDialog*>(), longEnough_ms);
        auto* restore = f.window->findChild<RestoreDialog*>();
        QTest::keyClicks(child<QLineEdit>(restore, u"restoreReason"_s), u"a trial"_s);
        QTest::mouseClick(child<QPushButton>(restore, u"restoreAccept"_s), Qt::LeftButton);
        f.authorise();
        QTRY_COMPARE_WITH_TIMEOUT(f.newestEntry().action, u"library.restored"_s, longEnough_ms);
        QCOMPARE(f.newestEntry().person, u"Sam"_s);
        QCOMPARE(f.newestEntry().reason, u"a trial"_s);
        QVERIFY(f.newestEntry().details.contains(u"Olli"_s));
    }

private:
    /// Types in the file.
    static qint64 typesIn(const QString& file)
    {
        const auto contents = contentsOfLibrary(file);
        return contents ? contents->types : -1;
    }
};

GRIPSCOPE_TEST(LibraryDialogTest)
#include "library_dialog_test.moc"
