// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_button.h"
#include "tests/support/test_registry.h"
#include "tests/ui/people_window.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/arming.h"

using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A window that is attended, on a clock that the test turns.
template <typename Window>
struct Attended {
    template <typename... Args>
    explicit Attended(Args&&... args) : f(std::forward<Args>(args)...)
    {
        auto watch = std::make_unique<StationWatch>();
        station = watch.get();
        attendance = std::make_unique<Attendance>(*f.bench, std::move(watch));
        attendance->setClock([this] { return now; });
    }
    [[nodiscard]] bool arm() const
    {
        f.bench->arm();
        return QTest::qWaitFor([this] { return f.bench->connection().armed(); }, longEnough_ms);
    }
    [[nodiscard]] bool disarmed() const
    {
        return QTest::qWaitFor([this] { return !f.bench->connection().armed(); }, longEnough_ms);
    }
    /// It was polled a few times since the clock was turned.
    [[nodiscard]] bool staysArmed() const
    {
        QTest::qWait(200);
        if (const auto& why = f.bench->connection().disarmReason())
            qInfo("disarmed: %s", qPrintable(why->describe()));
        return f.bench->connection().armed();
    }

    std::chrono::steady_clock::time_point now;
    Window f;
    StationWatch* station = nullptr;
    std::unique_ptr<Attendance> attendance;
};

} // namespace

/// What nobody attends does not stay armed.
class AttendanceTest : public QObject {
    Q_OBJECT
private slots:
    void whoLeavesTheStationDisarms_data()
    {
        QTest::addColumn<int>("how");
        QTest::addColumn<QString>("told");
        QTest::newRow("locked") << int(StationWatch::Departure::Locked)
                                << u"Disarmed: the station was locked."_s;
        QTest::newRow("asleep") << int(StationWatch::Departure::Suspended)
                                << u"Disarmed: the station went to sleep."_s;
        QTest::newRow("switched") << int(StationWatch::Departure::Switched)
                                  << u"Disarmed: another user took the station over."_s;
    }
    void whoLeavesTheStationDisarms()
    {
        QFETCH(int, how);
        QFETCH(QString, told);
        const Attended<WindowFixture> a(false);
        emit a.station->left(static_cast<StationWatch::Departure>(how));
        QVERIFY(a.f.window->message().isEmpty()); // nothing was armed
        QVERIFY(a.arm());
        emit a.station->left(static_cast<StationWatch::Departure>(how));
        QVERIFY(a.disarmed());
        QCOMPARE(a.f.window->message(), told);
    }

    void nothingDoneForTheTimeOfTheSetting()
    {
        Attended<WindowFixture> a(false);
        QVERIFY(a.arm());
        a.now += 5min - 1s;
        QVERIFY(a.staysArmed());
        a.now += 1s;
        QVERIFY(a.disarmed());
        QCOMPARE(a.f.window->message(), u"Disarmed: nothing was done for 5 min."_s);
        a.f.bench->settings().set(setting::disarmMinutes, 2.0);
        QVERIFY(a.arm()); // arming is something done
        a.now += 2min - 1s;
        QVERIFY(a.staysArmed());
        a.now += 1s;
        QVERIFY(a.disarmed());
    }

    void whatCountsAsDone_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what : {"key", "press", "touch", "wheel", "the gripper's button", "squeeze"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void whatCountsAsDone()
    {
        QFETCH(QString, what);
        Attended<WindowFixture> a(true);
        QVERIFY(a.arm());
        a.now += 5min - 1s;
        QWindow* const window = a.f.window->windowHandle();
        const QPoint empty(300, 30); // of the header
        if (what == "key"_L1) {
            QTest::keyClick(window, Qt::Key_Shift);
        } else if (what == "press"_L1) {
            QTest::mouseClick(window, Qt::LeftButton, {}, empty);
        } else if (what == "touch"_L1) {
            QPointingDevice* screen = QTest::createTouchDevice();
            QTest::touchEvent(window, screen).press(1, empty, window);
            QTest::touchEvent(window, screen).release(1, empty, window);
        } else if (what == "wheel"_L1) {
            QWheelEvent turned(empty, a.f.window->mapToGlobal(empty), {}, {0, 120}, Qt::NoButton, {},
                               Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(a.f.window.get(), &turned);
        } else if (what == "squeeze"_L1) {
            QVERIFY(a.f.bench->inspection().squeeze());
            QTRY_VERIFY_WITH_TIMEOUT(a.f.bench->squeezing(), longEnough_ms);
        } else {
            virtual_button::press();
        }
        QTest::qWait(300); // the button is known by samples
        a.now += 4min;
        QVERIFY(a.staysArmed());
        QTRY_VERIFY_WITH_TIMEOUT(!a.f.bench->squeezing(), longEnough_ms);
        QTest::qWait(50);
        a.now += 5min;
        QVERIFY(a.disarmed());
    }

    void anotherPersonOrNobody()
    {
        const Attended<PeopleWindow> a(u"virtual:"_s);
        a.f.signInOlli();
        QVERIFY(a.arm());
        a.f.signIn(u"Sam"_s, u"2468135790"_s);
        QVERIFY(a.disarmed());
        QCOMPARE(a.f.window->message(), u"Disarmed: the person who worked here has signed out."_s);
        QVERIFY(a.arm());
        a.f.bench->signIn().signOut();
        QVERIFY(a.disarmed());
        QCOMPARE(a.f.window->message(), u"Disarmed: the person who worked here has signed out."_s);
    }

#ifdef Q_OS_LINUX
    /// What logind and screen savers say, handed to those who listen to it.
    void theDesktopsWords_data()
    {
        QTest::addColumn<QVariantMap>("changed");
        QTest::addColumn<QList<int>>("heard");
        QTest::newRow("locked") << QVariantMap{{u"LockedHint"_s, true}}
                                << QList<int>{int(StationWatch::Departure::Locked)};
        QTest::newRow("unlocked") << QVariantMap{{u"LockedHint"_s, false}} << QList<int>{};
        QTest::newRow("another's turn")
            << QVariantMap{{u"Active"_s, false}} << QList<int>{int(StationWatch::Departure::Switched)};
        QTest::newRow("ours again") << QVariantMap{{u"Active"_s, true}} << QList<int>{};
        QTest::newRow("something else") << QVariantMap{{u"IdleHint"_s, true}} << QList<int>{};
    }
    void theDesktopsWords()
    {
        QFETCH(QVariantMap, changed);
        QFETCH(QList<int>, heard);
        const std::unique_ptr<StationWatch> watch = makeStationWatch();
        QList<int> left;
        connect(watch.get(), &StationWatch::left, this,
                [&left](StationWatch::Departure how) { left << int(how); });
        const auto say = [&](const char* interface) {
            return QMetaObject::invokeMethod(watch.get(), "sessionChanged", Qt::DirectConnection,
                                             Q_ARG(QString, QString::fromLatin1(interface)),
                                             Q_ARG(QVariantMap, changed), Q_ARG(QStringList, {}));
        };
        QVERIFY(say("org.freedesktop.login1.User"));
        QCOMPARE(left, QList<int>());
        QVERIFY(say("org.freedesktop.login1.Session"));
        QCOMPARE(left, heard);
        QVERIFY(QMetaObject::invokeMethod(watch.get(), "sleepComes", Q_ARG(bool, false)));
        QVERIFY(QMetaObject::invokeMethod(watch.get(), "screenSaverChanged", Q_ARG(bool, false)));
        QCOMPARE(left, heard);
        QVERIFY(QMetaObject::invokeMethod(watch.get(), "sleepComes", Q_ARG(bool, true)));
        QCOMPARE(left.last(), int(StationWatch::Departure::Suspended));
        QVERIFY(QMetaObject::invokeMethod(watch.get(), "screenSaverChanged", Q_ARG(bool, true)));
        QCOMPARE(left.last(), int(StationWatch::Departure::Locked));
        QVERIFY(QMetaObject::invokeMethod(watch.get(), "lock"));
        QCOMPARE(left.size(), heard.size() + 3);
    }
#endif
};

GRIPSCOPE_TEST(AttendanceTest)
#include "attendance_test.moc"
