// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/context/language.h"
#include "ui/help/help_windows.h"
#include "ui/pages/enroll/enrolled_types_dialog.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/profiles/profile_dialog.h"
#include "ui/settings/settings_dialog.h"

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

/// German words are longer: they fit too, at the least size, and in the theme with the widest lines.
class GermanLayoutTest : public QObject {
    Q_OBJECT

    static void pages()
    {
        QTest::addColumn<QString>("id");
        for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    static bool isSound(QWidget& top, const QString& state, const std::vector<QSize>& sizes)
    {
        return soundIn(top, state, {{ThemeKind::Light, "light"}, {ThemeKind::HighContrast, "contrast"}},
                       sizes);
    }

private slots:
    void init() { QVERIFY(applyLanguage(u"de"_s)); }
    void cleanup() { QVERIFY(applyLanguage(u"en"_s)); }

    void aPageAtWork_data() { pages(); }
    void aPageAtWork()
    {
        QFETCH(QString, id);
        WindowFixture f(true, u"virtual:"_s);
        f.window->showPage(id);
        f.page(id)->prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(f.page(id)->tourReady(), gripscope::test::longEnough_ms);
        f.window->showPage(id);
        QVERIFY(isSound(*f.window, u"at work"_s, {{1024, 640}}));
        QCOMPARE(f.window->size(), QSize(1024, 640));
    }

    void anEmptyPage_data() { pages(); }
    void anEmptyPage()
    {
        QFETCH(QString, id);
        WindowFixture f(false, QString());
        f.window->showPage(id);
        QVERIFY(isSound(*f.window, u"empty"_s, {{1024, 640}}));
        QCOMPARE(f.window->size(), QSize(1024, 640));
    }

    void aDialog_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"about", "profile", "rates", "settings", "types"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void aDialog()
    {
        QFETCH(QString, name);
        WindowFixture f;
        QDialog* dialog = nullptr;
        if (name == "about"_L1)
            dialog = new AboutDialog({u"Einlernen"_s, u"Kalibrieren"_s}, f.window.get());
        else if (name == "profile"_L1)
            dialog = new ProfileDialog(*f.bench, f.window.get());
        else if (name == "rates"_L1)
            dialog = new RatesDialog({}, true, f.window.get());
        else if (name == "settings"_L1)
            dialog = new SettingsDialog(*f.bench, f.window.get());
        else
            dialog = new EnrolledTypesDialog(*f.bench, f.window.get());
        dialog->show();
        QTest::qWait(300); // what the dialog asks the library for
        QVERIFY(isSound(*dialog, name, {dialog->size()}));
        QVERIFY(dialog->width() <= 1024 && dialog->height() <= 640);
    }
};

GRIPSCOPE_TEST(GermanLayoutTest)
#include "german_layout_test.moc"
