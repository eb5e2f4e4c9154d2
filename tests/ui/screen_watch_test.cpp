// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "tests/support/test_registry.h"
#include "tests/ui/screen_watch.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/models/history_model.h"

#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::ScreenWatch;
using gripscope::test::WindowFixture;

namespace {

/// Nothing may hold up the screen's thread for over 50 ms; four times that here, for a busy machine.
constexpr double longestBlock_ms = 200;
constexpr int storedInspections = 2000;

/// A library as it is after some days: inspections with their squeezes.
Expected<void> fill(Library& library)
{
    NewInspection inspection;
    inspection.grasp.source = u"virtual:"_s;
    inspection.grasp.operatorName = u"Mai"_s;
    inspection.grasp.forceUnit = u"N"_s;
    inspection.grasp.positionUnit = u"m"_s;
    inspection.verdict.kind = VerdictKind::Type;
    inspection.verdict.type = u"A"_s;
    inspection.seconds = 1;
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    for (int i = 0; i < storedInspections; ++i) {
        const double scatter = 1 + 0.03 * std::sin(i);
        estimate.parameters = MassDampingStiffness{0.02 * scatter, 30 * scatter, 9990 * scatter};
        inspection.grasp.estimates = {estimate};
        if (const auto added = library.addInspection(inspection); !added)
            return tl::unexpected<Error>(added.error());
    }
    return {};
}

} // namespace

/// Whatever is done, the screen goes on answering.
class ScreenWatchTest : public QObject {
    Q_OBJECT

    static void live(WindowFixture& f, ScreenWatch& watch)
    {
        watch.step(u"live"_s);
        f.window->showPage(u"live"_s);
        QTest::qWait(500);
        watch.step(u"live, paused"_s);
        f.click(f.find<QPushButton>("pauseButton"));
        for (const Qt::Key key : {Qt::Key_Plus, Qt::Key_Left, Qt::Key_M, Qt::Key_Minus, Qt::Key_Home})
            QTest::keyClick(f.window->focusWidget(), key);
        QTest::qWait(50);
        f.click(f.find<QPushButton>("pauseButton"));
    }
    static void inspect(WindowFixture& f, ScreenWatch& watch)
    {
        watch.step(u"inspect"_s);
        f.window->showPage(u"inspect"_s);
        auto* squeeze = f.find<QPushButton>("squeezeButton");
        const qint64 before = f.bench->inspection().counts().total;
        QVERIFY(f.inRealTime([squeeze] { WindowFixture::clickWhenEnabled(squeeze); },
                             [&] { return f.bench->inspection().counts().total > before; }));
        QTRY_VERIFY_WITH_TIMEOUT(!f.bench->squeezing(), gripscope::test::longEnough_ms);
    }
    static void enroll(WindowFixture& f, ScreenWatch& watch)
    {
        watch.step(u"enroll"_s);
        f.window->showPage(u"enroll"_s);
        auto* name = f.find<QLineEdit>("typeName");
        QTest::keyClicks(name, u"Cola"_s);
        QTest::keyClick(name, Qt::Key_Return);
        f.click(f.find<QPushButton>("recipeNext"));
        auto* squeeze = f.find<QPushButton>("enrollSqueezeButton");
        QVERIFY(f.inRealTime([squeeze] { WindowFixture::clickWhenEnabled(squeeze); },
                             [&f] { return f.bench->enrollment().acceptedCount() > 0; }));
    }
    static void lookAtPages(WindowFixture& f, ScreenWatch& watch)
    {
        for (const QString& id : {u"types"_s, u"calibrate"_s, u"history"_s}) {
            watch.step(id);
            f.window->showPage(id);
            QTest::qWait(700);
        }
        auto* history = f.page(u"history"_s)->findChild<QTableView*>();
        QTRY_VERIFY_WITH_TIMEOUT(history->model()->rowCount() > 100, gripscope::test::longEnough_ms);
        history->scrollToBottom();
        QTest::qWait(300);
        history->scrollToTop();
        QTest::qWait(300); // for the rows there
        watch.step(u"fit"_s);
        history->selectRow(0);
        QTest::keyClick(history, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.window->currentPage()->id(), u"fit"_s, gripscope::test::longEnough_ms);
        QTest::qWait(1500); // estimators, checks, budget
    }

private slots:
    void aBlockIsSeen()
    {
        ScreenWatch watch;
        QTest::qWait(100);
        watch.step(u"asleep"_s);
        QTest::qWait(20);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        QTest::qWait(20);
        watch.step(u"awake"_s);
        QTest::qWait(100);
        QVERIFY(watch.longest_ms()[u"asleep"_s] > 250);
        QVERIFY(watch.longest_ms()[u"awake"_s] < longestBlock_ms);
        QVERIFY(watch.answers() > 10);
    }
    void theScreenAnswersOnEveryPage()
    {
        WindowFixture f;
        bool filled = false;
        f.bench->background().ask<void>(nullptr, fill,
                                        [&](const Expected<void>& done) { filled = done.has_value(); });
        QTRY_VERIFY_WITH_TIMEOUT(filled, gripscope::test::longEnough_ms);
        f.bench->tellLibraryChanged();
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, storedInspections,
                                  gripscope::test::longEnough_ms);
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);

        ScreenWatch watch;
        live(f, watch);
        inspect(f, watch);
        enroll(f, watch);
        lookAtPages(f, watch);
        if (QTest::currentTestFailed())
            return;
        watch.step(u"end"_s);
        QTest::qWait(50);
        for (const auto& [step, longest_ms] : watch.longest_ms()) {
            qInfo("%s: %.1f ms", qPrintable(step), longest_ms);
            QVERIFY2(longest_ms < longestBlock_ms, qPrintable(u"%1: %2 ms"_s.arg(step).arg(longest_ms)));
        }
    }
};

GRIPSCOPE_TEST(ScreenWatchTest)
#include "screen_watch_test.moc"
