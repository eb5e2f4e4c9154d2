// SPDX-License-Identifier: GPL-3.0-or-later
// The window where a profile is written, with a robot that squeezes by itself.
#include "devices/profile/profile_library.h"
#include "tests/support/test_registry.h"
#include "ui/context/workbench.h"
#include "ui/profiles/profile_dialog.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// The window alone; it needs no gripper of its own.
struct OpenProfileDialog {
    OpenProfileDialog() : bench(folder.filePath(u"test.gripscope"_s)), dialog(new ProfileDialog(bench))
    {
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        dialog->show();
    }
    QTemporaryDir folder;
    Workbench bench;
    std::unique_ptr<ProfileDialog> dialog;
};

} // namespace

class ProfileDialogTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_profiles;

    static QString cell(const QTableView* table, int row, ByteTableModel::Column column)
    {
        return table->model()->index(row, static_cast<int>(column)).data().toString();
    }

private slots:
    void initTestCase() { qputenv("GRIPSCOPE_PROFILES", m_profiles.path().toUtf8()); }
    void cleanupTestCase() { qunsetenv("GRIPSCOPE_PROFILES"); }
    void theBytesOfAGripperWithoutAProfileAreShown()
    {
        const OpenProfileDialog open;
        ProfileDialog* dialog = open.dialog.get();
        auto* table = dialog->findChild<QTableView*>(u"profileBytes"_s);
        const QAbstractItemModelTester tester(table->model());
        dialog->listen(u"virtual:?like=walkthrough"_s);
        QTRY_COMPARE_WITH_TIMEOUT(table->model()->rowCount(), 16, gripscope::test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(cell(table, 3, ByteTableModel::Column::Byte).startsWith(u"●"),
                                 gripscope::test::longEnough_ms);
        QCOMPARE(cell(table, 0, ByteTableModel::Column::Last), u"07"_s);
        QVERIFY(!cell(table, 0, ByteTableModel::Column::Byte).contains(u"●"));
    }
    void aProfileIsWrittenCheckedReadBySavedAndFound()
    {
        const OpenProfileDialog open;
        ProfileDialog* dialog = open.dialog.get();
        dialog->listen(u"virtual:?like=walkthrough"_s);
        auto* form = dialog->findChild<ProfileForm*>();
        auto* save = dialog->findChild<QPushButton*>(u"profileSave"_s);
        auto* problems = dialog->findChild<QLabel*>(u"profileProblems"_s);
        auto* seen = dialog->findChild<QLabel*>(u"profileSeen"_s);
        QVERIFY(!save->isEnabled()); // it has no name yet
        GripperProfile profile = namedProfile(u"walkthrough"_s).value();
        profile.position.field.byte = 14; // its last byte would be the 17th
        form->setProfile(profile);
        QVERIFY(!save->isEnabled());
        QVERIFY2(problems->text().contains(u"/fields/position/byte"), qPrintable(problems->text()));
        profile.position.field.byte = 10;
        form->setProfile(profile);
        QVERIFY(save->isEnabled());
        QCOMPARE(form->profile(), profile);
        QTRY_VERIFY_WITH_TIMEOUT(seen->text().contains(u"Lost samples: 0. Not as the profile says: 0."_s),
                                 30000);
        QVERIFY(dialog->findChild<QPlainTextEdit*>(u"profileJson"_s)
                    ->toPlainText()
                    .contains(u"\"gripscope_profile\": 1"_s));
        QCOMPARE(profileFor(0x1209, 5).error().code, ErrorCode::NotFound);
        save->click();
        QTRY_VERIFY_WITH_TIMEOUT(problems->text().startsWith(u"Saved as"_s), gripscope::test::longEnough_ms);
        QCOMPARE(profileFor(0x1209, 5)->name, profile.name);
    }
    void theBytesOfTheChosenFieldAreMarked()
    {
        const OpenProfileDialog open;
        ProfileDialog* dialog = open.dialog.get();
        dialog->listen(u"virtual:?profile=example_big_endian"_s);
        auto* table = dialog->findChild<QTableView*>(u"profileBytes"_s);
        QTRY_COMPARE_WITH_TIMEOUT(table->model()->rowCount(), 8, gripscope::test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(cell(table, 4, ByteTableModel::Column::Field), u"force"_s,
                                  gripscope::test::longEnough_ms);
        emit dialog->findChild<ProfileForm*>()->fieldChosen(u"force"_s);
        QCOMPARE(cell(table, 4, ByteTableModel::Column::Field), u"◀ force"_s);
        QCOMPARE(cell(table, 6, ByteTableModel::Column::Field), u"position"_s);
    }
    void anAddressThatMakesNoSenseIsTold()
    {
        const OpenProfileDialog open;
        ProfileDialog* dialog = open.dialog.get();
        dialog->listen(u"virtual:?like=no_such_thing"_s);
        auto* seen = dialog->findChild<QLabel*>(u"profileSeen"_s);
        QTRY_VERIFY_WITH_TIMEOUT(seen->text().contains(u"no_such_thing"_s), gripscope::test::longEnough_ms);
    }
};

GRIPSCOPE_TEST(ProfileDialogTest)
#include "profile_dialog_test.moc"
