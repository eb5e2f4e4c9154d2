// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_load.h"
#include "tests/ui/inspecting.h"
#include "tests/ui/people_window.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/settings.h"
#include "ui/sound/sound_player.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/question.h"

#include <QCheckBox>
#include <QSignalSpy>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test::inspecting;
using gripscope::test::longEnough_ms;
using gripscope::test::PeopleWindow;
using gripscope::test::WindowFixture;

namespace {

/// Its stream goes on between squeezes.
const QString runningGripper = u"virtual:?object=A&seed=5"_s;

/// The Inspect page, armed, with the automatic squeeze on. Beside busy neighbours the gripper's watchdog may
/// disarm it: as a person would, it is armed again then, and the part put in once more.
struct AutomaticPage {
    static constexpr int tries = 10;
    Armed armed{runningGripper};
    WindowFixture& f = armed.f;
    VerdictPanel* panel = f.find<VerdictPanel>("verdictPanel");

    AutomaticPage() { f.bench->settings().set(setting::automaticSqueeze, true); }
    ~AutomaticPage() { virtual_load::set(0); }
    [[nodiscard]] QString words() const { return f.find<ElidedLabel>("automaticLabel")->accessibleName(); }
    [[nodiscard]] bool isArmed() const { return f.bench->connection().armed(); }
    [[nodiscard]] qint64 squeezed() const { return f.bench->inspection().counts().total; }
    /// The jaws are empty, and the force at rest is known.
    [[nodiscard]] bool emptied() const
    {
        virtual_load::set(0);
        for (int i = 0; i < tries; ++i) {
            if (!isArmed())
                f.bench->arm();
            if (!QTest::qWaitFor([this] { return isArmed(); }, longEnough_ms))
                return false;
            const auto waits = [this] { return words().startsWith(u"Squeezes by itself 2 s"_s); };
            (void)QTest::qWaitFor([&] { return waits() || !isArmed(); }, longEnough_ms);
            if (waits())
                return true;
        }
        return false;
    }
    /// A part arrives, and its countdown runs.
    [[nodiscard]] bool touched() const
    {
        for (int i = 0; i < tries && emptied(); ++i) {
            virtual_load::set(0.5);
            (void)QTest::qWaitFor([this] { return panel->alerts() || !isArmed(); }, longEnough_ms);
            if (panel->alerts())
                return true;
        }
        return false;
    }
    /// The part whose countdown runs is squeezed, and then so many are.
    [[nodiscard]] bool becomes(qint64 count) const
    {
        constexpr int storing_ms = 5000; // what is over may be stored though it was disarmed since
        for (int i = 0; i < tries; ++i) {
            (void)QTest::qWaitFor([&] { return squeezed() == count || !isArmed(); }, longEnough_ms);
            if (QTest::qWaitFor([&] { return squeezed() == count; }, storing_ms))
                return true;
            if (!touched())
                return false;
        }
        return false;
    }
};

} // namespace

/// The squeeze that begins by itself when a part arrives, by a part on the virtual gripper.
class AutomaticSqueezePageTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { virtual_load::set(0); }

    void itIsOffUnlessASupervisorPutItOn()
    {
        const Armed armed(runningGripper);
        QVERIFY(!armed.f.bench->settings().get(setting::automaticSqueeze));
        QVERIFY(!armed.f.find<ElidedLabel>("automaticLabel")->isVisible());
        QTest::qWait(1500); // it would know the rest
        virtual_load::set(0.5);
        QTest::qWait(3000);
        QVERIFY(!armed.f.find<VerdictPanel>("verdictPanel")->alerts());
        QVERIFY(!armed.squeezed());
    }

    void aPartIsSqueezedWhenItArrivesAndTheNextWhenItHasLeft()
    {
        const AutomaticPage a;
        QSignalSpy heard(a.f.find<SoundPlayer>("inspectSounds"), &SoundPlayer::playing);
        a.f.click(a.f.find<QPushButton>("soundButton")); // verdicts are silent: the countdown is not
        QVERIFY(a.touched());
        QVERIFY(a.panel->headline().startsWith(u"Squeezes in "_s));
        QCOMPARE(a.panel->accessibleDescription(), u"Take the hand away or press Stop."_s);
        QVERIFY(a.panel->fitted(600, 200).pixels > 60); // to be read from afar
        QVERIFY(!heard.isEmpty());
        QVERIFY(heard.last().at(0).value<Sound>() == Sound::Countdown);
        QVERIFY(a.becomes(1));
        QTest::qWait(3000); // it stays: once
        QCOMPARE(a.squeezed(), 1);
        QVERIFY(!a.panel->alerts());
        QVERIFY(a.touched());
        QVERIFY(a.becomes(2));
    }

    void whatAPersonDoesEndsIt_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* one : {"key", "F1", "F9", "click", "dialog", "page", "disarmed"})
            QTest::newRow(one) << QString::fromLatin1(one);
    }
    void whatAPersonDoesEndsIt()
    {
        QFETCH(QString, what);
        const AutomaticPage a;
        QVERIFY(a.touched());
        if (what == u"key")
            QTest::keyClick(focusOf(a.f), Qt::Key_F);
        else if (what == u"F1") // a shortcut, for the manual
            QTest::keyClick(focusOf(a.f), Qt::Key_F1);
        else if (what == u"F9")
            QTest::keyClick(focusOf(a.f), Qt::Key_F9);
        else if (what == u"click")
            QTest::mouseClick(a.panel, Qt::LeftButton);
        else if (what == u"dialog")
            (new Question(u"Well?"_s, u"So."_s, u"Yes"_s, u"No"_s, a.f.window.get()))->open();
        else if (what == u"page")
            a.f.window->showPage(u"live"_s);
        else
            a.f.bench->connection().disarm();
        QTRY_VERIFY_WITH_TIMEOUT(a.words().startsWith(u"Take the part out"_s) || !a.isArmed(), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!a.panel->alerts(), longEnough_ms);
        QTest::qWait(3000);
        QVERIFY(!a.panel->alerts());
        QCOMPARE(a.squeezed(), 0);
        QVERIFY(!a.f.bench->squeezing());
    }

    void nothingIsCountedDownBehindAnotherWindow()
    {
        const AutomaticPage a;
        QVERIFY(a.emptied());
        const QSignalSpy heard(a.f.find<SoundPlayer>("inspectSounds"), &SoundPlayer::playing);
        QWidget other; // such as the manual, or another program's
        other.resize(1024, 640);
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other, longEnough_ms));
        virtual_load::set(0.5);
        QTest::qWait(4000);
        QVERIFY(!a.panel->alerts() && heard.isEmpty());
        QCOMPARE(a.squeezed(), 0);
        QVERIFY(!a.f.bench->squeezing());
    }

    void afterStopAPersonComesFirst()
    {
        const AutomaticPage a;
        QVERIFY(a.touched());
        QTest::keyClick(a.f.window.get(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!a.isArmed(), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!a.panel->alerts(), longEnough_ms);
        virtual_load::set(0);
        QTest::qWait(1000);
        virtual_load::set(0.5);
        QTest::qWait(3000);
        QVERIFY(!a.isArmed() && !a.panel->alerts());
        QCOMPARE(a.squeezed(), 0);
        QVERIFY(a.touched()); // armed by hand
        QVERIFY(a.becomes(1));
    }

    void itTakesASupervisorAndAReason()
    {
        PeopleWindow f;
        f.signInOlli();
        auto* dialog = new SettingsDialog(*f.bench, f.window.get());
        dialog->open();
        auto* box = dialog->findChild<QCheckBox*>(u"setting-inspecting/automaticSqueeze"_s);
        QVERIFY(box && !box->isChecked());
        box->click();
        QTRY_VERIFY_WITH_TIMEOUT(dialog->findChild<TextQuestion*>(u"whyQuestion"_s), longEnough_ms);
        auto* question = dialog->findChild<TextQuestion*>(u"whyQuestion"_s);
        auto* accept = question->findChild<QPushButton*>(u"answerAccept"_s);
        QVERIFY(!accept->isEnabled());
        QTest::keyClicks(question->field(), u" "_s);
        QVERIFY(!accept->isEnabled());
        QTest::keyClicks(question->field(), u"a robot loads"_s);
        f.click(accept);
        QVERIFY(!f.bench->settings().get(setting::automaticSqueeze)); // Sam has not agreed
        QTRY_VERIFY_WITH_TIMEOUT(f.dialog(), longEnough_ms);
        f.authorise();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->settings().get(setting::automaticSqueeze), longEnough_ms);
        const AuditEntry entry = f.newestEntry();
        QCOMPARE(entry.action, u"setting.changed"_s);
        QCOMPARE(entry.person, u"Sam"_s);
        QCOMPARE(entry.reason, u"a robot loads"_s);
        QVERIFY(entry.details.contains(u"inspecting/automaticSqueeze"_s));
    }
};

GRIPSCOPE_TEST(AutomaticSqueezePageTest)
#include "automatic_squeeze_page_test.moc"
