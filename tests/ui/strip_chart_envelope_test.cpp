// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/strip_chart.h"
#include "ui/theme/theme.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

constexpr double span_s = 10;

/// A chart of the force with as many columns as it has pixels, each from `low` to `high` with its mean.
struct FilledChart {
    StripChart chart{LiveHistory::Channel::Force, 40};
    LiveHistory::Stretch stretch;

    using OfColumn = std::function<double(int)>;
    FilledChart(const OfColumn& low, const OfColumn& high, const OfColumn& mean)
    {
        chart.resize(700, 240);
        chart.setTime(span_s, 0, u"now"_s);
        for (int i = 0; i < chart.columns(); ++i) {
            stretch.push_back({{time(i), low(i)}, mean(i)});
            if (low(i) != high(i))
                stretch.push_back({{time(i), high(i)}, mean(i)});
        }
        chart.setStretches({stretch});
    }
    [[nodiscard]] double time(int column) const
    {
        return -span_s + (column + 0.5) * span_s / chart.columns();
    }
    [[nodiscard]] double pixelOf(double value) const
    {
        const QRectF area = chart.plot();
        return area.bottom() - (value - chart.range().low) / chart.range().span() * area.height();
    }
    /// Around a value in the middle of the chart.
    [[nodiscard]] bool has(const QColor& color, double value)
    {
        const QImage image = chart.grab().toImage();
        const int x = int(chart.plot().center().x());
        const int y = int(std::lround(pixelOf(value)));
        return std::ranges::any_of(std::initializer_list<int>{-2, -1, 0, 1, 2}, [&](int away) {
            return image.pixelColor(x, y + away).rgb() == color.rgb();
        });
    }
    [[nodiscard]] int pixelsOf(const QColor& color)
    {
        const QImage image = chart.grab(chart.plot().toAlignedRect()).toImage(); // without words beside it
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y).rgb() == color.rgb() ? 1 : 0;
        return count;
    }
};

QColor force()
{
    return Theme::instance().tokens().force;
}

QColor pale()
{
    return StripChart::envelopeColor(force());
}

} // namespace

/// Columns of pixels that hold many samples far apart, as 10 s of a squeeze have them.
class StripChartEnvelopeTest : public QObject {
    Q_OBJECT
private slots:
    void init() { Theme::instance().apply(ThemeKind::Light); }
    void cleanup() { Theme::instance().apply(ThemeKind::Light); }

private:
    static void themes()
    {
        QTest::addColumn<ThemeKind>("theme");
        QTest::newRow("light") << ThemeKind::Light;
        QTest::newRow("dark") << ThemeKind::Dark;
        QTest::newRow("contrast") << ThemeKind::HighContrast;
    }

private slots:
    void tallColumnsAreAPaleAreaWithTheirMean_data() { themes(); }
    void tallColumnsAreAPaleAreaWithTheirMean()
    {
        QFETCH(ThemeKind, theme);
        Theme::instance().apply(theme);
        FilledChart filled([](int) { return 10; }, [](int) { return 30; }, [](int) { return 18; });
        QVERIFY(filled.has(pale(), 13) && filled.has(pale(), 27));
        QVERIFY(!filled.has(force(), 13) && !filled.has(force(), 27));
        // The line is anything but a block: two pixels of each column at most, and it is seen.
        const double ink = filled.pixelsOf(force());
        QVERIFY2(ink <= 2.2 * filled.chart.columns(), qPrintable(QString::number(ink)));
        const QImage image = filled.chart.grab().toImage();
        const int x = int(filled.chart.plot().center().x());
        double most = 1;
        for (int y = int(filled.pixelOf(18)) - 2; y <= int(filled.pixelOf(18)) + 2; ++y)
            most = std::max(most, Theme::contrastRatio(image.pixelColor(x, y), pale()));
        QVERIFY2(most > 2, qPrintable(QString::number(most)));
    }

    void whatWasAskedIsSeenAboveIt_data() { themes(); }
    void whatWasAskedIsSeenAboveIt()
    {
        QFETCH(ThemeKind, theme);
        Theme::instance().apply(theme);
        FilledChart filled([](int) { return 10; }, [](int) { return 30; }, [](int) { return 18; });
        QVERIFY(!filled.has(StripChart::commandedColor(), 25));
        LiveHistory::Stretch asked;
        for (int i = 0; i < filled.chart.columns(); ++i)
            asked.push_back({{filled.time(i), 25}, 25});
        filled.chart.setCommanded({asked});
        QVERIFY(filled.has(StripChart::commandedColor(), 25));
        // As far apart in itself, it is one band too, and hides nothing of the area.
        LiveHistory::Stretch levels;
        for (int i = 0; i < filled.chart.columns(); ++i)
            for (const double level : {11.0, 29.0})
                levels.push_back({{filled.time(i), level}, 25});
        filled.chart.setCommanded({levels});
        QVERIFY(filled.has(StripChart::commandedColor(), 25));
        QVERIFY(filled.has(pale(), 14));
    }

    void noiseIsALine()
    {
        // 40 N over some 200 pixels: 1 N is five of them.
        FilledChart filled([](int) { return 20; }, [](int) { return 21; }, [](int) { return 20.5; });
        QCOMPARE(filled.pixelsOf(pale()), 0);
        QVERIFY(filled.pixelsOf(force()) > filled.chart.columns());
    }

    void anEdgeIsALine()
    {
        const auto high = [](int i) { return i < 300 ? 10.0 : 30.0; }; // column 300 holds both
        FilledChart filled([](int i) { return i <= 300 ? 10.0 : 30.0; }, high, high);
        QCOMPARE(filled.pixelsOf(pale()), 0);
        const QImage image = filled.chart.grab().toImage(); // upright from 10 N to 30 N
        const int x = int(filled.chart.pixelAt(filled.time(300)));
        const int y = int(filled.pixelOf(20));
        QVERIFY(image.pixelColor(x, y) == force() || image.pixelColor(x + 1, y) == force());
    }
};

GRIPSCOPE_TEST(StripChartEnvelopeTest)
#include "strip_chart_envelope_test.moc"
