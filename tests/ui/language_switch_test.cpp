// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/context/language.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/shell/window_bars.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

/// Another language while the program runs: the window is a new one, the work goes on.
class LanguageSwitchTest : public QObject {
    Q_OBJECT

    template <typename T>
    static T* find(const WindowHost& host, const char* name)
    {
        T* widget = host.window().findChild<T*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget %s", name);
        return widget;
    }
    static QString railWord(const WindowHost& host, const char* name)
    {
        return find<RailButton>(host, name)->text();
    }

private slots:
    void cleanup() { QVERIFY(applyLanguage(u"en"_s)); }

    void itIsChosenInTheSettings()
    {
        WindowFixture f(false, QString());
        f.window.reset();
        const WindowHost host(*f.bench);
        host.window().show();
        QCOMPARE(railWord(host, "rail-inspect"), u"Inspect"_s);
        host.window().showPage(u"types"_s);
        f.bench->messages().report(u"Read me."_s);
        host.window().showSettings();
        auto* box = find<QComboBox>(host, "setting-language");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        QTRY_COMPARE(railWord(host, "rail-inspect"), u"Prüfen"_s);
        QCOMPARE(host.window().currentPage()->id(), u"types"_s);
        QCOMPARE(host.window().message(), u"Read me."_s);
        QVERIFY(host.window().isVisible());
        // The Settings window is open again, and back it goes.
        QVERIFY(host.window().findChild<SettingsDialog*>());
        f.bench->settings().set(setting::language, u"en"_s);
        QTRY_COMPARE(railWord(host, "rail-inspect"), u"Inspect"_s);
    }

    void aRecipeThatIsBeingTypedStays()
    {
        WindowFixture f(false);
        f.window.reset();
        const WindowHost host(*f.bench);
        host.window().show();
        host.window().showPage(u"enroll"_s);
        QTest::keyClicks(find<QLineEdit>(host, "typeName"), u"Cola 330 ml"_s);
        f.bench->settings().set(setting::language, u"de"_s);
        QTRY_COMPARE(railWord(host, "rail-enroll"), u"Einlernen"_s);
        QCOMPARE(find<QLineEdit>(host, "typeName")->text(), u"Cola 330 ml"_s);
        QTest::keyClick(find<QLineEdit>(host, "typeName"), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Recipe,
                                  gripscope::test::longEnough_ms);
        QList<double> typed;
        for (QDoubleSpinBox* field : host.window().currentPage()->findChildren<QDoubleSpinBox*>()) {
            field->setValue(field->value() * 0.9);
            typed << field->value();
        }
        QVERIFY(typed.size() >= 4);
        f.bench->settings().set(setting::language, u"en"_s);
        QTRY_COMPARE(railWord(host, "rail-enroll"), u"Enroll"_s);
        QList<double> found;
        for (const QDoubleSpinBox* field : host.window().currentPage()->findChildren<QDoubleSpinBox*>())
            found << field->value();
        QCOMPARE(found, typed);
    }

    void aHalfFinishedEnrolmentGoesOn()
    {
        WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
        f.window.reset();
        const WindowHost host(*f.bench);
        host.window().show();
        host.window().showPage(u"enroll"_s);
        QTest::keyClicks(find<QLineEdit>(host, "typeName"), u"Cola 330 ml"_s);
        QTest::keyClick(find<QLineEdit>(host, "typeName"), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Recipe,
                                  gripscope::test::longEnough_ms);
        WindowFixture::click(find<QPushButton>(host, "recipeNext"));
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Squeeze,
                                  gripscope::test::longEnough_ms);
        find<QCheckBox>(host, "acceptByItself")->setChecked(false); // each is decided on here
        const auto squeezeAndAccept = [&] {
            if (!f.bench->connection().armed())
                WindowFixture::click(find<QPushButton>(host, "enrollArmButton"));
            auto* squeeze = find<QPushButton>(host, "enrollSqueezeButton");
            QTRY_VERIFY_WITH_TIMEOUT(squeeze->isEnabled(), gripscope::test::longEnough_ms);
            WindowFixture::click(squeeze);
            auto* accept = find<QPushButton>(host, "acceptButton");
            QTRY_VERIFY_WITH_TIMEOUT(accept->isVisible() && accept->isEnabled(),
                                     gripscope::test::longEnough_ms);
            WindowFixture::click(accept);
        };
        squeezeAndAccept();
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);

        const QSignalSpy stopped(f.bench.get(), &Workbench::stopped);
        f.bench->settings().set(setting::language, u"de"_s);
        QTRY_COMPARE(railWord(host, "rail-enroll"), u"Einlernen"_s);
        QVERIFY(stopped.isEmpty());
        QCOMPARE(f.bench->enrollment().step(), EnrollSession::Step::Squeeze);
        QCOMPARE(f.bench->enrollment().acceptedCount(), 1);
        squeezeAndAccept();
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 2, gripscope::test::longEnough_ms);
    }
};

GRIPSCOPE_TEST(LanguageSwitchTest)
#include "language_switch_test.moc"
