// SPDX-License-Identifier: GPL-3.0-or-later
// Other units while the program runs: every page is in them at once, and no number changes for it.
#include "core/base/display_units.h"
#include "tests/support/test_registry.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/chosen_units.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/desktop_session.h"
#include "ui/widgets/quantity_box.h"
#include "ui/widgets/quantity_list_edit.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

constexpr DisplayUnits pounds{DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch};

/// The window as the program has it, on its own library.
struct Hosted {
    WindowFixture f;
    std::unique_ptr<WindowHost> host;

    explicit Hosted(bool examples = false) : f(examples, u"virtual:"_s)
    {
        f.window.reset();
        f.bench->settings().set(setting::stopExplained, true);
        host = std::make_unique<WindowHost>(*f.bench);
        host->window().show();
    }
    template <typename T>
    [[nodiscard]] T* find(const char* name) const
    {
        T* widget = host->window().findChild<T*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget %s", name);
        return widget;
    }
    /// The field of the page that is shown which has this name for people.
    [[nodiscard]] QuantityBox* box(const QString& name) const
    {
        for (QuantityBox* one : host->window().currentPage()->findChildren<QuantityBox*>())
            if (one->accessibleName() == name)
                return one;
        qFatal("there is no field %s", qPrintable(name));
    }
    void ask(const char* force, const char* length) const
    {
        f.bench->settings().set(setting::forceUnit, QString::fromLatin1(force));
        f.bench->settings().set(setting::lengthUnit, QString::fromLatin1(length));
    }
    [[nodiscard]] bool choose(const char* force, const char* length) const
    {
        ask(force, length);
        return QTest::qWaitFor([this] { return DisplayUnits::current() == chosenUnits(f.bench->settings()); },
                               longEnough_ms);
    }
    [[nodiscard]] bool toTheRecipe() const
    {
        host->window().showPage(u"enroll"_s);
        QTest::keyClicks(find<QLineEdit>("typeName"), u"Cola 330 ml"_s);
        QTest::keyClick(find<QLineEdit>("typeName"), Qt::Key_Return);
        return QTest::qWaitFor([this] { return f.bench->enrollment().step() == EnrollSession::Step::Recipe; },
                               longEnough_ms);
    }
};

bool say(const QStringList& texts, const QString& word)
{
    return std::any_of(texts.begin(), texts.end(),
                       [&word](const QString& text) { return text.contains(word); });
}

QString inEnglish(const QuantityBox& box)
{
    return box.text().replace(QChar(QChar::Nbsp), u' ');
}

} // namespace

class DisplayUnitsSwitchTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { DisplayUnits::choose({}); }

    void theyAreStoredAndHoldAtTheNextStart()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"settings.ini"_s);
        {
            Settings settings(file);
            QCOMPARE(chosenUnits(settings), DisplayUnits());
            settings.set(setting::forceUnit, u"kgf"_s);
            settings.set(setting::lengthUnit, u"in"_s);
            QVERIFY(!settings.setValue(u"units/force"_s, u"stone"_s));
        }
        const DisplayUnits expected{DisplayUnits::Force::KilogramForce, DisplayUnits::Length::Inch};
        QCOMPARE(chosenUnits(Settings(file)), expected);
        WindowFixture f(false, QString());
        f.window.reset();
        f.bench->settings().set(setting::forceUnit, u"kgf"_s);
        f.bench->settings().set(setting::lengthUnit, u"in"_s);
        const WindowHost host(*f.bench);
        QCOMPARE(DisplayUnits::current(), expected);
    }

    void theyAreChosenInTheSettings()
    {
        const Hosted h;
        h.host->window().showPage(u"live"_s);
        h.host->window().showSettings();
        auto* box = h.find<QComboBox>("setting-units/force");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(DisplayUnits::current().force, DisplayUnits::Force::PoundForce,
                                  longEnough_ms);
        QCOMPARE(DisplayUnits::current().length, DisplayUnits::Length::Metre);
        QCOMPARE(h.host->window().currentPage()->id(), u"live"_s);
        QVERIFY(h.host->window().findChild<SettingsDialog*>()); // open again
        QCOMPARE(h.find<QComboBox>("setting-units/force")->currentText(), u"lbf"_s);
    }

    void everyPageFollowsAtOnce_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("word"); // of what it says then
        QTest::newRow("live") << u"live"_s << u"lbf"_s;
        QTest::newRow("inspect") << u"inspect"_s << u"lbf/in"_s;
        QTest::newRow("enroll") << u"enroll"_s << u"lbf"_s;
        QTest::newRow("types") << u"types"_s << u"lb"_s;
        QTest::newRow("fit") << u"fit"_s << u"lbf/in"_s;
        QTest::newRow("calibrate") << u"calibrate"_s << u"lbf"_s;
        QTest::newRow("history") << u"history"_s << u"lbf/in"_s;
    }
    void everyPageFollowsAtOnce()
    {
        QFETCH(QString, id);
        QFETCH(QString, word);
        const Hosted h(true);
        MainWindow& before = h.host->window();
        before.resize(1440, 900);
        before.showPage(id);
        Page* page = before.currentPage();
        page->prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page->tourReady(), longEnough_ms);
        before.showPage(id); // what a tour does may lead elsewhere
        QTRY_VERIFY_WITH_TIMEOUT(!metricTexts(shownTexts(before)).isEmpty(), longEnough_ms);
        QVERIFY(h.choose("lbf", "in"));
        MainWindow& after = h.host->window();
        QCOMPARE(after.currentPage()->id(), id);
        QTRY_VERIFY_WITH_TIMEOUT(say(shownTexts(after), word), longEnough_ms);
        const QStringList stray = metricTexts(shownTexts(after));
        QVERIFY2(stray.isEmpty(), qPrintable(stray.join(u'\n')));
        QVERIFY(h.choose("N", "mm"));
        QTRY_VERIFY_WITH_TIMEOUT(!metricTexts(shownTexts(h.host->window())).isEmpty(), longEnough_ms);
        const QStringList texts = shownTexts(h.host->window());
        QVERIFY2(!say(texts, u"lbf"_s), qPrintable(texts.join(u'\n')));
    }

    void aLimitThatIsTypedStaysWhatItIs()
    {
        const Hosted h;
        QVERIFY(h.toTheRecipe());
        h.box(u"Preload"_s)->setValue(5);
        h.box(u"Push and release"_s)->setValue(3);
        h.box(u"Crush limit"_s)->setValue(10);
        h.box(u"Travel limit"_s)->setValue(7);
        QVERIFY(h.choose("lbf", "in"));
        QCOMPARE(inEnglish(*h.box(u"Crush limit"_s)), QLocale().toString(2.25, 'f', 2) + u" lbf"_s);
        QCOMPARE(inEnglish(*h.box(u"Travel limit"_s)), QLocale().toString(0.2756, 'f', 4) + u" in"_s);
        QVERIFY(h.box(u"Crush limit"_s)->si() == 10.0); // to the bit
        QVERIFY(h.choose("kgf", "mm"));
        QVERIFY(h.box(u"Crush limit"_s)->si() == 10.0);
        QVERIFY(h.choose("N", "mm"));
        QCOMPARE(inEnglish(*h.box(u"Crush limit"_s)), QLocale().toString(10.0, 'f', 1) + u" N"_s);
        QVERIFY(h.box(u"Crush limit"_s)->si() == 10.0);
        QVERIFY(h.box(u"Travel limit"_s)->si() == 7e-3);
        WindowFixture::click(h.find<QPushButton>("recipeNext"));
        QTRY_COMPARE_WITH_TIMEOUT(h.f.bench->enrollment().step(), EnrollSession::Step::Squeeze,
                                  longEnough_ms);
        QVERIFY(h.f.bench->enrollment().recipe().maxForce_N == 10.0);
        QVERIFY(h.f.bench->enrollment().recipe().bias_N == 5.0);
    }

    void loadsOfACalibrationStayWhatTheyAre()
    {
        const Hosted h;
        h.host->window().showPage(u"calibrate"_s);
        h.find<QComboBox>("calibrationChannel")->setCurrentIndex(2); // gauge blocks
        h.find<QLineEdit>("calibrationLoads")->setText(u"0, 10, 25.4"_s);
        h.find<QuantityBox>("calibrationUncertainty")->setValue(0.002);
        QVERIFY(h.choose("lbf", "in"));
        QCOMPARE(h.find<QComboBox>("calibrationChannel")->currentIndex(), 2);
        const auto loads = h.find<QuantityListEdit>("calibrationLoads")->si();
        QVERIFY(loads);
        QCOMPARE(loads->size(), std::size_t(3));
        QCOMPARE(loads->at(1), 10e-3);
        QCOMPARE(loads->at(2), 25.4e-3);
        QCOMPARE(h.find<QLineEdit>("calibrationLoads")->text(), u"0, 0.393701, 1"_s);
        QCOMPARE(h.find<QuantityBox>("calibrationUncertainty")->si(), 2e-6);
        QVERIFY(h.find<QuantityBox>("calibrationUncertainty")->text().endsWith(u"in"_s));
        QVERIFY(h.choose("N", "mm"));
        QCOMPARE(h.find<QLineEdit>("calibrationLoads")->text(), u"0, 10, 25.4"_s);
        QCOMPARE(h.find<QuantityBox>("calibrationUncertainty")->value(), 0.002);
    }

    void aCalibrationUnderWayIsNotLost()
    {
        const Hosted h;
        h.host->window().showPage(u"calibrate"_s);
        h.find<QComboBox>("calibrationChannel")->setCurrentIndex(1); // a load cell
        QTest::keyClicks(h.find<QLineEdit>("calibrationReference"), u"Load cell 7"_s);
        QTRY_VERIFY_WITH_TIMEOUT(h.find<QPushButton>("calibrationBegin")->isEnabled(), longEnough_ms);
        WindowFixture::click(h.find<QPushButton>("calibrationBegin"));
        QVERIFY(h.host->window().currentPage()->underWay());
        h.ask("lbf", "in");
        QTRY_VERIFY_WITH_TIMEOUT(h.host->window().message().contains(u"Calibrate page"_s), longEnough_ms);
        QCOMPARE(DisplayUnits::current(), DisplayUnits());
        QVERIFY(h.host->window().currentPage()->underWay());
        WindowFixture::click(h.find<QPushButton>("calibrationAbandon"));
        QTRY_COMPARE_WITH_TIMEOUT(DisplayUnits::current(), pounds, longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!h.host->window().message().contains(u"Calibrate page"_s), longEnough_ms);
        QVERIFY(!h.host->window().currentPage()->underWay());
    }

    void whatIsTypedNeverLeavesTheRange()
    {
        DisplayUnits::choose(pounds);
        QuantityBox box(fieldUnit(MechanicalQuantity::Force), {0.1, 1000}, 0.1);
        box.setValue(box.maximum()); // 224.81 lbf, which are a little more
        QCOMPARE(box.si(), 1000.0);
        box.setValue(box.minimum());
        QCOMPARE(box.si(), 0.1);
    }
    void aNumberTooFineToBeShownIsToldToo()
    {
        QuantityBox box(fieldUnit(MechanicalQuantity::Force), {0, 1000}, 0.1);
        box.setSi(30);
        const QSignalSpy told(&box, &QDoubleSpinBox::valueChanged);
        box.setSi(30.02);
        QCOMPARE(told.count(), 1);
        QVERIFY(box.si() == 30.02);
        box.setSi(30.02);
        QCOMPARE(told.count(), 1);
    }
};

GRIPSCOPE_TEST(DisplayUnitsSwitchTest)
#include "display_units_switch_test.moc"
