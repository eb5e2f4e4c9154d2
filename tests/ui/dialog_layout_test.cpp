// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/windows/dialog.h"

#include <QFileDialog>

using namespace gripscope;
using namespace gripscope::test;

/// Every class of dialogs in every theme and both languages; none is larger than the least screen.
class DialogLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void aDialog_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("language");
        int row = 0;
        const auto add = [](const char* name, int place) {
            for (const char* language : {"en", "de"})
                QTest::addRow("%s %s", name, language) << place << QString::fromLatin1(language);
        };
        for (const DialogRow& one : dialogTable())
            add(one.name, row++);
        add("supervisor", -1);
        QVERIFY(row > 15);
    }
    void aDialog()
    {
        QFETCH(int, row);
        const RowLanguage language;
        WindowFixture f;
        QDialog* dialog = row < 0
                              ? new SignInDialog(*f.bench, Permission::ChangeLimits, f.window.get())
                              : dialogTable()[static_cast<std::size_t>(row)].make(*f.bench, f.window.get());
        if (qobject_cast<QFileDialog*>(dialog))
            return; // Qt's own
        dialog->show();
        QTest::qWait(300); // what the dialog asks the library or the gripper for
        LayoutWalk walk(*dialog);
        const QString open = QStringLiteral("open");
        if (dialog->devicePixelRatioF() > 1) // colours are the same there: the theme with the thickest lines
            walk.in(open, everyTheme[2], {dialog->size()});
        else
            walk.inAll(open, {dialog->size()});
        QVERIFY(walk.sound());
        QVERIFY(dialog->width() <= leastSize.width() && dialog->height() <= leastSize.height());
    }
};

GRIPSCOPE_TEST(DialogLayoutTest)
#include "dialog_layout_test.moc"
