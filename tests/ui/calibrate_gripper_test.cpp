// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"

#include <QLabel>
#include <QPushButton>
#include <QTabBar>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

/// What a gripper is characterised by, with a virtual one whose fingers, and whose frame, are the object.
class CalibrateGripperTest : public QObject {
    Q_OBJECT
    static std::optional<MeasuringChainRecord> stored(WindowFixture& f)
    {
        using Found = std::optional<MeasuringChainRecord>;
        std::optional<Found> found;
        f.bench->background().ask<Found>(
            nullptr, [](Library& library) { return library.measuringChain(u"VG-5"_s); },
            [&](Expected<Found> record) { found = record.value(); });
        if (!QTest::qWaitFor([&] { return found.has_value(); }, longEnough_ms))
            qFatal("the library did not answer");
        return *found;
    }
    static QString newestReason(WindowFixture& f)
    {
        std::optional<QString> reason;
        f.bench->background().ask<QString>(
            nullptr,
            [](Library& library) {
                return library.auditTrail()
                    .entries({{}, u"chain.measured"_s, 1, 0})
                    .map([](const auto& found) { return found.empty() ? QString() : found.front().reason; });
            },
            [&](Expected<QString> found) { reason = found.value(); });
        if (!QTest::qWaitFor([&] { return reason.has_value(); }, longEnough_ms))
            qFatal("the library did not answer");
        return *reason;
    }

private slots:
    void aPersonMeasuresTheEmptyGripperAndTakesItOff()
    {
        WindowFixture f(false, u"virtual:?object=0.012,9,3000&seed=5&speed=0"_s);
        f.window->showPage(u"calibrate"_s);
        auto* tabs = f.find<QTabBar>("calibrateTabs");
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(2).center());
        QVERIFY(f.find<QLabel>("baselineMeaning")->text().startsWith(u"Nothing"_s));
        QVERIFY(!f.find<QPushButton>("baselineRemove")->isVisible());
        auto* act = f.find<QPushButton>("baselineAct");
        QCOMPARE(act->text(), u"Arm"_s);
        f.click(act);
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Squeeze nothing"_s), longEnough_ms);
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Take it off from now on"_s, longEnough_ms);
        QVERIFY(!stored(f)); // nothing before it is accepted
        f.click(act);
        f.sayWhy(u"new fingers"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().measuringChain().baseline, longEnough_ms);
        const auto kept = stored(f);
        QVERIFY(kept && kept->chain.baseline && kept->operatorName == u"Mai"_s);
        QVERIFY(std::abs(kept->chain.baseline->parameters[2] / 3000 - 1) < 0.05);
        QVERIFY(kept->chain.friction && kept->chain.friction->standardError > 0);
        QTRY_VERIFY(f.find<QPushButton>("baselineRemove")->isVisible());
        QCOMPARE(newestReason(f), u"new fingers"_s);
        f.click(f.find<QPushButton>("baselineRemove"));
        f.sayWhy(u"fingers taken off"_s);
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->connection().measuringChain().baseline, longEnough_ms);
        QVERIFY(!stored(f)->chain.baseline && !stored(f)->chain.friction);
        QCOMPARE(newestReason(f), u"fingers taken off"_s);
    }

    void theFrameFollowsAndBothAreKnownSinceWhen()
    {
        // What is measured of the frame is measured on a block that gives 1 µm a newton.
        WindowFixture f(false, u"virtual:?object=0.05,100,1e6&seed=5&speed=0"_s);
        f.window->showPage(u"calibrate"_s);
        f.find<QTabBar>("calibrateTabs")->setCurrentIndex(2);
        f.click(f.find<QPushButton>("nextFrame"));
        auto* act = f.find<QPushButton>("frameAct");
        QTRY_VERIFY(act->isVisible());
        f.click(act); // arms
        QTRY_VERIFY_WITH_TIMEOUT(act->text().startsWith(u"Squeeze the block"_s), longEnough_ms);
        QTest::keyClick(f.page(u"calibrate"_s), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(act->text(), u"Take it off from now on"_s, longEnough_ms);
        f.click(act);
        f.sayWhy(u"new frame"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().measuringChain().frameCompliance > 0, longEnough_ms);
        const auto kept = stored(f);
        QVERIFY(kept && std::abs(kept->chain.frameCompliance / 1e-6 - 1) < 0.1);
        QVERIFY(!kept->chain.baseline); // of the empty gripper nobody has measured anything
        const QString today = QDate::currentDate().toString(Qt::ISODate);
        QTRY_VERIFY(f.find<QLabel>("knownFrame")->text().contains(today + u", Mai"_s));
        QVERIFY(f.find<QLabel>("knownEmpty")->text().endsWith(u"not measured"_s));
        f.click(f.find<QPushButton>("nextLag"));
        QTRY_VERIFY(f.find<QPushButton>("lagAct")->isVisible());
    }

    void withoutAGripperItSaysWhatToDo()
    {
        WindowFixture f(false, {});
        f.window->showPage(u"calibrate"_s);
        f.find<QTabBar>("calibrateTabs")->setCurrentIndex(2);
        QVERIFY(!f.find<QPushButton>("baselineAct")->isEnabled());
        QVERIFY(f.find<QLabel>("baselineOutcome")->text().startsWith(u"No gripper is connected"_s));
    }
};

GRIPSCOPE_TEST(CalibrateGripperTest)
#include "calibrate_gripper_test.moc"
