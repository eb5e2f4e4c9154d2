// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/people/people_dialogs.h"
#include "ui/shell/arming.h"

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::PeopleWindow;
using gripscope::test::WindowFixture;

namespace {

const QString gripper = u"virtual:?object=A&seed=5"_s;

QString armedWord(const WindowFixture& f)
{
    return f.bench->connection().armed() ? u"armed"_s : u"not armed"_s;
}

} // namespace

/// Who may arm the gripper from the window is what the library's policy says, and the audit trail has it.
class ArmingTest : public QObject {
    Q_OBJECT

    /// Presses Arm in the header and waits for what comes of it: armed, or a question.
    static void pressArm(const PeopleWindow& f)
    {
        f.click(f.find<QPushButton>("armButton"));
        QVERIFY(QTest::qWaitFor([&f] { return f.bench->connection().armed() || f.dialog(); },
                                gripscope::test::longEnough_ms));
    }

private slots:
    void whereNobodyIsInTheLibraryAnybodyArmsAndItIsKept()
    {
        const WindowFixture f(false, gripper);
        f.click(f.find<QPushButton>("armButton"));
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
        std::optional<Expected<std::vector<AuditEntry>>> entries;
        f.bench->background().ask<std::vector<AuditEntry>>(
            nullptr,
            [](Library& library) {
                return library.auditTrail().entries({{}, {}, 1, 0});
            },
            [&entries](Expected<std::vector<AuditEntry>> got) { entries = std::move(got); });
        QTRY_VERIFY_WITH_TIMEOUT(entries.has_value(), gripscope::test::longEnough_ms);
        QVERIFY(*entries && (*entries)->size() == 1);
        const AuditEntry entry = (*entries)->front();
        QCOMPARE(entry.action, u"gripper.armed"_s);
        QCOMPARE(entry.subject, u"VG-5"_s);
        QCOMPARE(entry.person, u"Mai"_s); // as typed at the top
        QVERIFY2(entry.details.contains(u"window"_s), qPrintable(entry.details));
    }

    void thePadlockIsShutWhileNothingCanMove()
    {
        const WindowFixture f(false, gripper);
        const auto* button = f.find<QPushButton>("armButton");
        const auto shows = [button](const QString& sign, std::optional<QColor> color) {
            constexpr QSize size(40, 40);
            return button->icon().pixmap(size).toImage() ==
                   Theme::instance().icon(sign, color).pixmap(size).toImage();
        };
        const QColor accent = Theme::instance().tokens().accent;
        QVERIFY(shows(u"object-locked"_s, {}) && !shows(u"object-unlocked"_s, {}));
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
        QTRY_VERIFY(shows(u"object-unlocked"_s, accent) || !f.bench->connection().armed());
        f.bench->connection().disarm();
        QTRY_VERIFY_WITH_TIMEOUT(shows(u"object-locked"_s, {}), gripscope::test::longEnough_ms);
        f.bench->connection().disconnect();
        QTRY_VERIFY(shows(u"object-locked"_s, {}));
    }

    void keysThatAreHeldForASecondArm()
    {
        std::chrono::steady_clock::time_point now;
        const WindowFixture f(false, gripper);
        auto* chord = f.find<ArmChord>("armChord");
        const auto* bar = f.find<QWidget>("armHolding");
        chord->setClock([&now] { return now; });
        const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
        const auto hold = [&f, both] { QTest::keyPress(f.window.get(), Qt::Key_A, both); };
        const auto letGo = [&f, both] { QTest::keyRelease(f.window.get(), Qt::Key_A, both); };
        const auto looked = [&f] {
            QTest::qWait(100); // several polls
            return f.bench->connection().armed();
        };
        // Struck, as a scanner would, or let go too early: nothing is done.
        hold();
        letGo();
        now += std::chrono::seconds(5);
        QVERIFY(!looked());
        hold();
        now += std::chrono::milliseconds(600);
        QVERIFY(!looked());
        QCOMPARE(chord->progress(), std::optional<double>(0.6));
        QVERIFY(bar->isVisible());
        QCOMPARE(f.find<QPushButton>("armButton")->text(), u"Hold…"_s);
        letGo();
        QVERIFY(!chord->progress() && bar->isHidden());
        now += std::chrono::seconds(5);
        QVERIFY(!looked());
        // Another key within it, and Stop, end it too.
        hold();
        QTest::keyClick(f.window.get(), Qt::Key_7);
        QVERIFY(!chord->progress());
        letGo();
        hold();
        QTest::keyClick(f.window.get(), Qt::Key_Escape);
        now += std::chrono::seconds(5);
        QVERIFY(!looked());
        letGo();
        // Held, and no longer than it takes: repeats of the keyboard change nothing.
        hold();
        QKeyEvent again(QEvent::KeyPress, Qt::Key_A, both, {}, true);
        QCoreApplication::sendEvent(f.window.get(), &again);
        now += ArmChord::duration;
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
        QVERIFY(!chord->progress());
        letGo();
    }
    void keysAskWhoNobodyKnowsToSignIn()
    {
        std::chrono::steady_clock::time_point now;
        const PeopleWindow f(gripper);
        auto* chord = f.find<ArmChord>("armChord");
        chord->setClock([&now] { return now; });
        QTest::keyPress(f.window.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        now += ArmChord::duration;
        QTRY_VERIFY_WITH_TIMEOUT(f.dialog(), gripscope::test::longEnough_ms);
        QCOMPARE(armedWord(f), u"not armed"_s);
    }

    void everyArmButtonAsksWhoNobodyKnowsToSignIn_data()
    {
        QTest::addColumn<QString>("page");
        QTest::addColumn<QString>("button");
        QTest::newRow("header") << u"live"_s << u"armButton"_s;
        QTest::newRow("live") << u"live"_s << u"trialButton"_s;
        QTest::newRow("inspect") << u"inspect"_s << u"inspectArmButton"_s;
    }
    void everyArmButtonAsksWhoNobodyKnowsToSignIn()
    {
        QFETCH(QString, page);
        QFETCH(QString, button);
        const PeopleWindow f(gripper);
        const qint64 before = f.newestEntry().number;
        f.window->showPage(page);
        f.click(f.find<QPushButton>(button.toLatin1().constData()));
        QTRY_VERIFY_WITH_TIMEOUT(f.dialog(), gripscope::test::longEnough_ms);
        QCOMPARE(armedWord(f), u"not armed"_s);
        QCOMPARE(f.newestEntry().number, before);
        f.typeSecret(u"Olli"_s, u"ein langes Wort"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!f.dialog(), gripscope::test::longEnough_ms);
        QVERIFY(f.bench->signIn().current());
        QCOMPARE(armedWord(f), u"not armed"_s); // it is asked for again, by who is known now
        f.makeActive();
        f.click(f.find<QPushButton>(button.toLatin1().constData()));
        QTRY_COMPARE_WITH_TIMEOUT(armedWord(f), u"armed"_s, gripscope::test::longEnough_ms);
        const AuditEntry entry = f.newestEntry();
        QCOMPARE(entry.action, u"gripper.armed"_s);
        QCOMPARE(entry.person, u"Olli"_s);
        QCOMPARE(entry.role, u"operator"_s);
        QCOMPARE(entry.subject, u"VG-5"_s);
    }

    void whereOnlySupervisorsArmAnOperatorAsksOne()
    {
        const PeopleWindow f(gripper);
        f.signIn(u"Sam"_s, u"2468135790"_s);
        auto* people = new PeopleDialog(*f.bench, f.window.get());
        people->open();
        auto* policy = people->findChild<QComboBox*>(u"armingPolicy"_s);
        QVERIFY(policy->isEnabled());
        QTest::keyClick(policy, Qt::Key_Down);
        f.sayWhy(u"the customer asks for it"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->signIn().arming() == ArmingPolicy::Supervisors,
                                 gripscope::test::longEnough_ms);
        QCOMPARE(policy->currentIndex(), 1);
        QCOMPARE(f.newestEntry().action, u"policy.arming"_s);
        QCOMPARE(f.newestEntry().person, u"Sam"_s);
        people->close();
        f.makeActive();

        f.bench->signIn().signOut();
        f.signInOlli();
        f.makeActive();
        pressArm(f);
        QVERIFY(f.dialog());
        QCOMPARE(armedWord(f), u"not armed"_s);
        QCOMPARE(f.dialog()->findChild<QComboBox*>(u"personField"_s)->count(), 1); // Sam
        f.authorise();
        QTRY_COMPARE_WITH_TIMEOUT(armedWord(f), u"armed"_s, gripscope::test::longEnough_ms);
        const AuditEntry entry = f.newestEntry();
        QCOMPARE(entry.action, u"gripper.armed"_s);
        QCOMPARE(entry.person, u"Sam"_s);
        QVERIFY2(entry.details.contains(u"Olli"_s), qPrintable(entry.details));
    }

    void whoMayApproveATypeIsChosenBesideIt()
    {
        const PeopleWindow f(gripper);
        f.signIn(u"Sam"_s, u"2468135790"_s);
        auto* people = new PeopleDialog(*f.bench, f.window.get());
        people->open();
        auto* policy = people->findChild<QComboBox*>(u"approvalPolicy"_s);
        QVERIFY(policy->isEnabled());
        QTest::keyClick(policy, Qt::Key_Down);
        f.sayWhy(u"the customer asks for it"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->signIn().approval() == ApprovalPolicy::SecondPerson,
                                 gripscope::test::longEnough_ms);
        QCOMPARE(policy->currentIndex(), 1);
        QCOMPARE(f.newestEntry().action, u"policy.approval"_s);
        QCOMPARE(f.newestEntry().reason, u"the customer asks for it"_s);
        auto* arming = people->findChild<QComboBox*>(u"armingPolicy"_s);
        QTest::keyClick(arming, Qt::Key_Down);
        f.sayWhy(u"an accident"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->signIn().arming() == ArmingPolicy::Supervisors,
                                 gripscope::test::longEnough_ms);
        QCOMPARE(f.newestEntry().reason, u"an accident"_s);
        people->close();
    }

    void stoppedWhileSomebodyIsAskedItIsNotArmed()
    {
        const PeopleWindow f(gripper);
        f.answer<void>([](Library& library) -> Expected<void> {
            const auto sam = library.people().named(u"Sam"_s);
            const auto grant =
                library.people().authorise(sam->id, Secret(u"2468135790"_s), Permission::ManagePeople);
            library.actAs({{}, {}, *grant});
            return library.people().setArming(ArmingPolicy::Supervisors);
        });
        f.bench->signIn().reload();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->signIn().arming() == ArmingPolicy::Supervisors,
                                 gripscope::test::longEnough_ms);
        f.signInOlli();
        f.makeActive();
        pressArm(f);
        QVERIFY(f.dialog());
        f.bench->stop();
        f.authorise();
        QTRY_COMPARE_WITH_TIMEOUT(f.newestEntry().action, u"gripper.armed"_s,
                                  gripscope::test::longEnough_ms); // it was asked for
        QTest::qWait(0);                        // the answer was handled before newestEntry() had its own
        QCOMPARE(armedWord(f), u"not armed"_s); // but stopped since
    }
};

GRIPSCOPE_TEST(ArmingTest)
#include "arming_test.moc"
