// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/strip_chart.h"
#include "ui/theme/theme.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class StripChartFigureTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void whatIsInViewLeavesTheScreenAsVectorsAndNumbers()
    {
        StripChart chart(LiveHistory::Channel::Force, 1);
        chart.resize(640, 120);
        chart.setUnit(u"N"_s);
        chart.setScale(2, 1); // shown: twice what is sent, less a tare of 1
        chart.setTime(10, 0, u"now"_s);
        chart.setTimeLabels(false); // another chart below has them on the screen
        chart.setStretches({{{-8, 3}, {-6, 5}}, {{-3, 4}, {-1, 4}}});
        const QRectF onScreen = chart.plot();
        {
            const FigureLayout layout(chart, FigureWidth::OneColumn);
            const QByteArray svg = toSvg(chart);
            QVERIFY(svg.contains("width=\"84.9") && !svg.contains("<image"));
            for (const char* words : {"Force", "now", "N</text>"})
                QVERIFY2(svg.contains(words), words);
            QVERIFY(svg.contains(themeTokens(ThemeKind::Light).force.name().toLatin1()));
        }
        QCOMPARE(chart.plot(), onScreen);
        QCOMPARE(toCsv(chart.numbers()), QByteArray("Time (s),Force (N)\n-8,5\n-6,9\n-3,7\n-1,7\n"));
    }
};

GRIPSCOPE_TEST(StripChartFigureTest)
#include "strip_chart_figure_test.moc"
