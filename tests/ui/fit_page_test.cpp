// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/time_plot.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit_page.h"
#include "ui/pages/fit_page_summary.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

using namespace gripscope;

namespace {

QString allText(const QWidget& page)
{
    QStringList texts;
    for (const QLabel* label : page.findChildren<QLabel*>())
        if (label->isVisibleTo(&page))
            texts << label->text();
    return texts.join(u'\n');
}

QPushButton* button(const QWidget& page, const QString& name)
{
    for (QPushButton* candidate : page.findChildren<QPushButton*>())
        if (candidate->accessibleName() == name)
            return candidate;
    return nullptr;
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
        fixture.bench.setFitSubject({QStringLiteral("A, squeeze 3"), recording, identify(recording)});
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        QTRY_VERIFY(allText(page).contains(QStringLiteral("(95 %)"))); // labels appear with the next event
        QVERIFY(allText(page).contains(QStringLiteral("A, squeeze 3")));
        QVERIFY(allText(page).contains(QStringLiteral("Measurement valid")));
        const auto* model = page.findChild<EstimateTableModel*>();
        QVERIFY(model->rowOf(Estimator::ArxMeanForce) >= 0 && model->rowOf(Estimator::Arx221) >= 0);
    }
    void anotherRowShowsThatModel()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        auto* table = page.findChild<QTableView*>();
        const auto* model = page.findChild<EstimateTableModel*>();
        const auto* plots = page.findChild<FitPlots*>();
        table->selectRow(model->rowOf(Estimator::Arx));
        QVERIFY(plots->response()->curves()[1].name.contains(QStringLiteral("ARX(2,1,1)")));
        table->selectRow(model->rowOf(Estimator::OutputError));
        QVERIFY(plots->response()->curves()[1].name.contains(QStringLiteral("output error")));
    }
    void aRecordingIsOpenedAndIdentified()
    {
        test::PageFixture fixture;
        const QString file = fixture.folder.filePath(QStringLiteral("squeeze.csv"));
        QVERIFY(writeRecordingCsv(simulatedSqueeze(test::canA, 4), file));
        FitPage page(fixture.bench);
        page.openRecording(file);
        QTRY_VERIFY_WITH_TIMEOUT(fixture.bench.fitSubject().has_value(), test::patience_ms);
        QCOMPARE(fixture.bench.fitSubject()->title, QStringLiteral("squeeze.csv"));
        const Estimate* best = fixture.bench.fitSubject()->identification.best();
        QVERIFY(best && std::abs(best->parameters->k / test::canA.k - 1) < 0.01);
        QVERIFY(fixture.reports.isEmpty());
    }
    void aBadFileIsReportedWithItsName()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.openRecording(fixture.folder.filePath(QStringLiteral("absent.csv")));
        QTRY_COMPARE_WITH_TIMEOUT(fixture.reports.size(), 1, test::patience_ms);
        QVERIFY(fixture.reports.first().first().toString().contains(QStringLiteral("absent.csv")));
        QVERIFY(!fixture.bench.fitSubject());
    }
    void aMeasurementWithoutForceSaysSo()
    {
        test::PageFixture fixture;
        Recording flat = simulatedSqueeze(test::canA, 5);
        std::fill(flat.force.begin(), flat.force.end(), 20.0);
        FitPage page(fixture.bench);
        fixture.bench.setFitSubject({QStringLiteral("flat"), flat, identify(flat)});
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        QVERIFY(allText(page).contains(QStringLiteral("Measurement not valid")));
    }
    void numbersAreCopiedTabSeparated()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        button(page, QStringLiteral("Copy numbers"))->click();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("estimator\tm (kg)")));
    }
    void bothThemesAreTakenWhileShown()
    {
        test::PageFixture fixture;
        FitPage page(fixture.bench);
        page.resize(1200, 800);
        page.prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
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
