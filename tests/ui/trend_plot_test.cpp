// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/painted_outside.h"
#include "ui/charts/axis_ticks.h"
#include "ui/charts/trend_figure.h"
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
    points->places = {0, 2};
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
    void aTypeKeepsItsSignWhateverItsName()
    {
        TypeModels known = models(); // of A and C
        known.types[0].place = 3;
        known.types[1].place = 1;
        const auto points = pointsOf(10);
        points->places = {3, 7};
        const TrendContent content = trendContent(points, known, true);
        QCOMPARE(content.sign(0), 3);
        QCOMPARE(content.sign(1), 7); // B, which has no model: retired, or not approved yet
        QCOMPARE(content.sign(-1), -1);
        QCOMPARE(content.bands.size(), std::size_t(1));
        QCOMPARE(content.bands[0].sign, 3);
        // Nor does the approval of another type change any.
        QCOMPARE(trendContent(points, {}, true).sign(0), 3);
        QCOMPARE(trendContent(points, {}, true).sign(1), 7);
    }
    void gatesAreLinesBesideTheBands()
    {
        const TypeModels known = models();
        const std::vector<GateIntervals> gates = gateIntervals(known);
        QCOMPARE(gates.size(), std::size_t(2));
        const auto linesAcross = [&](const TrendContent& content) {
            QImage image(600, 400, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            const TrendPlot plot(content, 0, {0, 0, 600, 400}, true);
            plot.paint(painter, themeTokens(ThemeKind::Light));
            painter.end();
            int lines = 0;
            bool before = false;
            for (int y = int(plot.area().top()); y < int(plot.area().bottom()) - 2; ++y) {
                int colored = 0;
                for (int x = int(plot.area().left()) + 2; x < int(plot.area().right()); ++x)
                    colored += image.pixelColor(x, y).saturation() > 50 ? 1 : 0;
                const bool line = colored > 80; // the few points are far narrower
                lines += line && !before ? 1 : 0;
                before = line;
            }
            return lines;
        };
        const auto points = pointsOf(3);
        const TrendContent with = trendContent(points, known, true, gates);
        const TrendContent without = trendContent(points, known, true);
        QVERIFY(with.gated() && !without.gated());
        QCOMPARE(linesAcross(without), 1); // the mean
        QCOMPARE(linesAcross(with), 3);
        // Of few squeezes it is far out, and does not press the rest flat.
        std::vector<GateIntervals> wide = gates;
        wide[0][0].low = 1e-6;
        wide[0][0].high = 100;
        QCOMPARE(linesAcross(trendContent(points, known, true, wide)), 1);
    }
    void aFigureHasItsLegendAndKeepsToItsSize_data()
    {
        QTest::addColumn<FigureWidth>("width");
        QTest::newRow("screen") << FigureWidth::Screen;
        QTest::newRow("one column") << FigureWidth::OneColumn;
        QTest::newRow("two columns") << FigureWidth::TwoColumns;
    }
    void aFigureHasItsLegendAndKeepsToItsSize()
    {
        QFETCH(FigureWidth, width);
        const auto points = pointsOf(60);
        for (int i = 2; i < 12; ++i) {
            points->types << u"A type with a name that is long %1"_s.arg(i);
            points->places.push_back(i + 1);
        }
        for (HistoryPoint& point : points->points) {
            point.standardErrors = {1, 1000, 1e6}; // bars far beyond the plot
            point.validity = ValidityVerdict::Suspect;
        }
        TrendView view;
        view.resize(500, 300);
        TrendContent content = trendContent(points, models(), true, gateIntervals(models()));
        content.low += 0.3 * (content.high - content.low); // zoomed
        content.selected = 0;                              // not in view
        view.setContent(content);
        const FigureLayout layout(view, width);
        QCOMPARE(test::paintedOutside(view), 0);
        const QByteArray svg = toSvg(view);
        QVERIFY(svg.contains("A type with a name that is long 11"));
        QVERIFY(svg.contains("Stiffness k"));
        QVERIFY(!svg.contains("<image"));
    }
    void allNumbersOfAFigureAreInItsTable()
    {
        const auto points = pointsOf(2);
        points->points[0].standardErrors = {1e-4, 0.1, 10};
        points->points[1].type = -1;
        points->points[1].validity = ValidityVerdict::Suspect;
        TrendView view;
        view.setContent(trendContent(points, {}, true));
        const QList<QByteArray> lines = toCsv(view.numbers()).split('\n');
        QCOMPARE(lines[0],
                 QByteArray("Time (UTC),Mass m (kg),\"Mass m, standard error (kg)\",Damping b (N s/m),"
                            "\"Damping b, standard error (N s/m)\",Stiffness k (N/m),"
                            "\"Stiffness k, standard error (N/m)\",Type,Measurement"));
        QCOMPARE(lines[1], QByteArray("2024-01-01T00:00:00.000Z,0.04,1e-04,43,0.1,9990,10,A,"));
        QVERIFY(lines[2].startsWith("2024-01-01T00:01:00.000Z,") && lines[2].endsWith(",,suspect"));
    }
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
        QCOMPARE(content.sign(1), 2);
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
    void aSuspectPointIsNotACleanOne_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("points") << 5;
        QTest::newRow("columns") << 10'000;
    }
    void aSuspectPointIsNotACleanOne()
    {
        QFETCH(int, count);
        const auto painted = [count](std::optional<ValidityVerdict> validity) {
            const auto points = pointsOf(count);
            points->points[std::size_t(count) / 2].validity = validity;
            const TrendContent content = trendContent(points, {}, true);
            QImage image(600, 160, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            TrendPlot(content, 0, {0, 0, 600, 160}, true).paint(painter, themeTokens(ThemeKind::Light));
            painter.end();
            return image;
        };
        const auto doubted = [](const QImage& image) {
            int pixels = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    pixels +=
                        image.pixelColor(x, y).rgb() == themeTokens(ThemeKind::Light).suspect.rgb() ? 1 : 0;
            return pixels;
        };
        const QImage clean = painted(ValidityVerdict::Valid);
        QCOMPARE(doubted(clean), 0);
        QVERIFY(clean == painted({}));
        QVERIFY(doubted(painted(ValidityVerdict::Suspect)) >= 7);
        QVERIFY(painted(ValidityVerdict::Invalid) != clean);
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
