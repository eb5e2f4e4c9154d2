// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/people_window.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/pages/fit/opened_recordings.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

/// States of Live, Fit, Types, Calibrate and History beside those of the tour, and the header where people
/// sign in.
class StateLayoutTest : public QObject {
    Q_OBJECT

    static void showAtWork(const WindowFixture& f, const QString& id)
    {
        f.window->showPage(id);
        f.page(id)->prepareTour();
        QTRY_VERIFY(f.page(id)->tourReady());
    }

private slots:
    void history_data() { languageRows(); }
    void history()
    {
        const RowLanguage language;
        WindowFixture f(true, QString());
        LayoutWalk walk(*f.window);
        showAtWork(f, u"history"_s);
        f.click(f.find<QPushButton>("historyMore"));
        auto* period = f.find<QComboBox>("historyPeriod");
        period->setCurrentIndex(period->count() - 1); // from one day to another
        QTRY_VERIFY(f.page(u"history"_s)->tourReady());
        walk.whereTight(u"filters"_s);
        auto* table = f.find<QTableView>("historyTable");
        table->selectionModel()->select(
            QItemSelection(table->model()->index(0, 0), table->model()->index(2, 0)),
            QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
        walk.whereTight(u"several chosen"_s);
        f.click(f.find<QPushButton>("historyCharts"));
        QTest::qWait(300); // the points come from the library
        walk.whereTight(u"charts and filters"_s);
        QTest::keyClicks(f.find<QLineEdit>("historyText"), u"no such type"_s);
        QTRY_COMPARE(table->model()->rowCount(), 0);
        walk.whereTight(u"nothing found"_s);
        QVERIFY(walk.sound());
    }

    void calibrate_data() { languageRows(); }
    void calibrate()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:"_s);
        LayoutWalk walk(*f.window);
        showAtWork(f, u"calibrate"_s);
        auto* tabs = f.find<QTabBar>("calibrateTabs");
        for (int tab = 1; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            walk.whereTight(u"tab "_s + tabs->tabText(tab));
        }
        tabs->setCurrentIndex(0);
        auto* channel = f.find<QComboBox>("calibrationChannel");
        for (int way = 1; way < channel->count(); ++way) {
            channel->setCurrentIndex(way);
            walk.whereTight(u"way "_s + channel->currentText());
        }
        channel->setCurrentIndex(1); // a load cell, whose reading is typed
        f.find<QLineEdit>("calibrationLoads")->setText(u"0, 10"_s);
        QTest::keyClicks(f.find<QLineEdit>("calibrationReference"), u"7"_s);
        f.clickWhenEnabled(f.find<QPushButton>("calibrationBegin"));
        const auto* points = f.find<QTableView>("calibrationPoints");
        QVERIFY(points->isVisible());
        walk.whereTight(u"taking"_s);
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
        QTRY_VERIFY(!points->model()->index(0, 3).data().toString().isEmpty());
        walk.whereTight(u"taking, one taken"_s);
        for (int point = 1; point < points->model()->rowCount(); ++point) { // none of them follows the load
            QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
            QTRY_VERIFY(!points->model()->index(point, 3).data().toString().isEmpty());
        }
        QTRY_VERIFY(f.find<QPushButton>("calibrationAccept")->isVisible());
        walk.whereTight(u"taken, to be decided"_s);
        f.click(f.find<QPushButton>("calibrationAbandon"));
        QVERIFY(walk.sound());
    }

    void gripperMeasured_data() { languageRows(); }
    void gripperMeasured()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:?object=0.012,9,3000&seed=5&speed=0"_s);
        LayoutWalk walk(*f.window);
        f.window->showPage(u"calibrate"_s);
        f.find<QTabBar>("calibrateTabs")->setCurrentIndex(2);
        auto* act = f.find<QPushButton>("baselineAct");
        const QString arm = act->text();
        f.clickWhenEnabled(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->isEnabled() && act->text() != arm, longEnough_ms);
        const QString squeeze = act->text();
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(!f.find<QLabel>("baselineOutcome")->text().isEmpty() && act->isEnabled() &&
                                     act->text() != squeeze,
                                 longEnough_ms);
        walk.whereTight(u"measured"_s);
        f.click(act);
        f.sayWhy(u"new fingers"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().measuringChain().baseline, longEnough_ms);
        QTRY_VERIFY(f.find<QPushButton>("baselineRemove")->isVisible());
        walk.whereTight(u"in use"_s);
        auto* steps = f.find<QTabBar>("gripperSteps");
        for (int step = 1; step < steps->count(); ++step) {
            steps->setCurrentIndex(step);
            walk.whereTight(u"step "_s + steps->tabText(step));
        }
        QVERIFY(walk.sound());
    }

    void fitOfSeveralRecordings_data() { languageRows(); }
    void fitOfSeveralRecordings()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:"_s);
        LayoutWalk walk(*f.window);
        const QTemporaryDir folder;
        QStringList files;
        for (const QString& name : {u"a.csv"_s, u"b.csv"_s}) {
            files << folder.filePath(name);
            QVERIFY(writeRecordingCsv(simulatedSqueeze({0.0396, 43, 9990}, std::uint64_t(files.size())),
                                      files.back()));
        }
        f.window->showPage(u"fit"_s);
        f.window->findChild<FitPage*>()->openRecordings(files);
        const auto* opened = f.find<OpenedRecordings>("openedRecordings");
        QTRY_VERIFY_WITH_TIMEOUT(opened->isVisible() && !opened->isReading(), longEnough_ms);
        walk.whereTight(u"two recordings"_s);
        QVERIFY(walk.sound());
    }

    void liveHeldAndMeasured_data() { languageRows(); }
    void liveHeldAndMeasured()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:"_s);
        LayoutWalk walk(*f.window);
        showAtWork(f, u"live"_s);
        f.click(f.find<QWidget>("markerButton"));
        f.click(f.find<QWidget>("pauseButton"));
        walk.whereTight(u"paused"_s);
        QVERIFY(walk.sound());
    }

    void typesByCluster_data() { languageRows(); }
    void typesByCluster()
    {
        const RowLanguage language;
        WindowFixture f(true, QString());
        LayoutWalk walk(*f.window);
        showAtWork(f, u"types"_s);
        f.click(f.find<QPushButton>("byCluster"));
        QTRY_VERIFY(f.page(u"types"_s)->tourReady());
        walk.whereTight(u"by cluster"_s);
        QVERIFY(walk.sound());
    }

    void wherePeopleSignIn_data() { languageRows(); }
    void wherePeopleSignIn()
    {
        const RowLanguage language;
        PeopleWindow f(u"virtual:"_s);
        LayoutWalk walk(*f.window);
        f.window->showPage(u"inspect"_s);
        walk.whereTight(u"nobody has signed in"_s);
        f.signInOlli();
        walk.whereTight(u"Olli has signed in"_s);
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(StateLayoutTest)
#include "state_layout_test.moc"
