// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/shell/connect_menu.h"

#include <QPlainTextEdit>

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
            if (action->isVisible() && !action->isSeparator())
                texts << action->text();
        return texts;
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
        device.toAllow = QStringList{u"sudo something"_s};
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

    void whoMayNotOpenItIsShownWhatToType()
    {
        WindowFixture f(false, {});
        ConnectMenu menu(*f.bench, f.window.get());
        menu.popup({});
        menu.close();
        FoundDevice forbidden = first;
        forbidden.toAllow = QStringList{u"sudo one"_s, u"sudo two"_s};
        menu.showFound({forbidden});
        menu.actions().at(1)->trigger(); // behind the line for none, which is hidden
        const auto* dialog = f.window->findChild<AccessDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->findChild<QPlainTextEdit*>(u"accessCommands"_s)->toPlainText(),
                 u"sudo one\nsudo two"_s);
    }
};

GRIPSCOPE_TEST(ConnectMenuTest)
#include "connect_menu_test.moc"
