// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/charts/fit_plots.h"
#include "ui/theme/theme.h"

#include <QTest>

#include <cmath>
#include <numeric>

using namespace gripscope;

class FitPlotsTest : public QObject {
    Q_OBJECT

    static void showPlots(FitPlots& plots)
    {
        plots.resize(800, 640);
        plots.show(test::identifiedCanA(), Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        plots.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plots, gripscope::test::longEnough_ms));
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void titlesNameQuantityAndUnit()
    {
        FitPlots plots;
        showPlots(plots);
        QCOMPARE(plots.response()->accessibleName(), QStringLiteral("Position (mm)"));
        QCOMPARE(plots.force()->accessibleName(), QStringLiteral("Force (N)"));
        QCOMPARE(plots.residuals()->accessibleName(), QString::fromUtf8("Residuals (µm)"));
    }
    void measuredAndModelLieOverEachOther()
    {
        FitPlots plots;
        showPlots(plots);
        const auto& curves = plots.response()->curves();
        QCOMPARE(curves.size(), std::size_t(2));
        QCOMPARE(curves[0].y->size(), curves[1].y->size());
        double worst = 0;
        for (std::size_t i = 0; i < curves[0].y->size(); ++i)
            worst = std::max(worst, std::abs((*curves[0].y)[i] - (*curves[1].y)[i]));
        QVERIFY(worst < 0.03); // mm; noise of 5 um never reaches six times that
    }
    void aForceThatIsHeldIsDrawnInSteps()
    {
        TimePlot plot;
        plot.resize(500, 200);
        plot.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, gripscope::test::longEnough_ms));
        const auto x = std::make_shared<std::vector<double>>(std::vector<double>{0, 1, 2, 3});
        const auto y = std::make_shared<std::vector<double>>(std::vector<double>{0, 5, 5, 1});
        PlotCurve curve{QStringLiteral("u"), CurveRole::Force, x, y};
        plot.setCurves({curve});
        plot.setWhole({0, 3});
        QCOMPARE(plot.drawnPoints(), 4);
        curve.held = true;
        plot.setCurves({curve});
        QCOMPARE(plot.drawnPoints(), 7);                                 // a corner before each but the first
        QCOMPARE(plot.numbers().front().values->size(), std::size_t(4)); // what is exported stays as measured
    }
    void aLongRecordingIsDrawnWithTwoPointsAColumn()
    {
        TimePlot plot;
        plot.resize(500, 200);
        plot.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, gripscope::test::longEnough_ms));
        auto x = std::make_shared<std::vector<double>>(200000);
        std::iota(x->begin(), x->end(), 0.0);
        auto y = std::make_shared<std::vector<double>>(*x);
        for (double& value : *y)
            value = std::sin(value / 50);
        plot.setCurves({{QStringLiteral("y"), CurveRole::Force, x, y}});
        plot.setWhole({0, 199999});
        QVERIFY(plot.drawnPoints() > 200);
        QVERIFY(plot.drawnPoints() <= 2 * plot.columns() + 2);
        plot.setHorizontal({1000, 1100});
        QVERIFY(plot.drawnPoints() >= 100 &&
                plot.drawnPoints() <= 104); // now every sample, and the neighbours
    }
    void aShortSqueezeHasItsTimesInMilliseconds()
    {
        TimePlot plot;
        plot.resize(500, 200);
        plot.setExportNames(QStringLiteral("Force"), QStringLiteral("force"), QStringLiteral("Time (s)"));
        auto x = std::make_shared<std::vector<double>>();
        for (int i = 0; i <= 40; ++i)
            x->push_back(0.001 * i);
        plot.setCurves({{QStringLiteral("y"), CurveRole::Force, x, x}});
        plot.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, gripscope::test::longEnough_ms));
        plot.setDuration(0.04);
        QCOMPARE(plot.horizontal(), (PlotRange{0, 40}));
        QCOMPARE(plot.drawnPoints(), 41);
        const QByteArray svg = toSvg(plot);
        QVERIFY(svg.contains("Time (ms)") && !svg.contains("Time (s)"));
        plot.setHorizontal({10, 20});
        QVERIFY(plot.drawnPoints() >= 11 && plot.drawnPoints() <= 13); // and the neighbours
        plot.fitVertical();
        QVERIFY(plot.vertical().low > 0.008 && plot.vertical().high < 0.022);
        // Tables stay in seconds.
        const PlotTable table = plot.numbers();
        QCOMPARE(table[0].name, QStringLiteral("Time (s)"));
        QCOMPARE(table[0].values->back(), x->back());
        plot.setDuration(0.5);
        QCOMPARE(plot.horizontal(), (PlotRange{0, 0.5}));
        QVERIFY(toSvg(plot).contains("Time (s)"));
    }
    void allPlotsOfAFitHaveOneTime()
    {
        Identification identification = test::identifiedCanA();
        const double whole = identification.time_s.back() - identification.time_s.front();
        for (double& time : identification.time_s)
            time *= 0.1 / whole;
        FitPlots plots;
        plots.show(identification, Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        for (const TimePlot* plot : {plots.response(), plots.force(), plots.residuals()})
            QVERIFY(std::abs(plot->horizontal().high - 100) < 1e-9);
        QTest::keyClick(plots.force(), Qt::Key_Plus);
        QCOMPARE(plots.residuals()->horizontal(), plots.force()->horizontal());
        QVERIFY(plots.residuals()->horizontal().span() < 51);
        plots.show(test::identifiedCanA(), Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        QVERIFY(std::abs(plots.force()->horizontal().high - whole) < 1e-9); // longer: in seconds again
    }
    void aZoomInOnePlotIsAZoomInAll()
    {
        FitPlots plots;
        showPlots(plots);
        const PlotRange whole = plots.residuals()->horizontal();
        QTest::keyClick(plots.response(), Qt::Key_Plus);
        QVERIFY(plots.response()->horizontal().span() < 0.6 * whole.span());
        QCOMPARE(plots.residuals()->horizontal(), plots.response()->horizontal());
        QCOMPARE(plots.force()->horizontal(), plots.response()->horizontal());
        QTest::mouseDClick(plots.force()->viewport(), Qt::LeftButton, {}, QPoint(200, 50));
        QCOMPARE(plots.response()->horizontal(), whole);
    }
    void aRubberBandZooms()
    {
        FitPlots plots;
        showPlots(plots);
        const PlotRange whole = plots.response()->horizontal();
        QWidget* view = plots.response()->viewport();
        QTest::mousePress(view, Qt::LeftButton, {}, QPoint(200, 40));
        QTest::mouseMove(view, QPoint(300, 70));
        QTest::mouseMove(view, QPoint(400, 100));
        QTest::mouseRelease(view, Qt::LeftButton, {}, QPoint(400, 100));
        QVERIFY(plots.response()->horizontal().span() < 0.5 * whole.span());
        QCOMPARE(plots.force()->horizontal(), plots.response()->horizontal());
    }
    void residualsOfTheRightModelKeepToTheBand()
    {
        FitPlots plots;
        showPlots(plots);
        // 25 and 51 lags at 5 %: 1.25 and 2.6 expected beyond it. The input is far from white, which makes
        // neighbours of the cross-correlation alike; a whole run outside would still be three times as many.
        QVERIFY(plots.autocorrelations()->lagsOutside() <= 5);
        QVERIFY(plots.crossCorrelations()->lagsOutside() <= 12);
    }
    void residualsOfPlainArxDoNot()
    {
        FitPlots plots;
        plots.show(test::identifiedCanA(), Estimator::Arx, QStringLiteral("N"), QStringLiteral("m"));
        QVERIFY(plots.autocorrelations()->lagsOutside() >= 1);
        QVERIFY(plots.crossCorrelations()->lagsOutside() >= 5);
    }
    void withoutAModelTheMeasurementIsShownAlone()
    {
        FitPlots plots;
        plots.show(test::identifiedCanA(), Estimator::Duffing, QStringLiteral("N"), QStringLiteral("m"));
        QCOMPARE(plots.response()->curves().size(), std::size_t(1));
        QCOMPARE(plots.autocorrelations()->lagsOutside(), 0);
        plots.show(Identification{}, Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        QVERIFY(plots.response()->curves().empty());
    }
};

GRIPSCOPE_TEST(FitPlotsTest)
#include "fit_plots_test.moc"
