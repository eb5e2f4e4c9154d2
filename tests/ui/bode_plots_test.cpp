// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/bode_plots.h"
#include "ui/theme/theme.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// A spring with a damper and a mass; three measured frequencies on it, one of them in the noise.
BodeContent example()
{
    BodeContent content;
    content.model =
        modelResponse({0.04, 43, 1e4}, Eigen::Matrix3d(Eigen::Vector3d(1e-6, 0.2, 1e4).asDiagonal()),
                      {0.0005, ForceHold::Zero, 0}, logarithmicFrequencies(5, 990, 50));
    content.modelName = u"output error"_s;
    content.unit = u"u/v"_s;
    content.factor = 1000;
    EmpiricalResponse measured;
    measured.status = EmpiricalResponse::Status::Found;
    measured.coherenceLimit = 0.48;
    for (const std::size_t i : {std::size_t(5), std::size_t(25)})
        measured.lines.push_back({content.model[i].frequency_Hz, content.model[i].response, 0.99, 0.02});
    measured.lines.push_back({900, {0.5, 0.5}, 0.1, std::nullopt}); // far off
    content.measured = measured;
    return content;
}

} // namespace

class BodePlotsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void whatIsNotReliableIsPaleAndItIsSaid()
    {
        BodePlots plots;
        plots.resize(600, 480);
        plots.show(example());
        QCOMPARE(plots.magnitude()->measured().value.size(), std::size_t(2));
        QCOMPARE(plots.magnitude()->doubtful().value.size(), std::size_t(1));
        QVERIFY(plots.magnitude()->doubtful().low.empty()); // no interval
        QVERIFY2(plots.coherence()->finding().contains(u"0.48"_s), qPrintable(plots.coherence()->finding()));
        QCOMPARE(plots.legend().size(), std::size_t(3));
        QVERIFY(plots.legend()[1].fade < 1);
        // It does not press what is reliable flat.
        QVERIFY(plots.magnitude()->vertical().high < std::log10(500.0));
        BodeContent all = example();
        all.measured->lines.pop_back();
        plots.show(all);
        QCOMPARE(plots.coherence()->finding(), QString());
        QCOMPARE(plots.legend().size(), std::size_t(2));
    }
    void intervalsAreThoseOfNinetyFivePercent()
    {
        BodePlots plots;
        plots.show(example());
        const FrequencyCurve& magnitude = plots.magnitude()->measured();
        QVERIFY(std::abs(std::log(magnitude.high[0] / magnitude.low[0]) - 2 * 1.96 * 0.02) < 1e-4);
        const FrequencyCurve& phase = plots.phase()->measured();
        QVERIFY(std::abs(phase.high[0] - phase.low[0] - 2 * 1.96 * 0.02 * 180 / M_PI) < 1e-2);
        // Only the spring counts at the lowest frequency, whose standard error is 1 %.
        const FrequencyCurve& model = plots.magnitude()->model();
        QVERIFY(std::abs(std::log(model.high[0] / model.low[0]) - 2 * 1.96 * 0.01) < 1e-3);
        QVERIFY(std::abs(model.value[0] - 0.1) < 1e-3); // 1000 / k
    }
    void aShortSqueezeShowsTheModelAlone()
    {
        BodePlots plots;
        BodeContent content = example();
        content.measured = EmpiricalResponse();
        plots.show(content);
        QVERIFY2(plots.accessibleDescription().contains(QString::number(EmpiricalResponse::leastSamples)),
                 qPrintable(plots.accessibleDescription()));
        QVERIFY(plots.magnitude()->measured().value.empty() && !plots.magnitude()->model().value.empty());
        QCOMPARE(plots.legend().size(), std::size_t(1));
    }
    void aZoomInOneIsAZoomInAll()
    {
        BodePlots plots;
        plots.resize(600, 480);
        plots.show(example());
        plots.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plots, test::longEnough_ms));
        const PlotRange whole = plots.phase()->horizontal();
        QVERIFY(std::abs(whole.low - std::log10(5.0)) < 1e-9);
        QTest::keyClick(plots.magnitude(), Qt::Key_Plus);
        QVERIFY(plots.phase()->horizontal().span() < 0.6 * whole.span());
        QCOMPARE(plots.coherence()->horizontal(), plots.magnitude()->horizontal());
    }
    void theFigureHasEveryPlotAndTheLegend()
    {
        BodePlots plots; // never on the screen
        plots.show(example());
        const FigureLayout layout(plots, FigureWidth::OneColumn);
        QCOMPARE(plots.pictureSize().width(), figureSize(FigureWidth::OneColumn).width());
        const QString svg = QString::fromUtf8(toSvg(plots));
        for (const QString& words : {u"Magnitude"_s, u"Phase"_s, u"Coherence"_s, u"Hz"_s, u"output error"_s,
                                     u"measured"_s, u"100"_s})
            QVERIFY2(svg.contains(words), qPrintable(words));
        static const QRegularExpression width(u"width=\"([0-9.]+)mm\""_s);
        QVERIFY(std::abs(width.match(svg).captured(1).toDouble() - 85) < 0.3);
        QVERIFY(!toImage(plots, 1).isNull());
    }
    void theNumbersAreThoseOfThePlots()
    {
        BodePlots plots;
        plots.show(example());
        const QByteArray csv = toCsv(plots.numbers());
        const QByteArray header = csv.left(csv.indexOf('\n'));
        QVERIFY2(header.startsWith("Frequency (Hz),\"Magnitude (u/v), measured\""), header.constData());
        QCOMPARE(csv.count('\n'), qsizetype(51)); // the model's fifty
    }
};

GRIPSCOPE_TEST(BodePlotsTest)
#include "bode_plots_test.moc"
