// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/bode_plots.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/region_plot.h"
#include "ui/format/number_format.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/widgets/elided_label.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

using namespace gripscope;

namespace {

QString allText(const QWidget& page)
{
    QStringList texts;
    for (const QLabel* label : page.findChildren<QLabel*>())
        if (label->isVisibleTo(&page)) {
            const auto* elided = qobject_cast<const ElidedLabel*>(label);
            texts << (elided ? elided->fullText() : label->text());
        }
    return texts.join(u'\n');
}

QPushButton* button(const QWidget& page, const QString& name)
{
    for (QPushButton* candidate : page.findChildren<QPushButton*>())
        if (candidate->accessibleName() == name)
            return candidate;
    return nullptr;
}

QByteArray contents(const QDir& folder, const QString& name)
{
    QFile file(folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The page has other tables too.
QTableView* estimatorTable(const FitPage& page)
{
    for (auto* table : page.findChildren<QTableView*>())
        if (qobject_cast<EstimateTableModel*>(table->model()))
            return table;
    qFatal("there is no table of estimators");
}

} // namespace

class FitPageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void anEmptyPageSaysWhatToDo()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        QVERIFY(allText(page).contains(QStringLiteral("Squeeze a part on Inspect")));
        QVERIFY(!button(page, QStringLiteral("Copy numbers"))->isEnabled());
    }
    void aSubjectIsShownAndIdentifiedByEveryEstimator()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        const Recording recording = simulatedSqueeze(test::canA, 3);
        fixture.bench.navigator().setFitSubject(
            {QStringLiteral("A, squeeze 3"), recording, identify(recording)});
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        QTRY_VERIFY(allText(page).contains(QStringLiteral("(95 %)"))); // labels appear with the next event
        QVERIFY(allText(page).contains(QStringLiteral("A, squeeze 3")));
        QVERIFY(allText(page).contains(QStringLiteral("Measurement valid")));
        const auto* model = page.findChild<EstimateTableModel*>();
        QVERIFY(model->rowOf(Estimator::ArxMeanForce) >= 0 && model->rowOf(Estimator::Arx221) >= 0);
    }
    void anIdentificationTellsHowFarItIsAndCanBeCancelled()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        const Recording recording = simulatedSqueeze(test::canA, 3);
        fixture.bench.navigator().setFitSubject({QStringLiteral("A"), recording, identify(recording)});
        // It runs: nothing of it can arrive before the next event.
        QVERIFY(allText(page).contains(QString::fromUtf8("identifying… 0 %")));
        auto* cancel = button(page, QStringLiteral("Cancel"));
        QVERIFY(cancel);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(!allText(page).contains(QStringLiteral("identifying")));
        const auto* model = page.findChild<EstimateTableModel*>();
        QTest::qWait(500); // what is still computed is dropped
        QCOMPARE(model->rowOf(Estimator::Arx221), -1);
        QTest::mouseClick(button(page, QStringLiteral("Identify again")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(model->rowOf(Estimator::Arx221) >= 0, test::longEnough_ms);
        QVERIFY(button(page, QStringLiteral("Identify again"))->isEnabled());
    }
    void anotherRowShowsThatModel()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        auto* table = estimatorTable(page);
        const auto* model = page.findChild<EstimateTableModel*>();
        const auto* plots = page.findChild<FitPlots*>();
        table->selectRow(model->rowOf(Estimator::Arx));
        QVERIFY(plots->response()->curves()[1].name.contains(QStringLiteral("ARX(2,1,1)")));
        table->selectRow(model->rowOf(Estimator::OutputError));
        QVERIFY(plots->response()->curves()[1].name.contains(QStringLiteral("output error")));
    }
    void aShortSqueezeIsToldWithItsLengthAndItsHeldForceInSteps()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        const Recording recording = slice(simulatedSqueeze(test::canA, 3), {0, 400});
        Identification found = identify(recording);
        fixture.bench.navigator().setFitSubject({QStringLiteral("short"), recording, std::move(found)});
        const QString words = allText(page);
        QVERIFY2(words.contains(formatLength(lengthSeconds(recording))), qPrintable(words));
        QVERIFY(words.contains(QStringLiteral("force held between samples")));
        const PlotCurve& force = page.findChild<FitPlots*>()->force()->curves().front();
        QVERIFY(force.held);
    }
    void thePageItWasChosenOnIsAClickAway()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        auto* back = page.findChild<QToolButton*>(QStringLiteral("fitBack"));
        const Recording recording = simulatedSqueeze(test::canA, 3);
        const Identification found = identify(recording);
        fixture.bench.navigator().setFitSubject({QStringLiteral("A"), recording, found});
        QVERIFY(!back->isVisible()); // it came by itself
        QSignalSpy asked(&fixture.bench.navigator(), &Navigator::pageRequested);
        fixture.bench.navigator().setFitSubject(
            {QStringLiteral("A"), recording, found, QStringLiteral("history")}); // the same one again
        QVERIFY(back->isVisible());
        QVERIFY2(back->toolTip().contains(QStringLiteral("History")), qPrintable(back->toolTip()));
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(asked.size(), qsizetype(1));
        QCOMPARE(asked.front().front().toString(), QStringLiteral("history"));
        fixture.bench.navigator().setFitSubject(
            {QStringLiteral("B"), recording, found, QStringLiteral("types")});
        QVERIFY2(back->toolTip().contains(QStringLiteral("Types")), qPrintable(back->toolTip()));
    }
    void theBodePlotShowsTheMeasurementAroundTheModel()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        const auto* bode = page.findChild<BodePlots*>();
        QVERIFY(!bode->isVisible());
        QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("bodeShown")), Qt::LeftButton);
        QVERIFY(bode->isVisible() && !page.findChild<FitPlots*>()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!bode->coherence()->measured().value.empty(), test::longEnough_ms);
        QCOMPARE(bode->magnitude()->title(), QStringLiteral("Magnitude (mm/N)"));

        // Can A itself: 95 % intervals from 13 averages hold it at most frequencies (94 % in a simulation of
        // 400 of them; 80 % is six deviations less).
        const FrequencyCurve& measured = bode->magnitude()->measured();
        QVERIFY(measured.value.size() > 30);
        const std::vector<ModelLine> truth = modelResponse(
            {0.0396, 43.0, 9990}, std::nullopt, {0.0005, ForceHold::Zero, 0}, measured.frequency_Hz);
        int held = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double value = 1e3 * std::abs(truth[i].response);
            held += value >= measured.low[i] && value <= measured.high[i] ? 1 : 0;
        }
        QVERIFY2(held > 0.8 * double(truth.size()),
                 qPrintable(QStringLiteral("%1 of %2").arg(held).arg(truth.size())));
        // The model at its lowest frequency is the spring: 1/k, within its band, which is narrow.
        const FrequencyCurve& model = bode->magnitude()->model();
        QVERIFY(std::abs(model.value.front() * 9.990 - 1) < 0.01);
        QVERIFY(model.low.front() < model.value.front() && model.high.front() < 1.02 * model.value.front());

        auto* table = estimatorTable(page);
        const auto* estimates = page.findChild<EstimateTableModel*>();
        table->selectRow(estimates->rowOf(Estimator::Arx));
        QVERIFY(bode->legend().back().name.contains(QStringLiteral("ARX(2,1,1)")));
    }
    void aRecordingIsOpenedAndIdentified()
    {
        test::PageFixture fixture;
        const QString file = fixture.folder.filePath(QStringLiteral("squeeze.csv"));
        QVERIFY(writeRecordingCsv(simulatedSqueeze(test::canA, 4), file));
        FitPage page(fixture.bench);
        page.show();
        page.openRecordings({file});
        QTRY_VERIFY_WITH_TIMEOUT(fixture.bench.navigator().fitSubject().has_value(), test::longEnough_ms);
        QCOMPARE(fixture.bench.navigator().fitSubject()->title, QStringLiteral("squeeze.csv"));
        const Estimate* best = fixture.bench.navigator().fitSubject()->identification.best();
        QVERIFY(best && std::abs(best->parameters->k / test::canA.k - 1) < 0.01);
        QVERIFY(fixture.reports.isEmpty());
    }
    void aBadFileIsReportedWithItsName()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        page.openRecordings({fixture.folder.filePath(QStringLiteral("absent.csv"))});
        QTRY_COMPARE_WITH_TIMEOUT(fixture.reports.size(), 1, test::longEnough_ms);
        QVERIFY(fixture.reports.first().first().toString().contains(QStringLiteral("absent.csv")));
        QVERIFY(!fixture.bench.navigator().fitSubject());
    }
    void aMeasurementWithoutForceSaysSo()
    {
        test::PageFixture fixture;
        Recording flat = simulatedSqueeze(test::canA, 5);
        std::fill(flat.force.begin(), flat.force.end(), 20.0);
        FitPage page(fixture.bench);
        page.show();
        fixture.bench.navigator().setFitSubject({QStringLiteral("flat"), flat, identify(flat)});
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        QVERIFY(allText(page).contains(QStringLiteral("Measurement not valid")));
        // What failed is in view without a click.
        const auto* tabs = page.findChild<QTabWidget*>();
        QVERIFY(tabs->tabText(tabs->currentIndex()).startsWith(QStringLiteral("Checks (")));
    }
    void numbersAreCopiedInEachForm()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        const auto copied = [&page](const char* name) {
            page.findChild<QAction*>(QLatin1String(name))->trigger();
            return QGuiApplication::clipboard()->text();
        };
        QVERIFY(button(page, QStringLiteral("Copy numbers"))->menu() != nullptr);
        QVERIFY(copied("copyText").contains(QStringLiteral("\nm = ")) &&
                copied("copyText").contains(QChar(0x00B1)));
        QVERIFY(copied("copyLatex").contains(QStringLiteral("\\pm")));
        QVERIFY(copied("copyCsv").startsWith(QStringLiteral("quantity,value,half_width_95")));
        const QString text = copied("copyAll");
        QVERIFY(text.startsWith(QStringLiteral("estimator\tm (kg)")));
        for (const char* block : {"\n\nquantity\tvalue", "\n\ncorrelation\tm\tb\tk\nm\t1\t",
                                  "\nwhiteness (Ljung-Box)\t0.", "\nexcitation\tyes\t", "\nverdict\tvalid"})
            QVERIFY2(text.contains(QLatin1String(block)),
                     qPrintable(text.mid(text.indexOf(QStringLiteral("correlation")), 400)));
    }
    void theTableIsCopiedByItsKey()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        page.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&page, gripscope::test::longEnough_ms));
        auto* table = estimatorTable(page);
        table->setFocus();
        QGuiApplication::clipboard()->clear();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        const QString text = QGuiApplication::clipboard()->text();
        QVERIFY(text.startsWith(QStringLiteral("estimator\t")) && text.contains(QStringLiteral("\noe\t")));
    }
    void everyPlotAndNumberIsSaved()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        auto* exporter = page.findChild<FitExporter*>();
        const QDir folder(fixture.folder.path());
        exporter->saveAll(folder.path());
        QTRY_COMPARE_WITH_TIMEOUT(exporter->pending(), 0, test::longEnough_ms);
        QVERIFY(fixture.reports.isEmpty());
        for (const char* name : {"position", "force", "residuals", "autocorrelation", "cross-correlation",
                                 "joint-region", "bode"}) {
            const QString base = QStringLiteral("Simulated-squeeze-of-can-A-") + QLatin1String(name);
            QVERIFY2(!QImage(folder.filePath(base + QStringLiteral(".png"))).isNull(), name);
            QVERIFY2(contents(folder, base + QStringLiteral(".svg")).contains("<svg"), name);
            QVERIFY2(contents(folder, base + QStringLiteral(".csv")).count('\n') > 20, name);
        }
        const QJsonObject numbers =
            QJsonDocument::fromJson(
                contents(folder, QStringLiteral("Simulated-squeeze-of-can-A-numbers.json")))
                .object();
        QCOMPARE(numbers[QStringLiteral("recommended")].toString(), QStringLiteral("oe"));
        QVERIFY(numbers[QStringLiteral("estimates")].toArray().size() >= 4);
    }
    void whatCannotBeSavedIsSaidOnce()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        page.findChild<FitExporter*>()->saveAll(fixture.folder.filePath(QStringLiteral("absent/folder")));
        QTRY_COMPARE_WITH_TIMEOUT(fixture.reports.size(), 1, test::longEnough_ms);
        const QString said = fixture.reports.first().first().toString();
        QVERIFY(said.contains(QStringLiteral("Choose a folder")) && said.contains(QStringLiteral("absent")));
    }
    void everyPlotHasAMenuForMouseAndKeys()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        auto* plot = page.findChild<FitPlots*>()->residuals();
        const auto menu = [&] { return plot->findChild<QMenu*>(QStringLiteral("plotMenu")); };
        QTest::keyClick(plot, Qt::Key_F10, Qt::ShiftModifier);
        QVERIFY(menu() && menu()->isVisible());
        QCOMPARE(menu()->actions().size(), qsizetype(4));
        menu()->actions().first()->trigger(); // copy picture
        QVERIFY(!QGuiApplication::clipboard()->image().isNull());
        menu()->close();
        QTRY_VERIFY(!menu());
        QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(80, 40),
                                plot->viewport()->mapToGlobal(QPoint(80, 40)));
        QCoreApplication::sendEvent(plot->viewport(), &event);
        QVERIFY(menu() && menu()->isVisible());
        menu()->close();
    }
    void theExportButtonListsEveryPlot()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        auto* save = button(page, QStringLiteral("Export"));
        QVERIFY(save && save->menu() && !save->isEnabled());
        QStringList names;
        for (const QAction* action : save->menu()->actions())
            names << action->text();
        for (const char* name :
             {"All numbers as JSON…", "Position", "Force", "Residuals", "Joint region", "Bode plot"})
            QVERIFY2(names.contains(QString::fromUtf8(name)), name);
        QVERIFY(save->sizeHint().height() >= metrics::touchTarget);
    }
    void nothingIsCutOffOrScrollsSidewaysAtTheLeastSize()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(928, 520); // what a window of 1024 x 640 leaves
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        QVERIFY(page.minimumSizeHint().width() <= 928);
        QVERIFY2(page.minimumSizeHint().height() <= 520,
                 qPrintable(QString::number(page.minimumSizeHint().height())));
        auto* tabs = page.findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QCoreApplication::processEvents();
            auto* scroll = qobject_cast<QScrollArea*>(tabs->widget(i));
            if (!scroll)
                continue; // what does not scroll is part of the minimum above
            QVERIFY2(scroll->widget()->minimumSizeHint().width() <= scroll->viewport()->width(),
                     qPrintable(QStringLiteral("%1: %2 > %3")
                                    .arg(tabs->tabText(i))
                                    .arg(scroll->widget()->minimumSizeHint().width())
                                    .arg(scroll->viewport()->width())));
        }
        QVERIFY(tabs->tabBar()->sizeHint().width() <= tabs->width());
    }
    void theTabsAreWalkedByKeys()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.show();
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        auto* tabs = page.findChild<QTabWidget*>();
        tabs->tabBar()->setFocus();
        QTest::keyClick(tabs->tabBar(), Qt::Key_Right);
        QVERIFY(page.findChild<RegionPlot*>()->isVisible());
        QVERIFY(page.findChild<RegionPlot*>()->region().has_value());
        QTest::keyClick(tabs->tabBar(), Qt::Key_Right);
        QVERIFY(allText(page).contains(QStringLiteral("Excitation.")));
        QVERIFY(allText(page).contains(QStringLiteral("Measurement valid"))); // on every tab
        QTest::keyClick(tabs->tabBar(), Qt::Key_Right);
        QVERIFY(allText(page).contains(QStringLiteral("What would make it better")));
        QVERIFY(allText(page).contains(QStringLiteral("Natural frequency")));
    }
    void bothThemesAreTakenWhileShown()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.show();
        page.resize(1200, 800);
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        const auto* plots = page.findChild<FitPlots*>();
        Theme::instance().apply(ThemeKind::Dark);
        QCOMPARE(plots->response()->grab().toImage().pixelColor(3, 60), themeTokens(ThemeKind::Dark).surface);
        Theme::instance().apply(ThemeKind::Light);
        QCOMPARE(plots->response()->grab().toImage().pixelColor(3, 60),
                 themeTokens(ThemeKind::Light).surface);
    }
};

GRIPSCOPE_TEST(FitPageTest)
#include "fit_page_test.moc"
