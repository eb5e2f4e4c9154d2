// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

/// The window with the dialog open, and the library behind it.
struct OpenDialog {
    WindowFixture f{true, {}};
    OpenDialog()
    {
        f.window->showPage(u"enroll"_s);
        f.click(f.find<QPushButton>("enrolledTypesButton"));
        if (!QTest::qWaitFor([this] { return types()->rowCount() == 4; }, gripscope::test::longEnough_ms))
            qFatal("the types were not listed");
    }
    QTableWidget* types() const { return f.find<QTableWidget>("typesTable"); }
    QTableWidget* versions() const { return f.find<QTableWidget>("versionsTable"); }
    TypeChangeForm* form() const { return f.window->findChild<TypeChangeForm*>(); }
    /// "A approved 10".
    QString row(int row) const
    {
        QStringList texts;
        for (int column = 0; column < 3; ++column)
            texts += types()->item(row, column)->text();
        return texts.join(u' ');
    }
    void accept(const QString& reason) const
    {
        auto* button = form()->findChild<QPushButton*>(u"changeAccept"_s);
        QVERIFY(!button->isEnabled()); // not without a reason
        form()->findChild<QLineEdit*>(u"reasonField"_s)->setText(reason);
        QVERIFY(button->isEnabled());
        f.click(button);
    }
};

} // namespace

/// Types are renamed, merged, split and retired by click, and every change can be undone.
class EnrolledTypesDialogTest : public QObject {
    Q_OBJECT
private slots:
    void aTypeIsRenamedAndTheChangeUndone()
    {
        const OpenDialog d;
        QVERIFY(!d.f.find<QPushButton>("renameButton")->isEnabled()); // nothing is selected
        d.types()->selectRow(0);
        d.f.click(d.f.find<QPushButton>("renameButton"));
        QTRY_VERIFY(d.form());
        d.form()->findChild<QLineEdit*>(u"nameField"_s)->setText(u"Cola"_s);
        d.accept(u"its name on the shelf"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.row(2), u"Cola approved 10"_s, gripscope::test::longEnough_ms);
        QCOMPARE(d.versions()->item(0, 2)->text(), u"Mai"_s);
        QCOMPARE(d.versions()->item(0, 3)->text(), u"A was renamed Cola."_s);
        QCOMPARE(d.versions()->item(0, 4)->text(), u"its name on the shelf"_s);
        QTRY_VERIFY_WITH_TIMEOUT(d.f.bench->inspection().models().find(u"Cola"_s),
                                 gripscope::test::longEnough_ms);

        QTRY_VERIFY(!d.form());
        QMetaObject::invokeMethod(d.f.find<QPushButton>("undoButton"), "click");
        QTRY_VERIFY(d.form());
        QVERIFY(d.form()->findChild<QLabel*>(u"consequence"_s)->text().startsWith(u"A was renamed Cola."_s));
        d.accept(u"a mistake"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.row(0), u"A approved 10"_s, gripscope::test::longEnough_ms);
    }
    void itOpensFromTheTypesPageToo()
    {
        const WindowFixture f(true, {});
        f.window->showPage(u"types"_s);
        f.clickWhenEnabled(f.find<QPushButton>("manageTypesButton"));
        const auto* dialog = f.window->findChild<EnrolledTypesDialog*>();
        QVERIFY(dialog && dialog->isVisible());
    }
    void twoTypesAreMerged()
    {
        const OpenDialog d;
        d.types()->selectRow(0);
        d.f.click(d.f.find<QPushButton>("mergeButton"));
        QTRY_VERIFY(d.form());
        d.form()->findChild<QComboBox*>(u"typeField"_s)->setCurrentText(u"D"_s);
        d.accept(u"the same can"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.types()->rowCount(), 3, gripscope::test::longEnough_ms);
        QCOMPARE(d.row(2), u"D not approved 20"_s);
        d.types()->selectRow(2);
        d.f.click(d.f.find<QPushButton>("approveTypeButton"));
        d.f.sayWhy();
        QTRY_COMPARE_WITH_TIMEOUT(d.row(2), u"D approved 20"_s, gripscope::test::longEnough_ms);
    }
    void squeezesAreSplitOff()
    {
        const OpenDialog d;
        d.types()->selectRow(1);
        d.f.click(d.f.find<QPushButton>("splitButton"));
        QTRY_VERIFY_WITH_TIMEOUT(d.form(), gripscope::test::longEnough_ms);
        d.form()->findChild<QLineEdit*>(u"nameField"_s)->setText(u"B light"_s);
        auto* squeezes = d.form()->findChild<QListWidget*>(u"squeezesField"_s);
        QCOMPARE(squeezes->count(), 10);
        for (int row = 0; row < 10; ++row) // all is too many
            squeezes->item(row)->setCheckState(Qt::Checked);
        d.form()->findChild<QLineEdit*>(u"reasonField"_s)->setText(u"x"_s);
        QVERIFY(!d.form()->findChild<QPushButton*>(u"changeAccept"_s)->isEnabled());
        for (int row = 3; row < 10; ++row)
            squeezes->item(row)->setCheckState(Qt::Unchecked);
        d.form()->findChild<QLineEdit*>(u"reasonField"_s)->clear();
        d.accept(u"another batch"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.types()->rowCount(), 5, gripscope::test::longEnough_ms);
        QCOMPARE(d.row(1), u"B not approved 7"_s);
        QCOMPARE(d.row(2), u"B light not approved 3"_s);
    }
    void aRetiredTypeIsPutBackAndAnOldVersionRestored()
    {
        const OpenDialog d;
        d.types()->selectRow(0);
        d.f.click(d.f.find<QPushButton>("retireButton"));
        QTRY_VERIFY(d.form());
        d.accept(u"out of production"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.row(3), u"A retired 10"_s, gripscope::test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(d.f.bench->inspection().types().size(), std::size_t(3),
                                  gripscope::test::longEnough_ms);
        QTRY_VERIFY(!d.form());
        d.types()->selectRow(3);
        QVERIFY(!d.f.find<QPushButton>("retireButton")->isEnabled());
        d.f.click(d.f.find<QPushButton>("putBackButton"));
        QTRY_VERIFY(d.form());
        d.accept(u"made again"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.row(0), u"A not approved 10"_s, gripscope::test::longEnough_ms);
        QTRY_VERIFY(!d.form());
        d.versions()->selectRow(2); // version 1, the examples
        QMetaObject::invokeMethod(d.f.find<QPushButton>("restoreButton"), "click");
        QTRY_VERIFY(d.form());
        d.accept(u"as delivered"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.row(0), u"A approved 10"_s, gripscope::test::longEnough_ms);
        QCOMPARE(d.versions()->rowCount(), 4);
    }
    void aScannedCodeIsKeptWithTheType()
    {
        const OpenDialog d;
        d.types()->selectRow(1);
        d.f.click(d.f.find<QPushButton>("codeButton"));
        QTRY_VERIFY(d.form());
        auto* code = d.form()->findChild<QLineEdit*>(u"codeField"_s);
        QTest::keyClicks(code, u"4006381333931"_s);
        QTest::keyClick(code, Qt::Key_Return); // as a scanner ends: nothing is accepted by it
        QTest::qWait(50);
        QVERIFY(d.form());
        d.accept(u"from the order"_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.types()->item(1, 5)->text(), u"4006381333931"_s,
                                  gripscope::test::longEnough_ms);
        QCOMPARE(d.versions()->item(0, 3)->text(), u"B got the code 4006381333931 for scanners."_s);
        QTRY_COMPARE_WITH_TIMEOUT(d.f.bench->inspection().types().at(1).code, u"4006381333931"_s,
                                  gripscope::test::longEnough_ms);
    }
    void whatTheLibraryRefusesIsSaid()
    {
        const OpenDialog d;
        d.types()->selectRow(0);
        d.f.click(d.f.find<QPushButton>("renameButton"));
        QTRY_VERIFY(d.form());
        d.form()->findChild<QLineEdit*>(u"nameField"_s)->setText(u"B"_s);
        d.accept(u"x"_s);
        QTRY_VERIFY_WITH_TIMEOUT(
            d.f.find<QLabel>("stateLabel")->text().contains(u"already a type called B"_s),
            gripscope::test::longEnough_ms);
        QCOMPARE(d.row(0), u"A approved 10"_s);
    }
};

GRIPSCOPE_TEST(EnrolledTypesDialogTest)
#include "enrolled_types_dialog_test.moc"
