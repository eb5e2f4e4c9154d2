// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/shell/connect_menu.h"
#include "ui/windows/question.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QWidgetAction>

#include <algorithm>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const FoundDevice first{u"hid:1209:0001:GS-1"_s, u"GS-1"_s, u"Bench gripper"_s, u"available"_s};
const FoundDevice second{u"hid:1209:0001:GS-2"_s, u"GS-2"_s, u"Bench gripper"_s, u"available"_s};

/// The menu as it was left when it was closed: nothing on this computer gets between.
struct ClosedMenu {
    QTemporaryDir folder;
    Workbench bench{folder.filePath(u"test.gripscope"_s)};
    ConnectMenu menu{bench};

    ClosedMenu()
    {
        menu.popup({});
        menu.close();
    }
    [[nodiscard]] QStringList texts() const
    {
        QStringList texts;
        for (const QAction* action : menu.actions())
            if (action->isVisible() && !action->isSeparator() && !isTitle(*action))
                texts << action->text();
        return texts;
    }
    /// What stands under a title, up to the next.
    [[nodiscard]] QStringList under(const QString& title) const
    {
        QStringList texts;
        bool here = false;
        for (const QAction* action : menu.actions()) {
            if (isTitle(*action))
                here = action->text() == title;
            else if (here && action->isVisible() && !action->isSeparator())
                texts << action->text();
        }
        return texts;
    }
    [[nodiscard]] static bool isTitle(const QAction& action)
    {
        return qobject_cast<const QWidgetAction*>(&action) != nullptr;
    }
};

} // namespace

class ConnectMenuTest : public QObject {
    Q_OBJECT
private slots:
    void aGripperIsTold_data()
    {
        QTest::addColumn<FoundDevice>("device");
        QTest::addColumn<bool>("lastUsed");
        QTest::addColumn<QString>("words");
        FoundDevice device = first;
        QTest::newRow("plain") << device << false << u"Bench gripper · serial GS-1"_s;
        QTest::newRow("used last") << device << true << u"Bench gripper · serial GS-1 · used last"_s;
        device.port = u"usb-2/input0"_s;
        QTest::newRow("a twin") << device << false << u"Bench gripper · serial GS-1 · at usb-2/input0"_s;
        device.serial.clear();
        QTest::newRow("nameless") << device << false
                                  << u"Bench gripper · no serial number · at usb-2/input0"_s;
        device = first;
        device.toAllow = u"sudo something"_s;
        QTest::newRow("forbidden") << device << false
                                   << u"Bench gripper · serial GS-1 · no permission: see what to type"_s;
    }
    void aGripperIsTold()
    {
        QFETCH(FoundDevice, device);
        QFETCH(bool, lastUsed);
        QTEST(ConnectMenu::wordsOf(device, lastUsed), "words");
    }

    void grippersComeAndGoInTheList()
    {
        ClosedMenu closed;
        closed.menu.showFound({});
        QVERIFY(closed.texts().contains(u"No gripper found on USB"_s));
        closed.menu.showFound({first, second});
        QCOMPARE(closed.texts().mid(0, 2),
                 (QStringList{u"Bench gripper · serial GS-1"_s, u"Bench gripper · serial GS-2"_s}));
        QVERIFY(!closed.texts().contains(u"No gripper found on USB"_s));
        closed.menu.showFound({second});
        QCOMPARE(closed.texts().front(), u"Bench gripper · serial GS-2"_s);
        QVERIFY(!closed.texts().contains(u"Bench gripper · serial GS-1"_s));
    }

    void grippersThisOneAndToolsStandApart()
    {
        ClosedMenu closed;
        closed.menu.showFound({first, second});
        QStringList titles;
        for (const QAction* action : closed.menu.actions())
            if (ClosedMenu::isTitle(*action)) {
                titles << action->text();
                QVERIFY(!action->isEnabled()); // keys pass it by
            }
        QCOMPARE(titles, (QStringList{u"Grippers"_s, u"This gripper"_s, u"Tools"_s}));
        const QStringList grippers = closed.under(u"Grippers"_s);
        QCOMPARE(grippers.size(), 11);
        QCOMPARE(grippers.at(1), u"Bench gripper · serial GS-2"_s);
        QCOMPARE(grippers.at(2), u"Virtual gripper, can A"_s);
        QCOMPARE(grippers.back(), u"Other address…"_s);
        QCOMPARE(closed.under(u"This gripper"_s),
                 (QStringList{u"Inspect the gripper…\tF9"_s, u"Measure the lag between its channels…"_s,
                              u"Disconnect"_s}));
        QCOMPARE(closed.under(u"Tools"_s), (QStringList{u"Profile of another maker's gripper…"_s,
                                                        u"Keep the raw reports of every session"_s}));
    }

    void theAddressIsShownAsItIsTyped()
    {
        const TextQuestion question(u"Connect"_s, u"Such as virtual:?object=B&seed=7"_s, {}, u"Connect"_s,
                                    nullptr);
        bool found = false;
        for (const QLabel* label : question.findChildren<QLabel*>())
            if (label->buddy()) { // there one ampersand marks a key, and two are one
                QCOMPARE(label->text(), u"Such as virtual:?object=B&&seed=7"_s);
                found = true;
            }
        QVERIFY(found);
    }

    void whoMayNotOpenItIsShownWhatToType()
    {
        WindowFixture f(false, {});
        ConnectMenu menu(*f.bench, f.window.get());
        menu.popup({});
        menu.close();
        FoundDevice forbidden = first;
        forbidden.missing = u"writing"_s;
        forbidden.toAllow = u"sudo one && sudo two"_s;
        menu.showFound({forbidden});
        const QList<QAction*> actions = menu.actions();
        const auto found = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
            return action->text().startsWith(u"Bench gripper"_s);
        });
        QVERIFY(found != actions.end());
        (*found)->trigger();
        const auto* dialog = f.window->findChild<AccessDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->findChild<QPlainTextEdit*>(u"accessCommands"_s)->toPlainText(),
                 u"sudo one && sudo two"_s);
        bool told = false; // which permission it is, too
        for (const QLabel* label : dialog->findChildren<QLabel*>())
            told = told || label->text().startsWith(u"What is missing is writing. "_s);
        QVERIFY(told);
    }

    void whatToTypeStaysWhileAnotherGripperIsConnected()
    {
        const WindowFixture f(false);
        auto* dialog = new AccessDialog(*f.bench, first, f.window.get());
        const QPointer<AccessDialog> shown = dialog;
        dialog->open();
        emit f.bench->connectionChanged();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(shown && shown->isVisible());
    }
};

GRIPSCOPE_TEST(ConnectMenuTest)
#include "connect_menu_test.moc"
