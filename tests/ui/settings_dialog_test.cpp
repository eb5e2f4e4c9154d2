// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/settings_link.h"
#include "ui/settings/values/settings.h"
#include "ui/windows/question.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

/// The window with its settings in force, and the Settings window opened by its key.
struct Opened {
    WindowFixture f{false, QString()};
    SettingsLink link{*f.bench};
    SettingsDialog* dialog = nullptr;

    Opened()
    {
        QTest::keyClick(f.window.get(), Qt::Key_Comma, Qt::ControlModifier);
        if (!QTest::qWaitFor([this] { return f.window->findChild<SettingsDialog*>() != nullptr; },
                             gripscope::test::longEnough_ms))
            qFatal("Ctrl+, opened nothing");
        dialog = f.window->findChild<SettingsDialog*>();
    }
    template <typename T>
    [[nodiscard]] T* find(const char* name) const
    {
        T* widget = dialog->findChild<T*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget %s", name);
        return widget;
    }
    [[nodiscard]] Settings& settings() const { return f.bench->settings(); }
    /// As a person chooses from the list.
    static void choose(QComboBox* box, const QString& value)
    {
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < box->findData(value); ++i)
            QTest::keyClick(box, Qt::Key_Down);
    }
};

} // namespace

/// The Settings window by click and key.
class SettingsDialogTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

private slots:
    void cleanup() { Theme::instance().apply(ThemeKind::Light); }

    void theGearOpensItToo()
    {
        WindowFixture f(false, QString());
        f.click(f.find<QWidget>("rail-settings"));
        QTRY_VERIFY(f.window->findChild<SettingsDialog*>());
    }

    /// Nobody is asked why, nothing of it is kept, also not in the audit trail, and it can be mended.
    void aTextThatCannotBeIsToldAndKeptNowhere_data()
    {
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("told");
        const QByteArray server = setting::plantServer.key, broker = setting::mqttBroker.key;
        QTest::newRow("a password") << server << u"postgresql://a:secret@host/plant"_s << u"password"_s;
        QTest::newRow("a file") << server << u"plant.db"_s << u"postgresql://USER@HOST/NAME"_s;
        QTest::newRow("a broker's") << broker << u"mqtt://a:secret@host"_s << u"places of their own"_s;
        QTest::newRow("too long") << QByteArray(setting::company.key) << QString(100'000, u'x') << u"up to"_s;
    }
    void aTextThatCannotBeIsToldAndKeptNowhere()
    {
        QFETCH(QByteArray, key);
        QFETCH(QString, typed);
        QFETCH(QString, told);
        const Opened o;
        auto* edit = o.find<QLineEdit>(QByteArray("setting-" + key).constData());
        edit->setMaxLength(int(typed.size()));
        edit->setText(typed);
        QTest::keyClick(edit, Qt::Key_Return);
        auto* words = o.find<QLabel>("settingsTold");
        QVERIFY(words->isVisible());
        QVERIFY2(words->text().contains(told), qPrintable(words->text()));
        QVERIFY(!words->text().contains(u"secret"_s));
        QCOMPARE(edit->text(), typed);
        QVERIFY(!o.f.window->findChild<QWidget*>(u"whyQuestion"_s));
        QVERIFY(o.settings().isDefault(QString::fromLatin1(key)));
        edit->setText(QString());
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(!words->isVisible());
    }
    void aChoiceTakesEffectAtOnce()
    {
        const Opened o;
        Opened::choose(o.find<QComboBox>("setting-theme"), u"dark"_s);
        QCOMPARE(o.settings().get(setting::theme), u"dark"_s);
        QCOMPARE(Theme::instance().tokens().kind, ThemeKind::Dark);
        auto* reset = o.find<QPushButton>("reset-theme");
        QVERIFY(reset->isEnabled());
        WindowFixture::click(reset);
        QCOMPARE(Theme::instance().tokens().kind, ThemeKind::Light);
        QVERIFY(!reset->isEnabled());
    }

    void ratesGoToTheSessionsAndBack()
    {
        const Opened o;
        auto* rate = o.find<QDoubleSpinBox>("setting-rates/falseReject");
        rate->setFocus();
        rate->selectAll();
        QTest::keyClicks(rate, u"2.5"_s);
        QTest::keyClick(rate, Qt::Key_Return);
        o.f.sayWhy();
        QCOMPARE(o.f.bench->rates().rates.falseReject, 0.025);
        // Set in the Rates window of the Inspect page, they are shown here.
        StoredRates other = o.f.bench->rates();
        other.rates.falseReject = 0.004;
        other.earlyEnd = false;
        o.f.bench->setRates(other);
        QCOMPARE(o.settings().get(setting::falseReject), 0.004);
        QCOMPARE(rate->value(), 0.4);
        QVERIFY(!o.find<QCheckBox>("setting-rates/earlyEnd")->isChecked());
    }

    void keepingSessionsGoesToTheWorkbench()
    {
        const Opened o;
        auto* box = o.find<QCheckBox>("setting-captures/keep");
        QVERIFY(box->isChecked() && o.f.bench->keepsSessions());
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        QVERIFY(!o.f.bench->keepsSessions());
        auto* folder = o.find<QLineEdit>("setting-captures/folder");
        folder->setFocus();
        QTest::keyClicks(folder, m_folder.path());
        QTest::keyClick(folder, Qt::Key_Return);
        QCOMPARE(o.f.bench->keeping().folder, m_folder.path());
    }

    void aSearchLeavesWhatHasItsWords()
    {
        const Opened o;
        QTest::keyClicks(o.find<QLineEdit>("settingsSearch"), u"high contrast"_s); // a choice of the theme
        int shown = 0;
        for (const SettingRow* row : o.dialog->findChildren<SettingRow*>())
            shown += row->isVisibleTo(o.dialog) ? 1 : 0;
        QCOMPARE(shown, 1);
        QVERIFY(o.find<QWidget>("setting-theme")->isVisibleTo(o.dialog));
    }

    void anImportIsShownBeforeItIsDone()
    {
        const Opened o;
        const QString file = m_folder.filePath(u"settings.json"_s);
        Opened::choose(o.find<QComboBox>("setting-theme"), u"dark"_s);
        o.dialog->exportFile(file);
        QTRY_VERIFY(o.find<QLabel>("settingsTold")->text().contains(file));
        WindowFixture::click(o.find<QPushButton>("reset-theme"));
        o.dialog->importFile(file);
        QTRY_VERIFY(o.dialog->findChild<ImportDialog*>());
        auto* import = o.dialog->findChild<ImportDialog*>();
        auto* table = import->findChild<QTableWidget*>(u"importTable"_s);
        QVERIFY(table);
        QCOMPARE(table->rowCount(), 1);
        QCOMPARE(table->item(0, 0)->text(), u"Theme"_s);
        QCOMPARE(table->item(0, 1)->text(), u"Light"_s);
        QCOMPARE(table->item(0, 2)->text(), u"Dark"_s);
        QCOMPARE(o.settings().get(setting::theme), u"light"_s);
        WindowFixture::click(import->findChild<QPushButton*>(u"applyImport"_s));
        QCOMPARE(o.settings().get(setting::theme), u"dark"_s);
    }

    void aBadFileChangesNothingAndSaysWhy()
    {
        const Opened o;
        const QString file = m_folder.filePath(u"bad.json"_s);
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(R"({"format": "gripscope-settings", "version": 1,
                      "settings": {"theme": "dark", "language": "tlh"}})");
        out.close();
        o.dialog->importFile(file);
        QTRY_VERIFY(o.dialog->findChild<ImportDialog*>());
        auto* import = o.dialog->findChild<ImportDialog*>();
        QVERIFY(import->findChild<QLabel*>(u"importProblems"_s)->text().contains("tlh"_L1));
        QVERIFY(!import->findChild<QPushButton*>(u"applyImport"_s)->isEnabled());
        import->reject();
        o.dialog->importFile(m_folder.filePath(u"none.json"_s));
        QTRY_VERIFY(o.find<QLabel>("settingsTold")->text().contains("none.json"_L1));
        QCOMPARE(o.settings().get(setting::theme), u"light"_s);
    }

    void allAreResetAfterAQuestion()
    {
        const Opened o;
        Opened::choose(o.find<QComboBox>("setting-theme"), u"dark"_s);
        WindowFixture::click(o.find<QPushButton>("resetSettings"));
        QTRY_VERIFY(o.dialog->findChild<Question*>());
        WindowFixture::click(o.dialog->findChild<Question*>()->yes());
        QCOMPARE(o.settings().get(setting::theme), u"light"_s);
    }
};

GRIPSCOPE_TEST(SettingsDialogTest)
#include "settings_dialog_test.moc"
