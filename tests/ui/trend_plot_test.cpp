// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/trend_plot.h"

#include <QDateTime>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

std::shared_ptr<HistoryPoints> pointsOf(int count)
{
    auto points = std::make_shared<HistoryPoints>();
    points->types = {u"A"_s, u"B"_s};
    for (int i = 0; i < count; ++i) {
        HistoryPoint point;
        point.time_ms = 1'704'067'200'000 + 60'000LL * i;
        point.parameters = {0.04 + 0.001 * std::sin(i), 43, 9990};
        point.type = i % 2;
        points->points.push_back(point);
        points->keys.append(u"g%1"_s.arg(i));
    }
    return points;
}

TypeModels models()
{
    std::vector<TypeSqueeze> squeezes;
    for (int i = 0; i < 10; ++i) {
        squeezes.push_back({u"A"_s, {0.04 * (1 + 0.01 * std::sin(i)), 43, 9990}});
        squeezes.push_back({u"C"_s, {0.02 * (1 + 0.01 * std::cos(i)), 20, 5000}});
    }
    return fitTypeModels(squeezes);
}

} // namespace

class TrendPlotTest : public QObject {
    Q_OBJECT
private slots:
    void intervalsHoldTheStatedShare()
    {
        TypeModel type;
        type.meanLog = Eigen::Vector3d(std::log(2.0), 0, 0);
        TypeModels models;
        models.covarianceLog(0, 0) = 0.01;
        const auto intervals = typeIntervals(models, type, 0.95);
        QVERIFY(std::abs(intervals[0].mean - 2) < 1e-12);
        QVERIFY(std::abs(intervals[0].high - 2 * std::exp(0.1 * 1.959963984540054)) < 1e-12);
        QVERIFY(std::abs(intervals[0].low * intervals[0].high - 4) < 1e-12);
        QCOMPARE(intervals[1].low, 1.0); // nothing known of the scatter
        QCOMPARE(typeIntervals(models, type, 7)[0].high, intervals[0].high);
    }
    void typesThatAreEnrolledKeepTheirSignAndBand()
    {
        const TrendContent content = trendContent(pointsOf(10), models(), true);
        QCOMPARE(content.signs,
                 std::vector<int>({0, 2}));             // A is the first enrolled, B comes after all of them
        QCOMPARE(content.bands.size(), std::size_t(1)); // C has no squeeze here
        QCOMPARE(content.bands[0].type, u"A"_s);
    }
    void onlyWhatIsInViewIsLookedAt()
    {
        TrendContent content = trendContent(pointsOf(1000), {}, false);
        QCOMPARE(content.inView(), std::make_pair(std::size_t(0), std::size_t(1000)));
        content.low = 11;
        content.high = 20;
        QCOMPARE(content.inView(), std::make_pair(std::size_t(10), std::size_t(20)));
    }
    void aPointIsFoundWhereItIsPainted()
    {
        const TrendContent content = trendContent(pointsOf(5), {}, true);
        const TrendPlot plot(content, 0, {0, 0, 600, 160}, true);
        for (std::size_t place = 0; place < 5; ++place) {
            const double share = (content.across(place) - content.low) / (content.high - content.low);
            const double x = plot.area().left() + share * plot.area().width();
            bool found = false;
            for (double y = plot.area().top(); y < plot.area().bottom(); ++y)
                found = found || plot.pointAt({x, y}) == place;
            QVERIFY(found);
        }
        QVERIFY(!plot.pointAt({-500, -500}));
    }
    void aHundredThousandAreDrawnByColumns()
    {
        const TrendContent content = trendContent(pointsOf(100'000), models(), true);
        QImage image(600, 160, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        const TrendPlot plot(content, 0, {0, 0, 600, 160}, true);
        plot.paint(painter, themeTokens(ThemeKind::Light));
        painter.end();
        // m goes up and down by 2.5 %: every column of the plot is painted.
        for (int x = int(plot.area().left()) + 14; x < int(plot.area().right()) - 14; ++x) {
            bool painted = false;
            for (int y = int(plot.area().top()) + 2; y < int(plot.area().bottom()) - 2; ++y)
                painted = painted || image.pixelColor(x, y).saturation() > 120;
            QVERIFY2(painted, qPrintable(QString::number(x)));
        }
    }
    void nothingToDrawIsNoTrouble()
    {
        const TrendContent content = trendContent(std::make_shared<HistoryPoints>(), models(), true);
        QImage image(300, 100, QImage::Format_RGB32);
        QPainter painter(&image);
        TrendPlot(content, 2, {0, 0, 300, 100}, true).paint(painter, themeTokens(ThemeKind::Dark));
        QVERIFY(!TrendPlot(content, 2, {0, 0, 300, 100}, true).pointAt({100, 50}));
    }
    void timesAreRound_data()
    {
        QTest::addColumn<double>("span");
        QTest::addColumn<int>("least");
        QTest::newRow("minutes") << 10 * 60e3 << 3;
        QTest::newRow("hours") << 9 * 3600e3 << 3;
        QTest::newRow("days") << 9 * 86400e3 << 3;
        QTest::newRow("months") << 200 * 86400e3 << 2;
        QTest::newRow("years") << 3000 * 86400e3 << 2;
        QTest::newRow("an age") << 90000 * 86400e3 << 2;
    }
    void timesAreRound()
    {
        QFETCH(double, span);
        QFETCH(int, least);
        const double start = 1'704'110'400'123;
        const std::vector<TimeTick> ticks = timeTicks(start, start + span, 6);
        QVERIFY(int(ticks.size()) >= least && ticks.size() <= 7);
        for (const TimeTick& tick : ticks) {
            QVERIFY(tick.at >= start && tick.at <= start + span && !tick.label.isEmpty());
            QCOMPARE(QDateTime::fromMSecsSinceEpoch(qint64(tick.at)).time().second(), 0);
        }
        QVERIFY(timeTicks(start, start, 6).empty());
        QVERIFY(timeTicks(NAN, start, 6).empty());
    }
};

GRIPSCOPE_TEST(TrendPlotTest)
#include "trend_plot_test.moc"
