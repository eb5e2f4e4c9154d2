// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/context/connection_words.h"
#include "ui/help/help_windows.h"
#include "ui/shell/window_bars.h"
#include "ui/windows/question.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

/// Clicks and keys on the whole window.
class MainWindowTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsCutOffAtTheLeastSize_data();
    void nothingIsCutOffAtTheLeastSize();
    void theKeyboardReachesWhatAMessagePushedAway();
    void everyPageHasItsPlaceInTheRail();
    void keysChooseThePage();
    void armingIsAPersonsClick();
    void stopOnEveryPageStopsAndDisarms_data();
    void stopOnEveryPageStopsAndDisarms();
    void escapeStopsWhereverTheFocusIs_data();
    void escapeStopsWhereverTheFocusIs();
    void escapeStopsInADialogToo();
    void theManualOpensAtThePageOfTheScreen();
    void theManualIsSearched();
    void anErrorIsShownUntilItIsDismissed();
    void theOperatorIsKnownToTheSessions();
    void aLostGripperIsToldInWords();
    void aConnectionErrorGoesWithTheNextGoodConnection();
    void theRateIsTheMeasuredOne();
    void whatWasLostIsToldAsPastOnceNothingIs();
    void theHintOfAnAddressKeepsItsSigns();
    void aGripperThatComesBackGoesOn();
    void everythingThatCanBePressedIsLargeEnoughAndHasAName();
    void closingStopsTheGripper();
};

void MainWindowTest::nothingIsCutOffAtTheLeastSize_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("withMessage");
    for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history", "quality"})
        QTest::newRow(id) << QString::fromLatin1(id) << false;
    // The pages on which a squeeze may go wrong keep their room even under an error of two lines.
    for (const char* id : {"live", "inspect", "enroll"})
        QTest::addRow("%s with an error", id) << QString::fromLatin1(id) << true;
}

void MainWindowTest::nothingIsCutOffAtTheLeastSize()
{
    QFETCH(QString, id);
    QFETCH(bool, withMessage);
    WindowFixture f;
    if (withMessage)
        f.bench->messages().report(
            u"12 reports were lost during this squeeze, so it was not judged. Check the USB cable, then squeeze again. "_s
                .repeated(2));
    f.window->showPage(id);
    QCoreApplication::processEvents();
    const Page* page = f.window->currentPage();
    const QSize least = page->minimumSizeHint();
    QVERIFY2(page->width() >= least.width() && page->height() >= least.height(),
             qPrintable(u"it needs %1x%2 and has %3x%4"_s.arg(least.width())
                            .arg(least.height())
                            .arg(page->width())
                            .arg(page->height())));
    // A message takes nothing from the page, and makes the window neither larger nor hold its size.
    QCOMPARE(f.window->size(), QSize(1024, 640));
    QCOMPARE(f.window->minimumSize(), QSize(1024, 640));
    const auto* scroll = f.find<QScrollBar>("pageScroll");
    const QWidget* view = scroll->parentWidget();
    QCOMPARE(scroll->isVisible(), page->height() > view->height());
    QVERIFY(withMessage || !scroll->isVisible());
    QCOMPARE(scroll->maximum(), page->height() - view->height()); // all of it can be reached
    if (withMessage)
        f.click(f.find<QPushButton>("dismissButton"));
    QCOMPARE(f.window->size(), QSize(1024, 640)); // nor when it is gone
}

void MainWindowTest::theKeyboardReachesWhatAMessagePushedAway()
{
    WindowFixture f;
    f.window->showPage(u"enroll"_s);
    f.bench->messages().report(u"One line after another. "_s.repeated(40));
    QCoreApplication::processEvents();
    auto* scroll = f.find<QScrollBar>("pageScroll");
    const QWidget* view = scroll->parentWidget();
    QTRY_VERIFY(scroll->isVisible());
    int seen = 0;
    for (auto* button : f.window->currentPage()->findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || !button->isEnabled() || button->height() > view->height())
            continue;
        button->setFocus(Qt::TabFocusReason);
        if (QApplication::focusWidget() != button)
            continue;
        ++seen;
        QVERIFY2(view->rect().contains(QRect(button->mapTo(view, QPoint()), button->size())),
                 qPrintable(button->text()));
    }
    QVERIFY(seen > 0);
}

void MainWindowTest::everyPageHasItsPlaceInTheRail()
{
    WindowFixture f(false);
    for (Page* page : f.window->pages()) {
        f.click(f.find<QWidget>(qPrintable("rail-"_L1 + page->id())));
        QCOMPARE(f.window->currentPage(), page);
        QVERIFY(page->isVisible());
    }
}

void MainWindowTest::keysChooseThePage()
{
    WindowFixture f(false);
    for (int i = 0; i < 6; ++i) {
        QTest::keyClick(f.window.get(), static_cast<Qt::Key>(Qt::Key_1 + i), Qt::ControlModifier);
        QTRY_COMPARE(f.window->currentPage(), f.window->pages()[static_cast<std::size_t>(i)]);
    }
}

void MainWindowTest::armingIsAPersonsClick()
{
    WindowFixture f;
    QVERIFY(!f.bench->connection().armed());
    auto* arm = f.find<QPushButton>("armButton");
    f.click(arm);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTRY_VERIFY(arm->isChecked());
    f.click(arm);
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTRY_VERIFY(!arm->isChecked());
}

void MainWindowTest::stopOnEveryPageStopsAndDisarms_data()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history", "quality"})
        QTest::newRow(id) << QString::fromLatin1(id);
}

void MainWindowTest::stopOnEveryPageStopsAndDisarms()
{
    QFETCH(QString, id);
    WindowFixture f;
    f.click(f.find<QPushButton>("armButton"));
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    Recipe recipe;
    recipe.seconds = 5; // long enough to be stopped in the middle, however busy the machine
    f.bench->inspection().setRecipe(recipe);
    f.bench->inspection().setEarlyEnd(false); // decided, it would be over before
    QVERIFY(f.bench->inspection().squeeze());
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().port()->squeezeState() == SqueezeState::Running,
                             gripscope::test::longEnough_ms);
    f.window->showPage(id);
    QCOMPARE(f.window->currentPage()->id(), id);
    f.click(f.find<QPushButton>("stopButton"));
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().port()->squeezeState() == SqueezeState::Stopped,
                             gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().state() == InspectSession::State::Ready,
                             gripscope::test::longEnough_ms);
    QVERIFY(!f.bench->inspection().result()); // a stopped squeeze is not judged
    QTRY_VERIFY(!f.find<QPushButton>("armButton")->isChecked());
}

void MainWindowTest::escapeStopsWhereverTheFocusIs_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"operatorField", "trialButton", "rail-types", "deviceChip"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void MainWindowTest::escapeStopsWhereverTheFocusIs()
{
    QFETCH(QString, name);
    WindowFixture f(false);
    f.bench->arm();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    auto* widget = f.find<QWidget>(qPrintable(name));
    widget->setFocus();
    QSignalSpy stopped(f.bench.get(), &Workbench::stopped);
    QTest::keyClick(widget, Qt::Key_Escape);
    QVERIFY(stopped.count() >= 1);
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
}

void MainWindowTest::escapeStopsInADialogToo()
{
    WindowFixture f(false);
    f.bench->arm();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTest::keyClick(f.window.get(), Qt::Key_F1);
    QTRY_VERIFY(f.window->findChild<ManualWindow*>());
    WindowFixture::click(f.window->findChild<ManualWindow*>()->findChild<QPushButton*>(u"keysButton"_s));
    QTRY_VERIFY(f.window->findChild<AboutDialog*>());
    QTest::keyClick(f.window->findChild<AboutDialog*>(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTRY_VERIFY(!f.window->findChild<AboutDialog*>() || !f.window->findChild<AboutDialog*>()->isVisible());
}

void MainWindowTest::theManualOpensAtThePageOfTheScreen()
{
    WindowFixture f(false);
    for (const Page* page : f.window->pages()) {
        f.window->showPage(page->id());
        QTest::keyClick(f.window.get(), Qt::Key_F1);
        auto* manual = f.window->findChild<ManualWindow*>(); // one, that stays beside the work
        QVERIFY(manual && manual->isVisible());
        QCOMPARE(manual->browser()->page(), page->id() + u".md"_s);
        QCOMPARE(f.window->findChildren<ManualWindow*>().size(), 1);
        const QListWidgetItem* chosen = manual->findChild<QListWidget*>(u"manualPages"_s)->currentItem();
        QVERIFY(chosen && chosen->data(Qt::UserRole).toString() == manual->browser()->page());
    }
}

void MainWindowTest::theManualIsSearched()
{
    WindowFixture f(false);
    QTest::keyClick(f.window.get(), Qt::Key_F1);
    auto* manual = f.window->findChild<ManualWindow*>();
    auto* list = manual->findChild<QListWidget*>(u"manualPages"_s);
    auto* words = manual->findChild<QLineEdit*>(u"manualWords"_s);
    const int all = list->count();
    QVERIFY(all > 15);
    QTest::keyClicks(words, u"gauge blocks"_s);
    QVERIFY(list->count() >= 1 && list->count() < all);
    QTest::keyClick(words, Qt::Key_Return);
    QVERIFY(manual->browser()->toPlainText().contains(u"gauge"_s));
    QTest::keyClicks(words, u" qqqq"_s);
    QVERIFY(list->item(0)->flags() == Qt::NoItemFlags);
    QTest::keyClick(manual, Qt::Key_Escape);
    QTRY_VERIFY(!f.window->findChild<ManualWindow*>());
}

void MainWindowTest::anErrorIsShownUntilItIsDismissed()
{
    WindowFixture f(false);
    f.bench->messages().report(u"First."_s);
    f.bench->messages().report(u"Second."_s);
    QCOMPARE(f.window->message(), u"Second."_s);
    QPushButton* dismiss = nullptr;
    for (QPushButton* button : f.window->findChildren<QPushButton*>())
        if (button->text() == "Dismiss"_L1)
            dismiss = button;
    QVERIFY(dismiss && dismiss->isVisible());
    f.click(dismiss);
    QCOMPARE(f.window->message(), u"First."_s);
    f.click(dismiss);
    QVERIFY(f.window->message().isEmpty());
    QVERIFY(!dismiss->isVisible());
}

void MainWindowTest::theOperatorIsKnownToTheSessions()
{
    WindowFixture f(false);
    auto* field = f.find<QLineEdit>("operatorField");
    QCOMPARE(field->text(), u"Mai"_s);
    field->selectAll();
    QTest::keyClicks(field, u"Jo"_s);
    QCOMPARE(f.bench->operatorName(), u"Jo"_s);
}

void MainWindowTest::aConnectionErrorGoesWithTheNextGoodConnection()
{
    WindowFixture f(false, {});
    f.bench->connectTo(u"nonsense:"_s);
    QTRY_VERIFY(!f.window->message().isEmpty());
    const QString told = f.window->message();
    QTest::qWait(100);
    QCOMPARE(f.window->message(), told); // it holds
    f.connectTo(gripscope::test::unhurriedA);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->message() != told, gripscope::test::longEnough_ms);
    // With a gripper that works, what was typed is told and takes nothing away.
    f.bench->connectTo(u"nonsense:"_s);
    QTRY_COMPARE(f.window->message(), told);
    QVERIFY(f.bench->connection().state() == ConnectSession::State::Connected);
}

void MainWindowTest::theRateIsTheMeasuredOne()
{
    WindowFixture f(false, u"virtual:?object=A&seed=5&fault=loss:0.5"_s);
    ConnectSession& connection = f.bench->connection();
    QTRY_VERIFY_WITH_TIMEOUT(connection.counters().lostSamples > 2000, gripscope::test::longEnough_ms);
    const double nominal_kHz = 1e-3 / connection.identity().sampleTime_s;
    const QString stated = u"%1 kHz"_s.arg(nominal_kHz, 0, 'g', 2);
    const LinkCounters counters = connection.counters();
    // Half of the reports are lost: about half of the rate comes, and no more is said.
    QVERIFY(counters.sampleRate_Hz < 800 * nominal_kHz);
    QTRY_VERIFY2(!chipWords(connection).detail.startsWith(stated), qPrintable(chipWords(connection).detail));
    // And its sign is not that of a link that is well.
    QTRY_VERIFY(f.find<QWidget>("deviceChip")->accessibleDescription().contains(u"being lost"_s));
    QVERIFY(f.find<QWidget>("deviceChip")->toolTip().contains(u"loses "_s));
}

void MainWindowTest::whatWasLostIsToldAsPastOnceNothingIs()
{
    const QTemporaryDir folder;
    QFile script(folder.filePath(u"losses.txt"_s));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write("0 loss 0.5\n5 loss 0\n");
    script.close();
    WindowFixture f(false, u"virtual:?object=A&seed=5&script="_s + script.fileName());
    const auto* chip = f.find<QWidget>("deviceChip");
    QTRY_VERIFY_WITH_TIMEOUT(chip->accessibleDescription().contains(u"being lost"_s),
                             gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(chip->accessibleDescription().endsWith(u"lost earlier"_s),
                             gripscope::test::longEnough_ms);
}

void MainWindowTest::theHintOfAnAddressKeepsItsSigns()
{
    TextQuestion question(u"Connect"_s, u"such as virtual:?object=B&seed=7"_s, {}, u"Connect"_s, nullptr);
    question.setAttribute(Qt::WA_DeleteOnClose, false);
    for (const QLabel* label : question.findChildren<QLabel*>())
        QVERIFY2(!QString(label->text()).remove(u"&&"_s).contains(u'&') || !label->buddy(),
                 qPrintable(label->text()));
}

void MainWindowTest::aLostGripperIsToldInWords()
{
    WindowFixture f(false, u"virtual:?fault=unplug:0.3"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().state() == ConnectSession::State::Lost,
                             gripscope::test::longEnough_ms);
    QTRY_VERIFY(!f.window->message().isEmpty());
    QTRY_VERIFY(!f.find<QPushButton>("armButton")->isEnabled());
    const auto* status = f.window->findChild<StatusLine*>();
    QTRY_VERIFY(status->text().contains(u"lost"_s));
}

void MainWindowTest::aGripperThatComesBackGoesOn()
{
    WindowFixture f(false, u"virtual:?seed=3&fault=unplug:0.5,replug:1"_s);
    ConnectSession& connection = f.bench->connection();
    const auto* status = f.window->findChild<StatusLine*>();
    QTRY_VERIFY_WITH_TIMEOUT(connection.state() == ConnectSession::State::Lost,
                             gripscope::test::longEnough_ms);
    QTRY_COMPARE(f.window->message(), u"Gripper VG-3 went away: it was unplugged or switched off. Plug it in "
                                      "again: Gripscope goes on by itself."_s);
    QTRY_VERIFY(status->text().contains(u"Gripper VG-3 is away"_s));
    const double before_s = f.bench->live().history().newestTime_s();
    QTRY_VERIFY_WITH_TIMEOUT(connection.state() == ConnectSession::State::Connected,
                             gripscope::test::longEnough_ms);
    QTRY_VERIFY(f.window->message().isEmpty());
    QVERIFY(!connection.armed());
    const LiveHistory& history = f.bench->live().history();
    QTRY_VERIFY(history.newestTime_s() > before_s + 0.9); // the plots go on, behind the time without it
    const auto stretches = history.columns(LiveHistory::Channel::Force, history.newestTime_s(), 10, 400);
    QCOMPARE(stretches.size(), std::size_t(2));
}

void MainWindowTest::everythingThatCanBePressedIsLargeEnoughAndHasAName()
{
    WindowFixture f;
    for (const char* id : {"live", "inspect", "enroll"}) {
        f.window->showPage(QString::fromLatin1(id));
        QCoreApplication::processEvents();
        for (QAbstractButton* button : f.window->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->objectName() == "qt_clearbutton"_L1)
                continue;
            const QString name =
                button->accessibleName().isEmpty() ? button->text() : button->accessibleName();
            QVERIFY2(!name.isEmpty(), qPrintable(button->objectName()));
            QVERIFY2(button->height() >= metrics::touchTarget, qPrintable(name));
        }
    }
}

void MainWindowTest::closingStopsTheGripper()
{
    WindowFixture f(false);
    f.bench->arm();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    f.window->close();
    QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().armed(), gripscope::test::longEnough_ms);
}

GRIPSCOPE_TEST(MainWindowTest)
#include "main_window_test.moc"
