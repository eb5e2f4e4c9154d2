// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/feed/live_view.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

/// Which time the Live page shows.
class LiveViewTest : public QObject {
    Q_OBJECT

    /// 10 s chosen of 100 s to 200 s.
    static LiveView held()
    {
        LiveView view;
        view.setSpan(10);
        view.hold(100, 200, 0.01);
        return view;
    }

private slots:
    void followsTheNewestWhileItRuns()
    {
        LiveView view;
        view.setSpan(60);
        view.follow(12.5);
        QCOMPARE(view.until_s(), 12.5);
        QCOMPARE(view.seconds(), 60.0);
        view.zoom(2, 0.5);
        view.pan(-1);
        QCOMPARE(view.until_s(), 12.5);
        QCOMPARE(view.seconds(), 60.0);
    }
    void staysWhereItIsWhileHeld()
    {
        LiveView view = held();
        view.follow(210);
        QCOMPARE(view.until_s(), 200.0);
        view.release();
        view.follow(210);
        QCOMPARE(view.until_s(), 210.0);
    }
    void zoomKeepsTheTimeBelowThePointer_data()
    {
        QTest::addColumn<double>("share");
        for (const double share : {0.0, 0.25, 0.5, 1.0})
            QTest::newRow(qPrintable(QString::number(share))) << share;
    }
    void zoomKeepsTheTimeBelowThePointer()
    {
        QFETCH(double, share);
        LiveView view = held();
        const double pointed_s = view.from_s() + share * view.seconds();
        view.zoom(4, share);
        QCOMPARE(view.seconds(), 2.5);
        QVERIFY(std::abs(view.from_s() + share * view.seconds() - pointed_s) < 1e-9);
        QVERIFY(view.changed());
    }
    void zoomEndsAtAFewSamplesAndAtAllThereIs()
    {
        LiveView view = held();
        view.zoom(1e9, 0.5);
        QCOMPARE(view.seconds(), 0.01);
        view.zoom(1e-9, 0.5);
        QCOMPARE(view.seconds(), 100.0);
        QCOMPARE(view.from_s(), 100.0);
        QCOMPARE(view.until_s(), 200.0);
    }
    void panEndsWhereTheTimeEnds()
    {
        LiveView view = held();
        view.pan(-0.5);
        QCOMPARE(view.until_s(), 195.0);
        view.pan(-1000);
        QCOMPARE(view.from_s(), 100.0);
        view.pan(1000);
        QCOMPARE(view.until_s(), 200.0);
    }
    void resetGoesBackToWhatWasChosen()
    {
        LiveView view = held();
        view.zoom(3, 0.2);
        view.pan(-2);
        view.reset();
        QVERIFY(!view.changed());
        QCOMPARE(view.until_s(), 200.0);
        QCOMPARE(view.seconds(), 10.0);
    }
    void showBringsATimeIntoViewAndElseMovesNothing()
    {
        LiveView view = held();
        view.show(195);
        QCOMPARE(view.until_s(), 200.0);
        view.show(150);
        QCOMPARE(view.from_s(), 145.0);
        view.show(100);
        QCOMPARE(view.from_s(), 100.0);
    }
    void aShortHistoryIsStillShownWithTheTimeChosen()
    {
        LiveView view;
        view.setSpan(60);
        view.hold(0, 5, 0.01);
        QCOMPARE(view.seconds(), 60.0);
        view.zoom(0.5, 0.5);
        QCOMPARE(view.seconds(), 60.0);
        view.zoom(60, 1);
        QCOMPARE(view.seconds(), 1.0);
        QCOMPARE(view.until_s(), 5.0);
    }
};

GRIPSCOPE_TEST(LiveViewTest)
#include "live_view_test.moc"
