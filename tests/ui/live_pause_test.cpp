// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/ui/layout_audit.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/strip_chart.h"
#include "ui/models/live_marker_model.h"
#include "ui/pages/live/live_pause.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QToolButton>
#include <QWheelEvent>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

/// The Live page, paused after two seconds and more of samples, by click.
struct PausedPage {
    WindowFixture f{false};
    StripChart* force = nullptr;
    StripChart* position = nullptr;

    PausedPage()
    {
        f.window->showPage(u"live"_s);
        force = f.window->findChildren<StripChart*>().first();
        position = f.window->findChildren<StripChart*>().last();
        if (!QTest::qWaitFor([this] { return f.bench->live().history().newestTime_s() > 2.5; },
                             gripscope::test::longEnough_ms))
            qFatal("no samples came");
        f.click(f.find<QPushButton>("pauseButton"));
    }

    [[nodiscard]] QAbstractButton* button(const char* name) const { return f.find<QAbstractButton>(name); }
    [[nodiscard]] double cursor(const char* name) const { return f.find<QDoubleSpinBox>(name)->value(); }
    [[nodiscard]] QString text(const char* name) const { return f.find<QLabel>(name)->text(); }
    [[nodiscard]] QPoint at(double share) const
    {
        const QRectF plot = force->plot();
        return {int(std::lround(plot.left() + share * plot.width())), int(plot.center().y())};
    }
    void wheel(StripChart* chart, QPoint at, int notches) const
    {
        QWheelEvent event(at, chart->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(chart, &event);
    }
    void drag(QPoint from, QPoint to) const
    {
        QTest::mousePress(force, Qt::LeftButton, {}, from);
        QTest::mouseMove(force, (from + to) / 2);
        QTest::mouseMove(force, to);
        QTest::mouseRelease(force, Qt::LeftButton, {}, to);
    }
    [[nodiscard]] std::optional<StripMark> mark(StripMark::Kind kind) const
    {
        for (const StripMark& mark : force->marks())
            if (mark.kind == kind)
                return mark;
        return std::nullopt;
    }
};

} // namespace

/// What can be done with held charts, by mouse and by key.
class LivePauseTest : public QObject {
    Q_OBJECT
private slots:
    void pausingShowsThePanelAndResumingTheLink();
    void theWheelZoomsBothChartsAroundThePointer();
    void aDragMovesTheViewAndADoubleClickShowsAllAgain();
    void keysZoomAndMove();
    void buttonsZoomAndMove();
    void cursorsAreDragged();
    void cursorsAreMovedByKeysAndTyped();
    void cursorsComeIntoView();
    void theReadoutIsOfTheSamples();
    void aMarkerStandsInBothChartsAndInTheList();
    void markersAreWordedFoundAndRemoved();
    void aTrialSqueezeKeepsItsMarkers();
    void whatIsInViewIsSavedAsARecording();
    void nothingChangesWhileItRuns();
    void everythingFitsWhilePaused();
};

void LivePauseTest::pausingShowsThePanelAndResumingTheLink()
{
    PausedPage p;
    auto* panel = p.f.find<LiveMeasurePanel>("liveMeasure");
    QTRY_VERIFY(panel->isVisible());
    QVERIFY(!p.f.find<QWidget>("liveLink")->isVisible());
    QCOMPARE(p.f.window->focusWidget(), p.force);
    QVERIFY(p.mark(StripMark::Kind::FirstCursor) && p.mark(StripMark::Kind::SecondCursor));
    p.f.click(p.button("pauseButton"));
    QTRY_VERIFY(!panel->isVisible());
    QVERIFY(p.f.find<QWidget>("liveLink")->isVisible());
    QVERIFY(!p.mark(StripMark::Kind::FirstCursor));
}

void LivePauseTest::theWheelZoomsBothChartsAroundThePointer()
{
    PausedPage p;
    const QPoint pointer = p.at(0.75);
    p.wheel(p.force, pointer, 4); // two notches double
    QCOMPARE(p.force->seconds(), 2.5);
    QCOMPARE(p.position->seconds(), 2.5);
    // Cursor B stood below the pointer to half a pixel, and that is four times as wide now.
    QVERIFY(std::abs(p.force->pixelAt(p.mark(StripMark::Kind::SecondCursor)->x) - pointer.x()) < 2.5);
    p.wheel(p.position, pointer, -4);
    QCOMPARE(p.force->seconds(), 10.0);
}

void LivePauseTest::aDragMovesTheViewAndADoubleClickShowsAllAgain()
{
    PausedPage p;
    p.wheel(p.force, p.at(1), 6);
    const double before = p.force->pixelAt(p.mark(StripMark::Kind::SecondCursor)->x);
    p.drag(p.at(0.3), p.at(0.5));
    QCOMPARE(p.force->seconds(), 1.25);
    const double moved = p.force->pixelAt(p.mark(StripMark::Kind::SecondCursor)->x) - before;
    QVERIFY2(std::abs(moved - 0.2 * p.force->plot().width()) < 2, qPrintable(QString::number(moved)));
    const double time_s = p.cursor("cursorB");
    QTest::mouseDClick(p.force, Qt::LeftButton, {}, p.at(0.5));
    QCOMPARE(p.force->seconds(), 10.0);
    QCOMPARE(p.cursor("cursorB"), time_s); // it is in view there too, so it stays where it is
}

void LivePauseTest::keysZoomAndMove()
{
    PausedPage p;
    QTest::keyClick(p.force, Qt::Key_Plus);
    QTest::keyClick(p.force, Qt::Key_Plus);
    QCOMPARE(p.position->seconds(), 2.5);
    const double before = p.mark(StripMark::Kind::FirstCursor)->x;
    QTest::keyClick(p.force, Qt::Key_Left);
    QVERIFY(std::abs(p.mark(StripMark::Kind::FirstCursor)->x - before - 0.25) < 1e-6);
    QTest::keyClick(p.force, Qt::Key_Right);
    QVERIFY(std::abs(p.mark(StripMark::Kind::FirstCursor)->x - before) < 1e-6);
    QTest::keyClick(p.force, Qt::Key_Minus);
    QCOMPARE(p.force->seconds(), 5.0);
    QTest::keyClick(p.force, Qt::Key_Home);
    QCOMPARE(p.force->seconds(), 10.0);
}

void LivePauseTest::buttonsZoomAndMove()
{
    PausedPage p;
    p.f.click(p.button("zoomIn"));
    QCOMPARE(p.force->seconds(), 5.0);
    const double before = p.mark(StripMark::Kind::FirstCursor)->x;
    p.f.click(p.button("earlier"));
    QVERIFY(p.mark(StripMark::Kind::FirstCursor)->x > before);
    p.f.click(p.button("later"));
    QVERIFY(std::abs(p.mark(StripMark::Kind::FirstCursor)->x - before) < 1e-6);
    p.f.click(p.button("zoomOut"));
    QCOMPARE(p.force->seconds(), 10.0);
    p.f.click(p.button("zoomIn"));
    p.f.click(p.button("whole"));
    QCOMPARE(p.force->seconds(), 10.0);
    for (const char* name : {"zoomIn", "zoomOut", "earlier", "later", "whole", "cursors", "saveView"})
        QVERIFY2(p.button(name)->width() >= metrics::touchTarget &&
                     p.button(name)->height() >= metrics::touchTarget,
                 name);
}

void LivePauseTest::cursorsAreDragged()
{
    PausedPage p;
    const double b = p.cursor("cursorB");
    p.drag(p.at(0.25), p.at(0.9));
    QVERIFY2(std::abs(p.cursor("cursorA") + 1.0) < 0.05, qPrintable(QString::number(p.cursor("cursorA"))));
    QCOMPARE(p.cursor("cursorB"), b);
    QCOMPARE(p.force->seconds(), 10.0);
    p.drag(p.at(0.75), p.at(1.3)); // no further than to the newest
    QCOMPARE(p.cursor("cursorB"), 0.0);
}

void LivePauseTest::cursorsAreMovedByKeysAndTyped()
{
    PausedPage p;
    const double a = p.cursor("cursorA");
    const double b = p.cursor("cursorB");
    const double column_s = 10.0 / p.force->columns();
    for (int i = 0; i < 10; ++i)
        QTest::keyClick(p.force, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(p.force, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(std::abs(p.cursor("cursorA") - a - 10 * column_s) < 2e-4);
    QVERIFY(std::abs(p.cursor("cursorB") - b + column_s) < 2e-4);
    auto* typed = p.f.find<QDoubleSpinBox>("cursorB");
    typed->setFocus();
    typed->selectAll();
    QTest::keyClicks(typed, u"-1.25"_s);
    QTest::keyClick(typed, Qt::Key_Return);
    QVERIFY(std::abs(p.mark(StripMark::Kind::SecondCursor)->x + 1.25) < 1e-6);
}

void LivePauseTest::cursorsComeIntoView()
{
    PausedPage p;
    const auto share = [&p](StripMark::Kind kind) { return 1 + p.mark(kind)->x / p.force->seconds(); };
    const auto a = [&share] { return share(StripMark::Kind::FirstCursor); };
    const auto b = [&share] { return share(StripMark::Kind::SecondCursor); };
    const auto isNear = [](double found, double wanted) { return std::abs(found - wanted) < 1e-6; };
    p.wheel(p.force, p.at(0.75), 2); // twice as close: B is still in view, A is not
    QVERIFY2(isNear(a(), 0) && std::abs(b() - 0.75) < 0.01, qPrintable(QString::number(a())));
    QTest::keyClick(p.force, Qt::Key_Right); // the view moves on, and A with its edge
    QVERIFY(isNear(a(), 0) && std::abs(b() - 0.65) < 0.01);
    p.wheel(p.force, p.at(1), 10); // both are out: they come as when it was paused
    QVERIFY(isNear(a(), 0.25) && isNear(b(), 0.75));
    QTest::keyClick(p.force, Qt::Key_Left);
    QTest::keyClick(p.force, Qt::Key_Left);
    QTest::keyClick(p.force, Qt::Key_Left);
    QVERIFY(isNear(a(), 0.55) && isNear(b(), 1)); // at the other edge
    p.f.click(p.button("cursors"));
    QVERIFY(isNear(a(), 0.25) && isNear(b(), 0.75));
    p.f.find<QDoubleSpinBox>("cursorA")->setValue(-30); // further back than the whole, which shows 10 s
    QTest::keyClick(p.force, Qt::Key_Home);
    QVERIFY(a() >= 0 && a() <= 1 && b() >= 0 && b() <= 1);
}

void LivePauseTest::theReadoutIsOfTheSamples()
{
    PausedPage p;
    const LiveHistory held = p.f.bench->live().history(); // the page's copy is as new, or a tick older
    auto* a = p.f.find<QDoubleSpinBox>("cursorA");
    a->setValue(-1);
    p.f.find<QDoubleSpinBox>("cursorB")->setValue(-0.5);
    QCOMPARE(p.text("timeBetween"), u"500.0\u00A0ms"_s);
    const QRegularExpression newtons(u"^(−?\\d+\\.\\d\\d)\u00A0N$"_s);
    const QRegularExpressionMatch force = newtons.match(p.text("forceA"));
    QVERIFY2(force.hasMatch(), qPrintable(p.text("forceA")));
    // At rest the virtual gripper measures no force, with 0.02 N of noise.
    QVERIFY(std::abs(force.captured(1).replace(u'−', u'-').toDouble()) < 0.15);
    QVERIFY2(p.text("positionA").endsWith(u"\u00A0mm"_s), qPrintable(p.text("positionA")));
    QVERIFY2(p.text("forceBetween").contains(u" ± "_s), qPrintable(p.text("forceBetween")));
    // Nothing moved, so there is no slope to be told.
    QCOMPARE(p.text("slopeBetween"), u"position does not change"_s);
    a->setValue(-9); // before the first sample
    QCOMPARE(p.text("forceA"), u"–"_s);
}

void LivePauseTest::aMarkerStandsInBothChartsAndInTheList()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    const QList<StripChart*> charts = f.window->findChildren<StripChart*>();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->live().history().newestTime_s() > 0.5, gripscope::test::longEnough_ms);
    QTest::keyClick(f.page(u"live"_s), Qt::Key_M);
    f.click(f.find<QToolButton>("markerButton"));
    const auto markers = [](const StripChart* chart) {
        return std::count_if(chart->marks().begin(), chart->marks().end(),
                             [](const StripMark& m) { return m.kind == StripMark::Kind::Marker; });
    };
    for (const StripChart* chart : charts)
        QTRY_COMPARE(markers(chart), 2);
    f.click(f.find<QPushButton>("pauseButton"));
    auto* list = f.find<QTableView>("markerList");
    QCOMPARE(list->model()->rowCount(), 2);
    // Paused, one goes to the cursor moved last.
    QTest::keyClick(charts[0], Qt::Key_Left, Qt::ControlModifier);
    QTest::keyClick(charts[0], Qt::Key_M);
    QCOMPARE(list->model()->rowCount(), 3);
    const auto& marks = charts[1]->marks();
    const auto third =
        std::find_if(marks.begin(), marks.end(), [](const StripMark& m) { return m.label == u"3"_s; });
    const auto b = std::find_if(marks.begin(), marks.end(),
                                [](const StripMark& m) { return m.kind == StripMark::Kind::SecondCursor; });
    QVERIFY(third != marks.end() && b != marks.end());
    QVERIFY(std::abs(third->x - b->x) < 1e-9);
    // Another gripper: its time has nothing to do with the markers.
    f.click(f.find<QPushButton>("pauseButton"));
    f.connectTo(u"virtual:?object=B&seed=9"_s);
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->rowCount(), 0, gripscope::test::longEnough_ms);
}

void LivePauseTest::markersAreWordedFoundAndRemoved()
{
    PausedPage p;
    QTest::keyClick(p.force, Qt::Key_M);
    auto* list = p.f.find<QTableView>("markerList");
    const QModelIndex words = list->model()->index(0, int(LiveMarkerModel::Column::Words));
    list->setCurrentIndex(words);
    list->edit(words);
    auto* editor = list->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, u"my mark"_s); // with m: letters are no shortcuts while one types
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(words.data().toString(), u"my mark"_s);
    QCOMPARE(list->model()->rowCount(), 1);
    p.wheel(p.force, p.at(1), 10);
    QVERIFY(!p.mark(StripMark::Kind::Marker));
    list->clearSelection();
    list->setCurrentIndex({});
    list->selectRow(0);
    QVERIFY(p.mark(StripMark::Kind::Marker));
    p.f.click(p.button("removeMarker"));
    QCOMPARE(list->model()->rowCount(), 0);
    QVERIFY(!p.mark(StripMark::Kind::Marker));
    QVERIFY(!p.button("removeMarker")->isEnabled());
}

void LivePauseTest::aTrialSqueezeKeepsItsMarkers()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    f.bench->arm();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTest::keyClick(f.page(u"live"_s), Qt::Key_M); // before the squeeze
    f.click(f.find<QPushButton>("trialButton"));
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->live().estimate().following(), gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->live().estimate().state()->samples > 200,
                             gripscope::test::longEnough_ms);
    QTest::keyClick(f.page(u"live"_s), Qt::Key_M);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->navigator().fitSubject(), gripscope::test::longEnough_ms);
    const Recording& recording = f.bench->navigator().fitSubject()->recording;
    const QStringList notes = recording.provenance.keys().filter(u"marker_"_s);
    QCOMPARE(notes, QStringList{u"marker_001"_s});
    const double time_s = recording.provenance[u"marker_001"_s].chopped(2).toDouble();
    QVERIFY(time_s > recording.time_s.front() + 0.1 && time_s < recording.time_s.back());
}

void LivePauseTest::whatIsInViewIsSavedAsARecording()
{
    PausedPage p;
    p.wheel(p.force, p.at(1), 6); // the last 1.25 s
    p.f.click(p.button("cursors"));
    QTest::keyClick(p.force, Qt::Key_M);
    QTemporaryDir folder;
    const QString file = folder.filePath(u"view.csv"_s);
    p.f.click(p.button("saveView"));
    auto* dialog = p.f.window->findChild<QFileDialog*>();
    QVERIFY(dialog);
    emit dialog->fileSelected(file);
    dialog->close();
    QTRY_VERIFY_WITH_TIMEOUT(p.f.window->message().contains(u"1.25 s"_s), gripscope::test::longEnough_ms);
    const Expected<Recording> saved = readRecordingCsv(file);
    QVERIFY(saved);
    QVERIFY(std::abs(static_cast<double>(saved->size()) - 2500) <= 1);
    QVERIFY(findGaps(*saved).empty());
    QCOMPARE(saved->forceUnit, u"N"_s);
    QCOMPARE(saved->provenance[u"operator"_s], u"Mai"_s);
    QVERIFY(!saved->provenance[u"serial"_s].isEmpty());
    const double marked_s = saved->provenance[u"marker_001"_s].chopped(2).toDouble();
    QVERIFY(std::abs(saved->time_s.back() - marked_s - 0.9375) < 0.01); // 3/4 of 1.25 s before the end
}

void LivePauseTest::nothingChangesWhileItRuns()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    StripChart* chart = f.window->findChildren<StripChart*>().first();
    QTest::keyClick(f.page(u"live"_s), Qt::Key_Plus);
    QWheelEvent event({300, 50}, chart->mapToGlobal(QPoint(300, 50)), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(chart, &event);
    QTest::keyClick(chart, Qt::Key_Left);
    QTest::qWait(50);
    QCOMPARE(chart->seconds(), 10.0);
    QVERIFY(chart->marks().empty());
}

void LivePauseTest::everythingFitsWhilePaused()
{
    PausedPage p;
    QTest::keyClick(p.force, Qt::Key_M);
    for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast}) {
        Theme::instance().apply(theme);
        for (const QSize size : {QSize(1024, 640), QSize(1440, 900), QSize(2048, 1280)}) {
            p.f.window->resize(size);
            QCoreApplication::processEvents();
            QCoreApplication::processEvents();
            const QStringList findings = gripscope::test::LayoutAudit::of(*p.f.window);
            QVERIFY2(findings.isEmpty(), qPrintable(findings.join(u"; "_s)));
        }
    }
    Theme::instance().apply(ThemeKind::Light);
}

GRIPSCOPE_TEST(LivePauseTest)
#include "live_pause_test.moc"
