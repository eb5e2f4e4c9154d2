// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/shell/connect_menu.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>

using namespace gripscope;
using namespace Qt::StringLiterals;
using gripscope::test::WindowFixture;

/// The wizard for the lag, with the virtual gripper.
class LagDialogTest : public QObject {
    Q_OBJECT
private slots:
    void aPersonArmsMeasuresAndUsesTheLag()
    {
        WindowFixture f(false, gripscope::test::unhurriedA);
        auto* dialog = new LagDialog(*f.bench, f.window.get());
        dialog->open();
        auto* act = dialog->findChild<QPushButton*>(u"lagAct"_s);
        auto* outcome = dialog->findChild<QLabel*>(u"lagOutcome"_s);
        QCOMPARE(act->text(), u"Arm"_s);
        f.click(act);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Squeeze 5 times"_s, gripscope::test::longEnough_ms);
        f.click(act);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Use this lag"_s, gripscope::test::longEnough_ms);
        QVERIFY2(outcome->text().contains(u"s (95 %) later than the force"_s), qPrintable(outcome->text()));
        QVERIFY(!f.bench->squeezing());
        f.click(act);
        f.sayWhy();
        QTRY_VERIFY_WITH_TIMEOUT(outcome->text().startsWith(u"In use"_s), gripscope::test::longEnough_ms);
        QVERIFY(f.bench->connection().measuringChain().forceLagUncertainty_s > 0);
    }
    void stopEndsTheMeasurement()
    {
        WindowFixture f(false);
        auto* dialog = new LagDialog(*f.bench, f.window.get());
        dialog->open();
        auto* act = dialog->findChild<QPushButton*>(u"lagAct"_s);
        f.click(act);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Squeeze 5 times"_s, gripscope::test::longEnough_ms);
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->squeezing(), gripscope::test::longEnough_ms);
        f.bench->stop();
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->squeezing(), gripscope::test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Arm"_s, gripscope::test::longEnough_ms);
        QCOMPARE(f.bench->connection().measuringChain().forceLagUncertainty_s, 0.0);
    }
    void withoutAGripperItSaysWhatToDo()
    {
        WindowFixture f(false, {});
        auto* dialog = new LagDialog(*f.bench, f.window.get());
        dialog->open();
        QVERIFY(!dialog->findChild<QPushButton*>(u"lagAct"_s)->isEnabled());
        QVERIFY(dialog->findChild<QLabel*>(u"lagOutcome"_s)->text().startsWith(u"No gripper is connected"_s));
    }
};

GRIPSCOPE_TEST(LagDialogTest)
#include "lag_dialog_test.moc"
