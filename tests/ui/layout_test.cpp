// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/help/help_windows.h"
#include "ui/inspector/device_inspector.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/people/people_dialogs.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/profiles/profile_dialog.h"
#include "ui/settings/settings_dialog.h"
#include "ui/shell/connect_menu.h"

using namespace gripscope;
using namespace gripscope::test;

// Every page, in the state that the tour shows and when it is empty, in every theme and size: nothing is cut,
// nothing lies over another thing, everything can be hit and named.

class LayoutTest : public QObject {
    Q_OBJECT

    static std::vector<QSize> windowSizes() { return {{1024, 640}, {1440, 900}, {2048, 1280}}; }
    static void pages()
    {
        QTest::addColumn<QString>("id");
        for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }

private slots:
    void aPageAtWork_data() { pages(); }
    void aPageAtWork()
    {
        QFETCH(QString, id);
        WindowFixture f(true, QStringLiteral("virtual:"));
        f.window->showPage(id);
        f.page(id)->prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(f.page(id)->tourReady(), gripscope::test::longEnough_ms);
        f.window->showPage(id);
        QVERIFY(soundInAll(*f.window, QStringLiteral("at work"), windowSizes()));
        f.bench->messages().report(QStringLiteral("Something went wrong. Do this, then try again."));
        QVERIFY(soundIn(*f.window, QStringLiteral("with a message"), {{ThemeKind::Light, "light"}},
                        {windowSizes().front()}));
    }

    void anEmptyPage_data() { pages(); }
    void anEmptyPage()
    {
        QFETCH(QString, id);
        WindowFixture f(false, QString());
        f.window->showPage(id);
        QVERIFY(soundInAll(*f.window, QStringLiteral("empty"), windowSizes()));
    }

    void aDialog_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"about", "lag", "manual", "profile", "inspector", "types", "settings",
                                 "sign in", "supervisor", "people", "person", "audit"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void aDialog()
    {
        QFETCH(QString, name);
        WindowFixture f;
        QDialog* dialog = nullptr;
        if (name == QLatin1String("about"))
            dialog = new AboutDialog({QStringLiteral("Live"), QStringLiteral("Inspect")}, f.window.get());
        else if (name == QLatin1String("lag"))
            dialog = new LagDialog(*f.bench, f.window.get());
        else if (name == QLatin1String("manual"))
            dialog = new ManualWindow(f.window.get());
        else if (name == QLatin1String("profile"))
            dialog = new ProfileDialog(*f.bench, f.window.get());
        else if (name == QLatin1String("inspector"))
            dialog = new DeviceInspector(*f.bench, f.window.get());
        else if (name == QLatin1String("settings"))
            dialog = new SettingsDialog(*f.bench, f.window.get());
        else if (name == QLatin1String("sign in"))
            dialog = new SignInDialog(*f.bench, std::nullopt, f.window.get());
        else if (name == QLatin1String("supervisor"))
            dialog = new SignInDialog(*f.bench, Permission::ChangeLimits, f.window.get());
        else if (name == QLatin1String("people"))
            dialog = new PeopleDialog(*f.bench, f.window.get());
        else if (name == QLatin1String("person"))
            dialog = PersonForm::forNew(true, f.window.get());
        else if (name == QLatin1String("audit"))
            dialog = new AuditDialog(*f.bench, f.window.get());
        else
            dialog = new EnrolledTypesDialog(*f.bench, f.window.get());
        dialog->show();
        QTest::qWait(300); // what the dialog asks the library or the gripper for
        QVERIFY(soundInAll(*dialog, name, {dialog->size()}));
        QVERIFY(dialog->width() <= 1024 && dialog->height() <= 640);
    }
};

GRIPSCOPE_TEST(LayoutTest)
#include "layout_test.moc"
