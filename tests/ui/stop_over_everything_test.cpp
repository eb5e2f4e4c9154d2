// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/help/help_windows.h"
#include "ui/windows/dialog.h"
#include "ui/windows/question.h"
#include "ui/windows/stop_controls.h"
#include "ui/windows/window_guard.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCalendarWidget>
#include <QCompleter>
#include <QDateEdit>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QToolTip>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

/// A window whose gripper squeezes, for as long as a test may take to stop it. Presses, touches and keys go
/// to windows of the platform, as a person's do: those know what is modal and who holds the mouse.
class Squeezing {
public:
    Squeezing()
    {
        Recipe recipe;
        recipe.seconds = 10;
        f.bench->inspection().setRecipe(recipe);
        f.bench->inspection().setEarlyEnd(false); // decided, it would be over before
        touchScreen = QTest::createTouchDevice();
        QObject::connect(f.bench.get(), &Workbench::stopped, f.bench.get(), [this] { ++stops; });
    }

    /// On a busy machine the gripper's watchdog may come first: then once more.
    [[nodiscard]] bool squeeze() const
    {
        for (int tries = 0; tries < 5; ++tries)
            if (squeezeOnce()) {
                stops = 0;
                return true;
            }
        return false;
    }
    [[nodiscard]] bool squeezeOnce() const
    {
        const bool ready = QTest::qWaitFor(
            [this] {
                return f.bench->inspection().state() == InspectSession::State::Ready &&
                       !f.bench->connection().armed();
            },
            gripscope::test::longEnough_ms);
        f.bench->arm();
        return ready && QTest::qWaitFor([this] { return f.bench->connection().armed(); }, 2000) &&
               f.bench->inspection().squeeze() &&
               QTest::qWaitFor(
                   [this] { return f.bench->connection().port()->squeezeState() == SqueezeState::Running; },
                   2000);
    }
    /// Somebody asked for it (not its watchdog), and the device itself says that it was stopped and is armed
    /// no longer; nothing was judged.
    [[nodiscard]] bool stopped() const
    {
        return QTest::qWaitFor(
            [this] {
                return stops > 0 && f.bench->connection().port() &&
                       f.bench->connection().port()->squeezeState() == SqueezeState::Stopped &&
                       !f.bench->connection().armed() && !f.bench->inspection().result();
            },
            2000);
    }

    [[nodiscard]] StopButton* headerStop() const { return f.window->findChild<StopButton*>(u"stopButton"_s); }

    /// `through`: the window that the platform hands it to.
    static void press(const QWidget* target, QWindow* through)
    {
        const QPoint at = through->mapFromGlobal(target->mapToGlobal(target->rect().center()));
        const QPointer<QWindow> window = through;
        QTest::mousePress(window, Qt::LeftButton, {}, at);
        if (window) // a popup that goes for good when it is closed is gone
            QTest::mouseRelease(window, Qt::LeftButton, {}, at);
    }
    void touch(const QWidget* target, QWindow* through) const
    {
        const QPoint at = through->mapFromGlobal(target->mapToGlobal(target->rect().center()));
        const QPointer<QWindow> window = through;
        QTest::touchEvent(window, touchScreen).press(1, at, window);
        if (window)
            QTest::touchEvent(window, touchScreen).release(1, at, window);
    }

    WindowFixture f;
    QPointingDevice* touchScreen = nullptr;
    mutable int stops = 0; ///< since the squeeze began
};

/// Every way to stop while `popup` is open: where the platform hands presses to the popup, and where it hands
/// them to the window under the pointer. `open` opens it; what it opened is closed by each.
/// Of many alike each takes one of the ways, `turn` by turn.
void stopsOver(const Squeezing& s, const QString& what, const std::function<QWidget*()>& open,
               std::optional<int> turn = {})
{
    const char* ways[] = {"press, by the popup", "press, by the window", "touch", "Esc"};
    for (const char* way : ways) {
        if (turn && way != ways[*turn % 4])
            continue;
        const QString which = u"%1, %2"_s.arg(what, QLatin1String(way));
        QVERIFY2(s.squeeze(), qPrintable(which));
        const QPointer<QWidget> popup = open();
        QVERIFY2(popup && QTest::qWaitForWindowExposed(popup), qPrintable(which));
        for (const QRect& stop : StopButton::places())
            QVERIFY2(!popup->geometry().intersects(stop), qPrintable(which));
        QWindow* const window = s.f.window->windowHandle();
        if (way == ways[0])
            Squeezing::press(s.headerStop(), popup->windowHandle());
        else if (way == ways[1])
            Squeezing::press(s.headerStop(), window);
        else if (way == ways[2])
            s.touch(s.headerStop(), window);
        else
            QTest::keyClick(popup->windowHandle(), Qt::Key_Escape);
        QVERIFY2(s.stopped(), qPrintable(which));
        if (way == ways[3] && popup)
            popup->close(); // whether Esc closes it is its own affair
        QVERIFY2(
            QTest::qWaitFor([&] { return !popup || !popup->isVisible(); }, gripscope::test::longEnough_ms),
            qPrintable(which));
    }
}

} // namespace

/// While a squeeze runs, STOP stops it: over every dialog, menu, list, calendar, message and drag, by mouse,
/// touch and key.
class StopOverEverythingTest : public QObject {
    Q_OBJECT
private slots:
    void aDialog_data()
    {
        QTest::addColumn<int>("row");
        int row = 0;
        for (const DialogRow& one : dialogTable())
            QTest::newRow(one.name) << row++;
        QVERIFY(row > 15);
    }
    void aDialog()
    {
        QFETCH(int, row);
        const Squeezing s;
        QWindow* const main = s.f.window->windowHandle();
        QPointer<QDialog> dialog;
        StopButton* own = nullptr;
        // One for what goes when a gripper is there (how to get the permission) is opened anew.
        const auto squeezeUnder = [&] {
            QVERIFY(s.squeeze());
            if (dialog && dialog->isVisible())
                return;
            dialog = dialogTable()[static_cast<std::size_t>(row)].make(*s.f.bench, s.f.window.get());
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
            QVERIFY(QTest::qWaitForWindowActive(dialog));
            dialog->move(0,
                         s.headerStop()->height() + 32); // as a person may, so that both STOPs are in sight
            own = dialog->findChild<StopButton*>(u"stripStop"_s);
            QVERIFY(own && own->isVisible());
        };
        const std::pair<const char*, std::function<void()>> ways[] = {
            {"press on the header's", [&] { Squeezing::press(s.headerStop(), main); }},
            {"touch on the header's", [&] { s.touch(s.headerStop(), main); }},
            {"press on its own", [&] { Squeezing::press(own, dialog->windowHandle()); }},
            {"touch on its own", [&] { s.touch(own, dialog->windowHandle()); }},
            {"Esc", [&] { QTest::keyClick(dialog->windowHandle(), Qt::Key_Escape); }}};
        for (const auto& [name, way] : ways) {
            squeezeUnder();
            QVERIFY2(!QTest::currentTestFailed(), name);
            way();
            QVERIFY2(s.stopped(), name);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!dialog || !dialog->isVisible(), gripscope::test::longEnough_ms);
        QVERIFY(!WindowGuard::asking());
    }

    /// Qt's own boxes (a file chooser asks before it overwrites) wait in a loop of their own.
    void aModalBoxOfTheToolkit()
    {
        const Squeezing s;
        QVERIFY(s.squeeze());
        bool stopped = false;
        QTimer::singleShot(200, s.f.window.get(), [&] {
            Squeezing::press(s.headerStop(), s.f.window->windowHandle());
            stopped = s.stopped();
            QDialog* box = WindowGuard::asking();
            QVERIFY(box && box->findChild<StopButton*>(u"stripStop"_s));
            box->close();
        });
        QMessageBox box(QMessageBox::Warning, u"Overwrite"_s, u"It is there already."_s, QMessageBox::Ok,
                        s.f.window.get());
        box.exec();
        QVERIFY(stopped);
    }

    void everyMenu()
    {
        const Squeezing s;
        int menus = 0;
        for (Page* page : s.f.window->pages())
            s.f.window->showPage(page->id());
        for (QMenu* menu : s.f.window->findChildren<QMenu*>()) {
            if (qobject_cast<QMenu*>(menu->parentWidget()))
                continue; // opens from that one
            if (menu->isEmpty())
                menu->addAction(u"Entry"_s); // those that are filled when they are asked for
            ++menus;
            stopsOver(
                s, u"menu %1 %2"_s.arg(menu->objectName()).arg(menus),
                [&] {
                    menu->popup(s.f.window->mapToGlobal(QPoint(200, 120)));
                    return QApplication::activePopupWidget();
                },
                menus);
            if (QTest::currentTestFailed())
                return;
        }
        QVERIFY2(menus >= 5, qPrintable(QString::number(menus)));
    }

    void everyList()
    {
        const Squeezing s;
        int lists = 0;
        for (Page* page : s.f.window->pages()) {
            s.f.window->showPage(page->id());
            for (QComboBox* box : page->findChildren<QComboBox*>()) {
                if (!box->isVisible() || !box->isEnabled() || box->count() == 0)
                    continue;
                ++lists;
                stopsOver(
                    s, u"list %1 on %2"_s.arg(box->objectName(), page->id()),
                    [&] {
                        box->showPopup();
                        return QApplication::activePopupWidget();
                    },
                    lists);
                if (QTest::currentTestFailed())
                    return;
            }
        }
        QVERIFY2(lists >= 3, qPrintable(QString::number(lists)));
    }

    void aCalendar()
    {
        const Squeezing s;
        auto* date = new QDateEdit(s.f.window.get());
        date->setCalendarPopup(true);
        date->setGeometry(300, 200, 160, 40);
        date->show();
        stopsOver(s, u"calendar"_s, [&] {
            QTest::mouseClick(date, Qt::LeftButton, {}, QPoint(date->width() - 10, date->height() / 2));
            return QApplication::activePopupWidget();
        });
    }

    void aCompleter()
    {
        const Squeezing s;
        QLineEdit field(s.f.window.get());
        QCompleter completer(QStringList{u"Alpha"_s, u"Alpine"_s});
        field.setCompleter(&completer);
        field.setGeometry(300, 200, 160, 40);
        field.show();
        stopsOver(s, u"completer"_s, [&] {
            field.clear();
            field.setFocus();
            QTest::keyClicks(&field, u"Al"_s);
            return completer.popup();
        });
    }

    void aContextMenuOfAField()
    {
        const Squeezing s;
        QLineEdit field(u"words"_s, s.f.window.get());
        field.setGeometry(300, 200, 160, 40);
        field.show();
        stopsOver(s, u"context menu"_s, [&] {
            QContextMenuEvent asked(QContextMenuEvent::Keyboard, field.rect().center(),
                                    field.mapToGlobal(field.rect().center()));
            QCoreApplication::sendEvent(&field, &asked);
            return QApplication::activePopupWidget();
        });
    }

    void aMessage()
    {
        const Squeezing s;
        QVERIFY(s.squeeze());
        s.f.bench->messages().report(u"Something went wrong. Do this, then try again."_s);
        QCoreApplication::processEvents();
        Squeezing::press(s.headerStop(), s.f.window->windowHandle());
        QVERIFY(s.stopped());
    }

    void aTooltipOnTheStopItself()
    {
        const Squeezing s;
        QVERIFY(s.squeeze());
        const QPoint at = s.headerStop()->mapToGlobal(s.headerStop()->rect().center());
        QToolTip::showText(at, u"Stop the gripper and disarm it"_s, s.headerStop());
        const auto isTip = [](const QWidget* one) {
            return one->isVisible() && one->windowType() == Qt::ToolTip;
        };
        const QWidgetList all = QApplication::topLevelWidgets();
        const auto tip = std::find_if(all.begin(), all.end(), isTip);
        QVERIFY(tip != all.end());
        QVERIFY(
            !(*tip)->geometry().intersects({s.headerStop()->mapToGlobal(QPoint()), s.headerStop()->size()}));
        Squeezing::press(s.headerStop(), (*tip)->windowHandle());
        QVERIFY(s.stopped());
    }

    /// A hand holds the mouse down somewhere, the other touches STOP.
    void aHeldMouse()
    {
        const Squeezing s;
        QVERIFY(s.squeeze());
        QWindow* const window = s.f.window->windowHandle();
        QTest::mousePress(window, Qt::LeftButton, {}, QPoint(500, 300));
        QTest::mouseMove(window, QPoint(520, 300));
        s.touch(s.headerStop(), window);
        QVERIFY(s.stopped());
        QTest::mouseRelease(window, Qt::LeftButton, {}, QPoint(520, 300));
    }

    void theOtherButtonsOfTheMouse()
    {
        for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
            const Squeezing s;
            QVERIFY(s.squeeze());
            const QPoint at = s.headerStop()->mapTo(s.f.window.get(), s.headerStop()->rect().center());
            QTest::mouseClick(s.f.window->windowHandle(), button, {}, at);
            QVERIFY(s.stopped());
        }
    }

    void whatLiesUnderADialogDoesNotStop()
    {
        const Squeezing s;
        Question* question =
            new Question(u"Go on?"_s, u"What follows."_s, u"Yes"_s, u"No"_s, s.f.window.get());
        question->open();
        QVERIFY(QTest::qWaitForWindowActive(question));
        const QPoint under = s.headerStop()->mapToGlobal(s.headerStop()->rect().center());
        QVERIFY(StopButton::at(under) == s.headerStop());
        question->move(under - question->rect().center());
        QVERIFY(StopButton::at(under) != s.headerStop());
    }

    void whileADialogAsksTheOtherWindowsWait()
    {
        const Squeezing s;
        QWindow* const window = s.f.window->windowHandle();
        const QString page = s.f.window->currentPage()->id();
        auto* question = new Question(u"Go on?"_s, u"What follows."_s, u"Yes"_s, u"No"_s, s.f.window.get());
        question->open();
        QVERIFY(QTest::qWaitForWindowActive(question));
        QVERIFY(question->isAncestorOf(question->focusWidget()));
        const auto* rail = s.f.find<QWidget>("rail-types");
        Squeezing::press(rail, window);
        QCOMPARE(s.f.window->currentPage()->id(), page);
        QTest::keyClick(window, Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(s.f.window->currentPage()->id(), page);
        QVERIFY(rail->isEnabled()); // and look as they did
        QSignalSpy answered(question, &QDialog::finished);
        QTest::keyClick(question->windowHandle(), Qt::Key_Return); // on the button that changes nothing
        QCOMPARE(answered.count(), 1);
        QCOMPARE(answered[0][0].toInt(), int(QDialog::Rejected));
        QTRY_VERIFY(s.f.window->isActiveWindow());
        Squeezing::press(rail, window);
        QCOMPARE(s.f.window->currentPage()->id(), u"types"_s);
    }

    void popupsKeepClearOfEveryStop_data()
    {
        QTest::addColumn<QRect>("wish");
        QTest::addColumn<QRect>("place");
        QTest::newRow("elsewhere") << QRect(0, 100, 200, 300) << QRect(0, 100, 200, 300);
        QTest::newRow("to its left") << QRect(810, 20, 100, 400) << QRect(800, 20, 100, 400);
        QTest::newRow("below") << QRect(905, 50, 90, 200) << QRect(905, 58, 90, 200);
        QTest::newRow("no room anywhere") << QRect(0, 0, 1000, 800) << QRect(0, 0, 1000, 800);
    }
    void popupsKeepClearOfEveryStop()
    {
        QFETCH(QRect, wish);
        QFETCH(QRect, place);
        QCOMPARE(placeBeside(wish, {QRect(900, 10, 100, 48)}, QRect(0, 0, 1000, 800)), place);
    }
    void aMenuOpensBesideTheStop()
    {
        const Squeezing s;
        s.f.window->move(-300, 0); // the screen of the test platform is narrower than the window
        QMenu menu(s.f.window.get());
        for (int i = 0; i < 8; ++i)
            menu.addAction(u"Entry %1"_s.arg(i));
        menu.popup(s.headerStop()->mapToGlobal(QPoint(-20, 10)));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        QVERIFY(!menu.geometry().intersects({s.headerStop()->mapToGlobal(QPoint()), s.headerStop()->size()}));
    }

    void theStripIsThereAsLongAsAGripperCanBeCommanded()
    {
        WindowFixture f(false, {});
        auto* question = new Question(u"Go on?"_s, u"What follows."_s, u"Yes"_s, u"No"_s, f.window.get());
        question->open();
        auto* strip = question->findChild<StopStrip*>();
        QVERIFY(strip && !strip->isVisible());
        f.connectTo(u"virtual:"_s);
        QTRY_VERIFY(strip->isVisible());
        const QRect before = strip->geometry();
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
        QTest::qWait(50);
        QCOMPARE(strip->geometry(), before); // nothing moves under a finger
    }

    void helpInADialog()
    {
        WindowFixture f(false);
        auto* question = new Question(u"Go on?"_s, u"What follows."_s, u"Yes"_s, u"No"_s, f.window.get());
        question->open();
        QVERIFY(QTest::qWaitForWindowActive(question));
        QTest::keyClick(question->windowHandle(), Qt::Key_F1);
        auto* manual = f.window->findChild<ManualWindow*>();
        QVERIFY(manual && manual->isVisible());
        auto* words = manual->findChild<QLineEdit*>(u"manualWords"_s);
        QVERIFY(QTest::qWaitForWindowActive(manual));
        words->setFocus();
        QTest::keyClick(manual->windowHandle(), Qt::Key_S); // it is read while the dialog waits
        QCOMPARE(words->text(), u"s"_s);
    }
};

GRIPSCOPE_TEST(StopOverEverythingTest)
#include "stop_over_everything_test.moc"
