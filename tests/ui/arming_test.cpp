// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/people/people_dialogs.h"

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
