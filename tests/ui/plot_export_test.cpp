// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/plot_export.h"
#include "ui/theme/theme.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <limits>

using namespace gripscope;

namespace {

std::shared_ptr<const std::vector<double>> shared(std::vector<double> values)
{
    return std::make_shared<const std::vector<double>>(std::move(values));
}

/// Every point of every polyline of an SVG file, with the transformation in front of it.
QList<QPointF> linePoints(const QByteArray& svg)
{
    QList<QPointF> points;
    QXmlStreamReader xml(svg);
    QTransform transform;
    static const QRegularExpression matrix(QStringLiteral("matrix\\(([^)]*)\\)"));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (const auto match = matrix.match(xml.attributes().value(QLatin1String("transform")));
            match.hasMatch()) {
            const QStringList m = match.captured(1).split(QLatin1Char(','));
            transform = QTransform(m[0].toDouble(), m[1].toDouble(), m[2].toDouble(), m[3].toDouble(),
                                   m[4].toDouble(), m[5].toDouble());
        }
        if (xml.name() != QLatin1String("polyline"))
            continue;
        for (const QString& pair : xml.attributes()
                                       .value(QLatin1String("points"))
                                       .toString()
                                       .split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const QStringList xy = pair.split(QLatin1Char(','));
            points << transform.map(QPointF(xy[0].toDouble(), xy[1].toDouble()));
        }
    }
    return points;
}

} // namespace

class PlotExportTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<TimePlot> sinePlot()
    {
        auto plot = std::make_unique<TimePlot>();
        plot->resize(500, 200);
        plot->setTitle(QStringLiteral("Force (N)"));
        plot->setExportNames(QStringLiteral("Force"), QStringLiteral("force"), QStringLiteral("Time (s)"));
        std::vector<double> x, y;
        for (int i = 0; i < 400; ++i) {
            x.push_back(0.01 * i);
            y.push_back(std::sin(0.1 * i));
        }
        plot->setCurves({{QString(), CurveRole::Force, shared(x), shared(y), {}}});
        plot->setWhole({0, 4});
        plot->setVertical({-0.3, 0.3}); // most of the curve is outside
        plot->QWidget::show();
        return plot;
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void csvBringsEveryNumberBack()
    {
        const std::vector<double> values{1.0 / 3, -2.5e-300, 6.02214076e23, 0.1};
        const QByteArray csv = toCsv({{QStringLiteral("Time (s)"), shared({0, 1, 2, 3})},
                                      {QStringLiteral("Model, output error (mm)"), shared(values)}});
        const QList<QByteArray> lines = csv.split('\n');
        QCOMPARE(lines.front(), QByteArray("Time (s),\"Model, output error (mm)\""));
        QCOMPARE(lines.size(), qsizetype(6)); // the last is empty: the text ends with a line feed
        for (std::size_t i = 0; i < values.size(); ++i)
            QCOMPARE(lines[qsizetype(i) + 1].split(',').at(1).toDouble(), values[i]);
    }
    void csvLeavesOutWhatDoesNotExist()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(toCsv({{QStringLiteral("a"), shared({1, nan})}, {QStringLiteral("b \"c\""), shared({2})}}),
                 QByteArray("a,b \"c\"\n1,2\n,\n").replace("b \"c\"", "\"b \"\"c\"\"\""));
        QCOMPARE(toCsv(PlotTable{}), QByteArray("\n"));
    }
    void aPictureHasTwiceThePixelsOfTheScreen()
    {
        const auto plot = sinePlot();
        QVERIFY(QTest::qWaitForWindowExposed(plot.get(), gripscope::test::longEnough_ms));
        const QImage image = toImage(*plot);
        QCOMPARE(image.size(), 2 * plot->viewport()->size());
        QCOMPARE(image.pixelColor(4, image.height() / 2), themeTokens(ThemeKind::Light).surface);
        int curve = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                curve += image.pixelColor(x, y) == themeTokens(ThemeKind::Light).force ? 1 : 0;
        QVERIFY2(curve > 200, qPrintable(QString::number(curve)));
        QVERIFY(QImage::fromData(toPng(image)).size() == image.size());
    }
    void theCurvesAreBackOnTheScreenAfterAPicture()
    {
        const auto plot = sinePlot();
        QVERIFY(QTest::qWaitForWindowExposed(plot.get(), gripscope::test::longEnough_ms));
        const QImage before = plot->grab().toImage();
        (void)toImage(*plot);
        QCOMPARE(plot->grab().toImage(), before);
    }
    void figuresHaveTheWidthOfAJournalsColumns_data()
    {
        QTest::addColumn<FigureWidth>("width");
        QTest::addColumn<double>("millimetres");
        QTest::newRow("one column") << FigureWidth::OneColumn << 85.0;
        QTest::newRow("two columns") << FigureWidth::TwoColumns << 175.0;
    }
    void figuresHaveTheWidthOfAJournalsColumns()
    {
        QFETCH(FigureWidth, width);
        QFETCH(double, millimetres);
        const auto plot = sinePlot();
        QVERIFY(QTest::qWaitForWindowExposed(plot.get(), gripscope::test::longEnough_ms));
        const QImage before = plot->grab().toImage();
        {
            const FigureLayout layout(*plot, width);
            const QByteArray svg = toSvg(*plot);
            static const QRegularExpression size(QStringLiteral("width=\"([0-9.]+)mm\""));
            QVERIFY(std::abs(size.match(QString::fromUtf8(svg)).captured(1).toDouble() - millimetres) < 0.3);
            const QRectF room(QPointF(), QSizeF(figureSize(width)));
            double right = 0;
            for (const QPointF& point : linePoints(svg)) {
                QVERIFY(room.adjusted(-1, -1, 1, 1).contains(point));
                right = std::max(right, point.x());
            }
            QVERIFY2(right > room.width() - 40, qPrintable(QString::number(right))); // laid out for it
            const QImage image = toImage(*plot, figureScale(width));
            const double printed_mm = 1000.0 * image.width() / image.dotsPerMeterX();
            QVERIFY2(std::abs(printed_mm - millimetres) < 0.3, qPrintable(QString::number(printed_mm)));
            QVERIFY(image.dotsPerMeterX() > 23'500); // 600 dpi
        }
        QCOMPARE(plot->grab().toImage(), before);
    }
    void svgCutsCurvesOffAtThePlotAndHasNoBitmaps()
    {
        const auto plot = sinePlot();
        QVERIFY(QTest::qWaitForWindowExposed(plot.get(), gripscope::test::longEnough_ms));
        const QByteArray svg = toSvg(*plot);
        QVERIFY(svg.contains("Force (N)"));
        QVERIFY(svg.contains("Time (s)")); // which the screen leaves to the plot below
        QVERIFY(!svg.contains("<image"));
        const QList<QPointF> points = linePoints(svg);
        QVERIFY(points.size() > 20);
        const QRectF room = QRectF(plot->chart()->plotArea()).adjusted(-1, -1, 1, 1);
        int curve = 0;
        for (const QPointF& point : points) {
            curve += room.contains(point) ? 1 : 0;
            QVERIFY(QRectF(plot->viewport()->rect()).adjusted(-1, -1, 1, 1).contains(point));
            QVERIFY(point.y() <= room.bottom() + 8 && point.y() >= room.top() - 1); // ticks reach below
        }
        QVERIFY(curve > 20);
    }
    void timePlotsHandOutAllOfTheirNumbers()
    {
        FitPlots plots;
        const Identification identification = test::identifiedCanA();
        plots.show(identification, Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        const PlotTable table = plots.response()->numbers();
        QCOMPARE(table.size(), std::size_t(3));
        QCOMPARE(table[0].name, QStringLiteral("Time (s)"));
        QCOMPARE(table[1].name, QStringLiteral("Measured position (mm)"));
        QCOMPARE(table[2].name, QStringLiteral("Model, output error (mm)"));
        QCOMPARE(table[1].values->size(), identification.position.size());
        QCOMPARE(table[1].values->at(7), 1000 * identification.position[7]);
        QCOMPARE(plots.residuals()->numbers().at(1).name, QString::fromUtf8("Residuals (µm)"));
    }
    /// Programs read them: they do not change with what a person reads.
    void tablesStayInTheirUnits()
    {
        FitPlots plots;
        const Identification identification = test::identifiedCanA();
        const auto show = [&](DisplayUnits units) {
            DisplayUnits::choose(units);
            plots.show(identification, Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        };
        const auto tables = [&plots] {
            return toCsv(plots.response()->numbers()) + toCsv(plots.force()->numbers()) +
                   toCsv(plots.residuals()->numbers());
        };
        show({});
        const QByteArray metric = tables();
        show({DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch});
        QCOMPARE(plots.response()->accessibleName(), QStringLiteral("Position (in)"));
        QCOMPARE(plots.force()->accessibleName(), QStringLiteral("Force (lbf)"));
        QCOMPARE(tables(), metric);
        DisplayUnits::choose({});
    }
    void whatWasNotMeasuredIsLeftEmptyAndAPartKeepsItsTime()
    {
        TimePlot plot;
        const auto time = shared({0, 1, 2, 3});
        const auto lost = std::make_shared<const std::vector<std::size_t>>(std::vector<std::size_t>{1});
        plot.setCurves(
            {{QString(), CurveRole::MeasuredPosition, time, shared({5, 6, 7, 8}), QStringLiteral("measured"),
              lost},
             {QString(), CurveRole::Model, shared({2, 3}), shared({70, 80}), QStringLiteral("model")}});
        QCOMPARE(toCsv(plot.numbers()), QByteArray("Time (s),measured,model\n0,5,\n1,,\n2,7,70\n3,8,80\n"));
    }
    void correlationsComeWithLagAndBand()
    {
        FitPlots plots;
        const Identification identification = test::identifiedCanA();
        plots.show(identification, Estimator::OutputError, QStringLiteral("N"), QStringLiteral("m"));
        const PlotTable table = plots.crossCorrelations()->numbers();
        QCOMPARE(table.size(), std::size_t(4));
        QCOMPARE(table[0].values->front(), -25.0);
        QCOMPARE(table[1].values->front(), -25 * 1000 * identification.sampleTime_s);
        QVERIFY(std::abs(table[3].values->front() -
                         1.96 / std::sqrt(double(identification.position.size()))) < 1e-4);
    }
};

GRIPSCOPE_TEST(PlotExportTest)
#include "plot_export_test.moc"
