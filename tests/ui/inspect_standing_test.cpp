// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "tests/ui/painted_text.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/outcome_view.h"
#include "ui/windows/stop_controls.h"

#include <QLabel>

#include <chrono>
#include <thread>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test::inspecting;
using gripscope::test::longEnough_ms;
using gripscope::test::MeasuredCan;
using gripscope::test::PaintedText;
using gripscope::test::textsPaintedBy;
using gripscope::test::WindowFixture;

namespace {

/// What the page says where a verdict would stand.
QString saidBeside(const VerdictPanel* panel)
{
    return panel->accessibleDescription();
}

bool isVerdict(const VerdictPanel* panel)
{
    return panel->outcome().has_value();
}

Recording squeezeOfA()
{
    Recording recording = MeasuredCan().make();
    recording.status.assign(recording.size(), StatusArmed | StatusMoving);
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.sequence.push_back(i);
    return recording;
}

} // namespace

/// How the gripper stands is seen where the verdict was: stopped, gone, disarmed.
class InspectStandingTest : public QObject {
    Q_OBJECT
    /// `why` comes as a message, and stands on the page below `headline` when that is put away.
    static void outlivesItsMessage(const WindowFixture& f, const QString& why, const QString& headline)
    {
        auto* bar = f.window->findChild<MessageBar*>();
        QTRY_VERIFY_WITH_TIMEOUT(bar->messages().contains(why), longEnough_ms);
        while (!bar->messages().isEmpty())
            bar->dismiss();
        const auto* panel = f.find<VerdictPanel>("verdictPanel");
        QTRY_COMPARE_WITH_TIMEOUT(panel->headline(), headline, longEnough_ms);
        QVERIFY2(saidBeside(panel).contains(why), qPrintable(saidBeside(panel)));
        f.window->resize(1024, 640);
        QStringList painted;
        for (const PaintedText& text : textsPaintedBy(*f.find<VerdictPanel>("verdictPanel")))
            painted << text.text;
        QVERIFY2(painted.join(u' ').contains(why), qPrintable(painted.join(u'/')));
    }

private slots:
    void aStopTakesTheVerdictBack_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Esc") << true;
        QTest::newRow("STOP") << false;
    }
    void aStopTakesTheVerdictBack()
    {
        QFETCH(bool, byKey);
        Armed armed;
        WindowFixture& f = armed.f;
        expectType(f, u"A"_s);
        squeezeBySpace(f);
        const auto* panel = f.find<VerdictPanel>("verdictPanel");
        const auto* stopped = f.find<QLabel>("stoppedLabel");
        QVERIFY(isVerdict(panel) && !stopped->isVisible());
        if (byKey)
            QTest::keyClick(focusOf(f), Qt::Key_Escape);
        else
            f.click(f.find<QWidget>("stopButton"));
        QTRY_VERIFY_WITH_TIMEOUT(!isVerdict(panel), longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(panel->headline(), u"Stopped"_s, longEnough_ms);
        QVERIFY2(saidBeside(panel).startsWith(u"The last part: A"_s), qPrintable(saidBeside(panel)));
        QVERIFY(stopped->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), longEnough_ms);
        // Armed anew it is ready for a part, of which nothing is known.
        auto* arm = f.find<QPushButton>("inspectArmButton");
        QTRY_VERIFY_WITH_TIMEOUT(arm->isVisible() && arm->isEnabled(), longEnough_ms);
        f.click(arm);
        QTRY_COMPARE_WITH_TIMEOUT(panel->headline(), u"Ready"_s, longEnough_ms);
        QVERIFY(!isVerdict(panel));
        QVERIFY2(saidBeside(panel).startsWith(u"The last part: A"_s), qPrintable(saidBeside(panel)));
        QTRY_VERIFY(!stopped->isVisible());
        squeezeBySpace(f); // and the next verdict is one
        QVERIFY(isVerdict(panel));
    }

    void anUnpluggedGripperTakesTheVerdictBack()
    {
        // It goes away some seconds after it was connected: on a busy computer that may be before the
        // verdict, so that it is given longer.
        for (int seconds = 4; seconds <= 256; seconds *= 4) {
            WindowFixture f(true, u"virtual:?object=A&seed=5&fault=unplug:%1"_s.arg(seconds));
            f.window->showPage(u"inspect"_s);
            const auto* panel = f.find<VerdictPanel>("verdictPanel");
            const auto lost = [&f] { return f.bench->connection().state() == ConnectSession::State::Lost; };
            QVERIFY(f.bench->inspection().judgeRecording(squeezeOfA(), u"a test"_s));
            QVERIFY(QTest::qWaitFor([&] { return isVerdict(panel) || lost(); }, longEnough_ms));
            if (lost())
                continue;
            QTRY_VERIFY_WITH_TIMEOUT(lost(), longEnough_ms + 1000 * seconds);
            QTRY_VERIFY_WITH_TIMEOUT(!isVerdict(panel), longEnough_ms);
            QVERIFY(panel->headline() != u"Stopped"_s); // nobody did
            QVERIFY2(saidBeside(panel).startsWith(u"The last part: A"_s), qPrintable(saidBeside(panel)));
            return;
        }
        QFAIL("no verdict was reached in time");
    }

    void whyItWasNotArmedIsSaidWhenTheMessageIsPutAway()
    {
        // A sample every 40 ms: it can only be listened to.
        WindowFixture f(true, u"virtual:?object=A&seed=5&rate=25"_s);
        f.window->showPage(u"inspect"_s);
        f.bench->arm();
        const StopStanding& standing = StopStanding::of(*f.bench);
        QTRY_VERIFY_WITH_TIMEOUT(standing.disarmReason(), longEnough_ms);
        const QString why = standing.disarmReason()->describe();
        QVERIFY2(why.startsWith(u"The gripper was not armed: "_s), qPrintable(why));
        outlivesItsMessage(f, why, u"Not armed"_s);
    }

    void disarmedIsSaidWhenTheMessageIsPutAway()
    {
        WindowFixture f(true, u"virtual:?object=A&seed=5"_s, gripscope::test::limitsForAFrozenProgram());
        f.window->showPage(u"inspect"_s);
        const StopStanding& standing = StopStanding::of(*f.bench);
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed() || standing.disarmReason(), longEnough_ms);
        std::this_thread::sleep_for(std::chrono::seconds(2)); // the window's thread does nothing at all
        QTRY_VERIFY_WITH_TIMEOUT(standing.disarmReason() && !f.bench->connection().armed(), longEnough_ms);
        const QString why = standing.disarmReason()->describe();
        outlivesItsMessage(f, why, u"Disarmed"_s);
    }
};

GRIPSCOPE_TEST(InspectStandingTest)
#include "inspect_standing_test.moc"
