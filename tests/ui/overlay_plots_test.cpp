// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/overlay_plots.h"
#include "ui/theme/theme.h"

#include <QSet>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

OverlaidSqueeze::Values values(std::vector<double> numbers)
{
    return std::make_shared<const std::vector<double>>(std::move(numbers));
}

OverlaidSqueeze squeeze(int number, const QString& positionUnit = u"m"_s)
{
    return {u"Inspection %1"_s.arg(number),
            u"N"_s,
            positionUnit,
            values({0, 0.5, 1}),
            values({10, 30, 10}),
            values({0.001, 0.003, 0.001 * number}),
            true};
}

std::vector<OverlaidSqueeze> squeezes(int count)
{
    std::vector<OverlaidSqueeze> result;
    for (int i = 1; i <= count; ++i)
        result.push_back(squeeze(i));
    return result;
}

} // namespace

class OverlayPlotsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void shortOnesHaveTheirTimesInMilliseconds()
    {
        std::vector<OverlaidSqueeze> brief = squeezes(2);
        for (OverlaidSqueeze& one : brief)
            one.time_s = values({0, 0.02, 0.04});
        OverlayPlots plots;
        plots.setSqueezes(brief);
        for (const TimePlot* plot : {plots.position(), plots.force()})
            QCOMPARE(plot->horizontal(), (PlotRange{0, 40}));
        QCOMPARE(plots.numbers()[0].values->back(), 0.04);
        QVERIFY(plots.numbers()[0].name.endsWith(u"Time (s)"_s));
    }
    void everySqueezeIsACurveOfItsOwnLook()
    {
        OverlayPlots plots;
        plots.resize(700, 500);
        plots.setSqueezes(squeezes(25));
        QCOMPARE(plots.squeezes().size(), OverlayPlots::most);
        QCOMPARE(plots.legend().size(), OverlayPlots::most);
        QCOMPARE(plots.position()->curves().size(), OverlayPlots::most);
        QSet<QString> looks;
        for (const FigureSign& sign : plots.legend())
            looks << sign.pen.color().name() + QString::number(int(sign.pen.style()));
        QCOMPARE(looks.size(), qsizetype(OverlayPlots::most));
        QCOMPARE(plots.legend()[11].name, u"Inspection 12"_s);
        QVERIFY(plots.force()->curves()[3].held);
        QVERIFY(!plots.position()->curves()[3].held);
    }
    void channelsAreShownInOneUnit()
    {
        OverlayPlots plots;
        std::vector<OverlaidSqueeze> all = squeezes(3);
        all.push_back(squeeze(4, u"mm"_s)); // has no place on these axes
        plots.setSqueezes(all);
        QCOMPARE(plots.squeezes().size(), std::size_t(3));
        QCOMPARE(plots.position()->title(), u"Position (mm)"_s);
        QCOMPARE((*plots.position()->curves()[2].y)[2], 3.0);
    }
    void theFigureAndTheNumbersNameEachSqueeze()
    {
        OverlayPlots plots;
        plots.setSqueezes(squeezes(3));
        {
            const FigureLayout layout(plots, FigureWidth::TwoColumns);
            const QString svg = QString::fromUtf8(toSvg(plots));
            for (const QString& words : {u"Inspection 1"_s, u"Inspection 3"_s, u"Position"_s, u"Force"_s})
                QVERIFY2(svg.contains(words), qPrintable(words));
        }
        const QList<QByteArray> lines = toCsv(plots.numbers()).split('\n');
        QCOMPARE(lines[0].count(','), qsizetype(8));
        QVERIFY2(lines[0].startsWith("Inspection 1: Time (s),Inspection 1: Force (N)"), lines[0].constData());
        QCOMPARE(lines[3], QByteArray("1,10,0.001,1,10,0.002,1,10,0.003"));
    }
    void manyNamesTakeSeveralLines()
    {
        OverlayPlots plots;
        plots.resize(400, 600);
        plots.setSqueezes(squeezes(2));
        const FigureLayout layout(plots, FigureWidth::OneColumn);
        const int few = plots.pictureSize().height();
        plots.setSqueezes(squeezes(20));
        QVERIFY(plots.pictureSize().height() > few + 100);
    }
};

GRIPSCOPE_TEST(OverlayPlotsTest)
#include "overlay_plots_test.moc"
