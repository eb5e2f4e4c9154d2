// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/strip_chart.h"
#include "ui/pages/live/live_cards.h"

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include <cmath>
#include <ctime>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

std::size_t points(const StripChart& chart)
{
    std::size_t count = 0;
    for (const LiveHistory::Stretch& stretch : chart.stretches())
        count += stretch.size();
    return count;
}
} // namespace

/// The Live page with the virtual gripper, and its charts.
class LivePageTest : public QObject {
    Q_OBJECT
private slots:
    void chartsFollowTheGripper();
    void theLinkIsSeenAtAGlance();
    void whatGoesWrongIsSaid_data();
    void whatGoesWrongIsSaid();
    void aGapIsMarkedInTheChart();
    void pauseHoldsThePicture();
    void tareIsOnlyForTheScreen();
    void aTrialSqueezeOpensOnTheFitPage();
    void rangeStandsBetweenRoundNumbers_data();
    void rangeStandsBetweenRoundNumbers();
    void ticksAreRoundAndFew_data();
    void ticksAreRoundAndFew();
    void aChartPaintsItsCurve();
    void denseDataDoesNotHoldUpTheScreen();
};

void LivePageTest::chartsFollowTheGripper()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    const QList<StripChart*> charts = f.window->findChildren<StripChart*>();
    QCOMPARE(charts.size(), 2);
    for (StripChart* chart : charts) {
        QTRY_VERIFY_WITH_TIMEOUT(points(*chart) > 50, gripscope::test::longEnough_ms);
        QVERIFY(points(*chart) <= 2 * static_cast<std::size_t>(chart->columns() + 2));
    }
}

void LivePageTest::theLinkIsSeenAtAGlance()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    auto* link = f.find<LiveLinkPanel>("liveLink");
    QTRY_VERIFY_WITH_TIMEOUT(link->text(u"samples"_s).startsWith(u"20"_s) ||
                                 link->text(u"samples"_s).startsWith(u"19"_s),
                             gripscope::test::longEnough_ms);
    QCOMPARE(link->text(u"link"_s), u"connected"_s);
    QCOMPARE(link->text(u"lost"_s), u"none"_s);
    QCOMPARE(link->text(u"stream"_s), u"sound"_s);
    QCOMPARE(link->text(u"armed"_s), u"no"_s);
    QCOMPARE(link->text(u"force"_s), u"100 N"_s);
    QCOMPARE(link->text(u"travel"_s), u"25 mm"_s);
    QCOMPARE(link->text(u"excitation"_s), u"none"_s);
    QTRY_VERIFY_WITH_TIMEOUT(link->text(u"latency"_s).contains(u"ms, most "_s),
                             gripscope::test::longEnough_ms);
    qInfo("latency to the screen: %s", qPrintable(link->text(u"latency"_s)));
    f.bench->connection().disconnect();
    QTRY_COMPARE_WITH_TIMEOUT(link->text(u"link"_s), u"none"_s, gripscope::test::longEnough_ms);
    QCOMPARE(link->text(u"latency"_s), u"–"_s);
}

void LivePageTest::whatGoesWrongIsSaid_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("word");
    QTest::newRow("loss") << QByteArray("0 loss 0.02\n") << u"lost"_s << u"%), "_s;
    QTest::newRow("damaged") << QByteArray("0 crc 0.05\n") << u"stream"_s << u"damaged"_s;
    QTest::newRow("twice") << QByteArray("0 duplicate 0.05\n") << u"stream"_s << u"twice"_s;
    QTest::newRow("clock") << QByteArray("0.5 clock +1\n") << u"stream"_s << u"clock jump"_s;
    QTest::newRow("stall") << QByteArray("0.5 stall\n1.2 resume\n") << u"stream"_s << u"silent ("_s;
    QTest::newRow("silent now") << QByteArray("0.5 stall\n1.4 resume\n") << u"link"_s << u"silent"_s;
    QTest::newRow("unplugged") << QByteArray("0.5 unplug\n") << u"link"_s << u"lost"_s;
}

void LivePageTest::whatGoesWrongIsSaid()
{
    QFETCH(QByteArray, script);
    QFETCH(QString, id);
    QFETCH(QString, word);
    QTemporaryDir folder;
    QFile file(folder.filePath(u"faults.txt"_s));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(script) == script.size());
    file.close();
    WindowFixture f(false, QString());
    f.window->showPage(u"live"_s);
    auto* link = f.find<LiveLinkPanel>("liveLink");
    f.bench->connectTo(u"virtual:?script="_s + file.fileName());
    QTRY_VERIFY_WITH_TIMEOUT(link->text(id).contains(word), gripscope::test::longEnough_ms);
}

void LivePageTest::aGapIsMarkedInTheChart()
{
    Theme::instance().apply(ThemeKind::Light);
    StripChart chart(LiveHistory::Channel::Force, 2.0);
    chart.resize(600, 200);
    const auto signs = [&chart] {
        const QImage image = chart.grab().toImage();
        int count = 0;
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == Theme::instance().tokens().notValid;
        return count;
    };
    QCOMPARE(signs(), 0);
    chart.setGaps({{-5, -4.99}});
    const int one = signs();
    QVERIFY(one > 10);
    chart.setGaps({{-5, -4.99}, {-4.98, -4.97}, {-2, -1}}); // the second stands where the first does
    QVERIFY(signs() > 1.5 * one && signs() < 2.5 * one);
}

void LivePageTest::pauseHoldsThePicture()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    StripChart* chart = f.window->findChildren<StripChart*>().first();
    QTRY_VERIFY_WITH_TIMEOUT(points(*chart) > 50, gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("pauseButton"));
    QTRY_VERIFY(f.find<QPushButton>("pauseButton")->isChecked());
    const auto held = chart->stretches();
    const double then = f.bench->live().history().newestTime_s();
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->live().history().newestTime_s() > then + 0.3,
                             gripscope::test::longEnough_ms);
    QVERIFY(!held.empty() && !chart->stretches().empty());
    // The same columns up to the one that was still filling.
    QCOMPARE(chart->stretches().front().front().x, held.front().front().x);
}

void LivePageTest::tareIsOnlyForTheScreen()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    StripChart* position = f.window->findChildren<StripChart*>().last();
    QTRY_VERIFY_WITH_TIMEOUT(points(*position) > 100, gripscope::test::longEnough_ms);
    QVERIFY(position->seen());
    const double before = position->seen()->high;
    f.click(f.find<QPushButton>("tareButton"));
    QTRY_VERIFY(std::abs(position->seen()->high) < 0.2); // mm, the noise of the sensor
    QVERIFY(std::abs(before) > 1.0);                     // can A stands at some 12 mm
    f.click(f.find<QPushButton>("tareButton"));
    QTRY_VERIFY(std::abs(position->seen()->high - before) < 0.5);
}

void LivePageTest::aTrialSqueezeOpensOnTheFitPage()
{
    WindowFixture f(false);
    f.window->showPage(u"live"_s);
    auto* trial = f.find<QPushButton>("trialButton");
    QTRY_VERIFY(trial->isEnabled());
    f.click(trial); // it says Arm, and arms
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    QTRY_COMPARE(trial->text(), u"Trial squeeze"_s);
    f.click(trial);
    QTRY_COMPARE(trial->text(), u"Cancel squeeze"_s);
    QVERIFY(f.bench->squeezing());
    QTRY_COMPARE_WITH_TIMEOUT(f.window->currentPage()->id(), u"fit"_s, gripscope::test::longEnough_ms);
    QVERIFY(!f.bench->squeezing());
    QVERIFY(f.bench->navigator().fitSubject());
    const Estimate* best = f.bench->navigator().fitSubject()->identification.best();
    QVERIFY(best && best->parameters);
    // Can A; the virtual gripper scatters its parameters by some 5 % a squeeze: four of these.
    QVERIFY(std::abs(best->parameters->k / 9990 - 1) < 0.2);
}

void LivePageTest::rangeStandsBetweenRoundNumbers_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::newRow("squeeze with noise about zero") << -0.08 << 30.07 << 2.0 << 0.0 << 30.0;
    QTest::newRow("a constant gets the least span") << 12.345 << 12.345 << 0.2 << 12.2 << 12.45;
    QTest::newRow("negative") << -7.3 << -2.1 << 1.0 << -8.0 << -2.0;
}

void LivePageTest::rangeStandsBetweenRoundNumbers()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, least);
    QFETCH(double, from);
    QFETCH(double, to);
    const AxisRange range = roundRange(low, high, least);
    QVERIFY(std::abs(range.low - from) < 1e-9);
    QVERIFY(std::abs(range.high - to) < 1e-9);
}

void LivePageTest::ticksAreRoundAndFew_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<int>("most");
    QTest::addColumn<QStringList>("labels");
    QTest::newRow("tens") << 0.0 << 30.0 << 5 << QStringList{u"0"_s, u"10"_s, u"20"_s, u"30"_s};
    QTest::newRow("true minus") << -2.0 << 2.0 << 5
                                << QStringList{u"\u22122"_s, u"\u22121"_s, u"0"_s, u"1"_s, u"2"_s};
    QTest::newRow("decimals as the step asks")
        << 0.1 << 0.31 << 6 << QStringList{u"0.10"_s, u"0.15"_s, u"0.20"_s, u"0.25"_s, u"0.30"_s};
    QTest::newRow("empty range") << 1.0 << 1.0 << 5 << QStringList{};
    QTest::newRow("not a number") << std::nan("") << 1.0 << 5 << QStringList{};
}

void LivePageTest::ticksAreRoundAndFew()
{
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(int, most);
    const AxisTicks ticks = roundTicks(low, high, most);
    QVERIFY(static_cast<int>(ticks.values.size()) <= most);
    QStringList labels;
    for (const double value : ticks.values)
        labels << ticks.label(value);
    QTEST(labels, "labels");
}

void LivePageTest::aChartPaintsItsCurve()
{
    Theme::instance().apply(ThemeKind::Light);
    StripChart chart(LiveHistory::Channel::Force, 2.0);
    chart.resize(600, 200);
    chart.setUnit(u"N"_s);
    const auto painted = [&chart] {
        const QImage image = chart.grab().toImage();
        const QColor wanted = Theme::instance().tokens().force;
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == wanted;
        return count;
    };
    QCOMPARE(painted(), 0);
    // A square wave with a gap in the middle: nothing may be drawn across it.
    LiveHistory::Stretch first, second;
    for (int i = 0; i < 40; ++i) {
        first.push_back({-10 + i * 0.1, i % 2 ? 30.0 : 10.0});
        second.push_back({-4 + i * 0.1, i % 2 ? 30.0 : 10.0});
    }
    chart.setStretches({first, second});
    QVERIFY(painted() > 300);
    const QImage image = chart.grab().toImage();
    const int middle = 64 + static_cast<int>((600 - 64 - 16) * 0.5);
    for (int y = 0; y < image.height(); ++y)
        QVERIFY(image.pixelColor(middle, y) != Theme::instance().tokens().force);
}

void LivePageTest::denseDataDoesNotHoldUpTheScreen()
{
    Theme::instance().apply(ThemeKind::Light);
    StripChart chart(LiveHistory::Channel::Position, 0.2);
    chart.resize(1100, 300);
    LiveHistory::Stretch noise; // every column from bottom to top: the most there can be to draw
    for (int i = 0; i < 1000; ++i) {
        noise.push_back({-10 + i * 0.01, i % 3 * 0.1});
        noise.push_back({-10 + i * 0.01, 1 - i % 5 * 0.1});
    }
    chart.setStretches({noise});
    (void)chart.grab(); // grid and letters are drawn once
    // Of the processor's time, which others that keep it busy do not take.
    const std::clock_t begin = std::clock();
    (void)chart.grab();
    const double took_ms = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    // Nothing may hold up the screen's thread for over 50 ms; four times that here, for a slow machine.
    QVERIFY2(took_ms < 200, qPrintable(QString::number(took_ms)));
}

GRIPSCOPE_TEST(LivePageTest)
#include "live_page_test.moc"
