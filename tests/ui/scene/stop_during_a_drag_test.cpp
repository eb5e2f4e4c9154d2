// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/windows/stop_controls.h"

#include <QComboBox>
#include <QCursor>
#include <QDrag>
#include <QMenu>
#include <QMimeData>
#include <QTimer>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

/// Stop on a real window system, since others drag nothing and open popups in a way of their own. While
/// something is dragged the toolkit takes every key and every move of the mouse for the drag.
class StopDuringADragTest : public QObject {
    Q_OBJECT
private slots:
    void aDrag_data()
    {
        QTest::addColumn<QString>("way");
        QTest::newRow("Esc") << u"Esc"_s;
        QTest::newRow("touch") << u"touch"_s;
    }
    void aDrag()
    {
        QFETCH(QString, way);
        WindowFixture f;
        Recipe recipe;
        recipe.seconds = 10;
        f.bench->inspection().setRecipe(recipe);
        f.bench->inspection().setEarlyEnd(false);
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
        QVERIFY(f.bench->inspection().squeeze());
        GripperPort* port = f.bench->connection().port();
        QTRY_VERIFY_WITH_TIMEOUT(port->squeezeState() == SqueezeState::Running,
                                 gripscope::test::longEnough_ms);

        QWindow* const window = f.window->windowHandle();
        const auto* stop = f.find<StopButton>("stopButton");
        QPointingDevice* screen = QTest::createTouchDevice();
        QCursor::setPos(f.window->mapToGlobal(QPoint(500, 300)));
        QPointer<QDrag> drag = new QDrag(f.window.get());
        bool dragged = false, stopped = false;
        QTimer::singleShot(300, f.window.get(), [&] {
            dragged = !drag.isNull();
            if (way == "Esc"_L1) {
                QTest::keyClick(window, Qt::Key_Escape);
            } else {
                const QPoint at = stop->mapTo(f.window.get(), stop->rect().center());
                QTest::touchEvent(window, screen).press(1, at, window);
                QTest::touchEvent(window, screen).release(1, at, window);
            }
            stopped = QTest::qWaitFor(
                [&] {
                    return port->squeezeState() == SqueezeState::Stopped && !f.bench->connection().armed();
                },
                2000);
            QDrag::cancel();
        });
        auto* words = new QMimeData;
        words->setText(u"words"_s);
        drag->setMimeData(words);
        drag->exec();
        QVERIFY(dragged);
        QVERIFY(stopped);
    }

    /// What the manual says: Esc stops, and does what it usually does as well.
    void escClosesWhatIsOpenAsWell_data()
    {
        QTest::addColumn<bool>("list");
        QTest::newRow("a menu") << false;
        QTest::newRow("the list of a field") << true;
    }
    void escClosesWhatIsOpenAsWell()
    {
        QFETCH(bool, list);
        WindowFixture f;
        f.bench->arm();
        QTRY_VERIFY(f.bench->connection().armed());
        QMenu menu(f.window.get());
        menu.addAction(u"an entry"_s);
        QComboBox field(f.window.get());
        field.addItems({u"one"_s, u"two"_s});
        field.move(200, 300);
        field.show();
        if (list)
            field.showPopup();
        else
            menu.popup(f.window->mapToGlobal(QPoint(200, 300)));
        QTRY_VERIFY(QApplication::activePopupWidget());
        const QPointer<QWidget> popup = QApplication::activePopupWidget();
        QVERIFY(QTest::qWaitForWindowExposed(popup));
        QTest::keyClick(popup->windowHandle(), Qt::Key_Escape);
        QTRY_VERIFY(!f.bench->connection().armed());
        QTRY_VERIFY(!popup || !popup->isVisible());
    }
};

GRIPSCOPE_TEST(StopDuringADragTest)
#include "stop_during_a_drag_test.moc"
