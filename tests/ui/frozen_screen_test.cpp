// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/widgets/message_bar.h"
#include "ui/windows/stop_controls.h"

#include <chrono>
#include <thread>

using namespace gripscope;
using namespace gripscope::test;

class FrozenScreenTest : public QObject {
    Q_OBJECT
private slots:
    /// The heartbeat hangs on the window's own life: a screen on which nobody could press Stop moves nothing.
    void aGripperWhoseScreenFreezesStopsByItself()
    {
        constexpr double rate_Hz = 2000;
        WindowFixture f(false, QStringLiteral("virtual:?object=A&seed=5"), limitsForAFrozenProgram());
        std::size_t pushed = 0;
        bool watchdog = false;
        f.bench->connection().addListener([&](const std::vector<Sample>& samples) {
            for (const Sample& sample : samples) {
                pushed += sample.status & StatusMoving ? 1 : 0;
                watchdog = watchdog || sample.status & StatusWatchdog;
            }
        });
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), longEnough_ms);
        Recipe recipe;
        recipe.seconds = 10;
        f.bench->inspection().setRecipe(recipe);
        f.bench->inspection().setEarlyEnd(false);
        QVERIFY(f.bench->inspection().squeeze());
        GripperPort* port = f.bench->connection().port();
        QTRY_VERIFY_WITH_TIMEOUT(port->squeezeState() == SqueezeState::Running, longEnough_ms);

        const std::size_t before = pushed;
        std::this_thread::sleep_for(std::chrono::seconds(3)); // the window's thread does nothing at all

        QTRY_VERIFY_WITH_TIMEOUT(port->squeezeState() == SqueezeState::Stopped, longEnough_ms);
        QVERIFY(watchdog);
        // Heartbeats end half a second after the last sign of life, the device's patience 100 ms later.
        QVERIFY2(pushed - before < 2.5 * rate_Hz, qPrintable(QString::number(pushed - before)));
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().state() == InspectSession::State::Ready,
                                 longEnough_ms);
        QVERIFY(!f.bench->inspection().result());
        // Nobody asked for it, so it is told: in the message bar, and why at the next look at a page.
        QTRY_VERIFY_WITH_TIMEOUT(StopStanding::of(*f.bench).disarmReason(), longEnough_ms);
        const QString why = StopStanding::of(*f.bench).disarmReason()->describe();
        QVERIFY(!why.isEmpty());
        QVERIFY2(f.window->findChild<MessageBar*>()->messages().contains(why), qPrintable(why));
    }
};

GRIPSCOPE_TEST(FrozenScreenTest)
#include "frozen_screen_test.moc"
