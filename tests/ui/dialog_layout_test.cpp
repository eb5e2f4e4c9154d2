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

namespace {

/// A dialog that is open, and what was found on it.
struct OpenDialog {
    QString name;
    QDialog* dialog;
    LayoutWalk walk{*dialog};
};

/// One of every class of dialogs but Qt's own.
std::vector<OpenDialog> everyDialog(const WindowFixture& f)
{
    std::vector<OpenDialog> all;
    for (const DialogRow& one : dialogTable())
        if (QDialog* dialog = one.make(*f.bench, f.window.get()); !qobject_cast<QFileDialog*>(dialog))
            all.push_back({QString::fromLatin1(one.name), dialog});
    all.push_back(
        {QStringLiteral("supervisor"), new SignInDialog(*f.bench, Permission::ChangeLimits, f.window.get())});
    for (const OpenDialog& one : all)
        one.dialog->show();
    return all;
}

} // namespace

/// Every class of dialogs in every theme and both languages; none is larger than the least screen. All are
/// open at once: what takes the time is giving the window another theme.
class DialogLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void dialogs_data() { languageRows(); }
    void dialogs()
    {
        const RowLanguage language;
        WindowFixture f;
        std::vector<OpenDialog> open = everyDialog(f);
        QVERIFY(open.size() > 15);
        QTest::qWait(1000); // what the dialogs ask the library or the gripper for
        // Colours are the same on small pixels: there the theme with the thickest lines.
        const bool smallPixels = f.window->devicePixelRatioF() > 1;
        for (const NamedTheme& theme : smallPixels ? std::vector{everyTheme[2]} : everyTheme) {
            Theme::instance().apply(theme.first);
            settleLayout();
            for (OpenDialog& one : open)
                one.walk.look(QStringLiteral("%1, %2").arg(one.name, QLatin1String(theme.second)));
        }
        for (const OpenDialog& one : open) {
            QVERIFY2(one.walk.sound(), qPrintable(one.name));
            QVERIFY2(one.dialog->width() <= leastSize.width() && one.dialog->height() <= leastSize.height(),
                     qPrintable(one.name));
        }
    }
};

GRIPSCOPE_TEST(DialogLayoutTest)
#include "dialog_layout_test.moc"
