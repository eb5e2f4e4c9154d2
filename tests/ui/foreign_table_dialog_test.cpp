// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/fit_plots.h"
#include "ui/imports/foreign_table_dialog.h"
#include "ui/imports/import_layouts.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/pages/fit/fit_page_squeezes.h"
#include "ui/settings/values/settings.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QByteArray comma(double value)
{
    return QByteArray::number(value, 'e', 17).replace('.', ',');
}

/// A squeeze as a German measuring program would write it, and `end` below.
QByteArray germanSqueeze(const QByteArray& end = {})
{
    const Recording recording = simulatedSqueeze(test::canA, 4);
    QByteArray text("Versuch 7;;\nZeit;Kraft;Weg\nms;N;mm\n");
    for (std::size_t i = 0; i < recording.size(); ++i)
        text += comma(1e3 * recording.time_s[i]) + ';' + comma(recording.force[i]) + ';' +
                comma(1e3 * recording.position[i]) + '\n';
    return text + end;
}

struct Opened {
    test::PageFixture fixture;
    FitPage page{fixture.bench};

    Opened()
    {
        page.resize(1200, 800);
        page.show();
    }
    QString file(const QByteArray& text, const QString& name = QStringLiteral("squeeze.txt"))
    {
        QFile out(fixture.folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
            qFatal("not written");
        return out.fileName();
    }
    /// The one that is open.
    ForeignTableDialog* dialog() const
    {
        for (auto* one : page.findChildren<ForeignTableDialog*>())
            if (one->isVisible())
                return one;
        return nullptr;
    }
    bool asked() const
    {
        return QTest::qWaitFor([this] { return dialog() != nullptr; }, test::longEnough_ms);
    }
    QString words() const { return dialog()->findChild<QLabel*>(u"importWords"_s)->text(); }
    QComboBox* box(const char* name) const { return dialog()->findChild<QComboBox*>(QLatin1String(name)); }
    QPushButton* import() const { return dialog()->findChild<QPushButton*>(u"importTable"_s); }
    bool identified()
    {
        return QTest::qWaitFor([this] { return fixture.bench.navigator().fitSubject().has_value(); },
                               test::longEnough_ms);
    }
};

ForeignTable tableOf(const QByteArray& text)
{
    return *examineTable(text, u"x.csv"_s);
}

} // namespace

class ForeignTableDialogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void aTableOfAnotherProgramIsAskedAboutAndIdentified()
    {
        Opened opened;
        opened.page.openRecordings({opened.file(germanSqueeze())});
        QVERIFY(opened.asked());
        QCOMPARE(opened.box("importForce")->currentText(), u"Kraft"_s);
        QCOMPARE(opened.box("importTimeUnit")->currentText(), u"ms"_s);
        const auto* preview = opened.dialog()->findChild<QTableWidget*>(u"importPreview"_s);
        QVERIFY(preview->rowCount() > 5);
        QVERIFY(preview->horizontalHeaderItem(2)->text().contains(u"Position"_s));
        QVERIFY2(opened.words().contains(u"Sample time 0.5 ms"_s), qPrintable(opened.words()));
        opened.box("importHold")->setCurrentIndex(1); // held
        QTest::mouseClick(opened.import(), Qt::LeftButton);
        QVERIFY(opened.identified());
        const auto& subject = opened.fixture.bench.navigator().fitSubject();
        QCOMPARE(subject->recording.positionUnit, u"mm"_s);
        QVERIFY(subject->recording.hold == ForceHold::Zero);
        // The unit is N/mm; 1 % is what such a squeeze allows.
        QVERIFY(std::abs(1e3 * subject->identification.best()->parameters->k / test::canA.k - 1) < 0.01);
        QVERIFY(opened.fixture.reports.isEmpty());
        QVERIFY(!opened.dialog());

        // From there to a figure and a table for a paper.
        auto* exporter = opened.page.findChild<FitExporter*>();
        exporter->setFigureWidth(FigureWidth::OneColumn);
        const QString figure = opened.fixture.folder.filePath(u"figure.svg"_s);
        exporter->savePlot(opened.page.findChild<FitPlots*>()->response(), PlotFormat::Svg, figure);
        QTRY_COMPARE_WITH_TIMEOUT(exporter->pending(), 0, test::longEnough_ms);
        QFile saved(figure);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QByteArray svg = saved.readAll();
        QVERIFY2(svg.contains("width=\"84.9"), svg.left(400).constData());
        opened.page.findChild<QAction*>(u"copyLatex"_s)->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().contains(u"\n$m = ("_s));

        // Another table of this layout comes with what was said.
        opened.page.openRecordings({opened.file(germanSqueeze(), u"again.txt"_s)});
        QVERIFY(opened.asked());
        QCOMPARE(opened.box("importHold")->currentIndex(), 1);
    }
    void whatIsChosenIsTriedAtOnce()
    {
        Opened opened;
        opened.page.openRecordings({opened.file(germanSqueeze())});
        QVERIFY(opened.asked());
        QVERIFY(opened.import()->isEnabled());
        opened.box("importDecimalMark")->setCurrentIndex(0); // a point
        QVERIFY2(opened.words().contains(u"squeeze.txt:"_s), qPrintable(opened.words()));
        QVERIFY(!opened.import()->isEnabled());
        opened.box("importDecimalMark")->setCurrentIndex(1);
        QVERIFY(opened.import()->isEnabled());
        opened.box("importDelimiter")->setCurrentIndex(2); // tabs: no table is left
        QVERIFY(!opened.import()->isEnabled());
        opened.box("importDelimiter")->setCurrentIndex(1);
        QCOMPARE(opened.box("importForce")->currentText(), u"Kraft"_s);
        QVERIFY(opened.import()->isEnabled());
        auto* seconds = opened.dialog()->findChild<QDoubleSpinBox*>(u"importSampleTime"_s);
        QVERIFY(!seconds->isEnabled());
        opened.box("importTime")->setCurrentIndex(0); // no column
        QVERIFY(seconds->isEnabled());
        seconds->setValue(2);
        QVERIFY2(opened.words().contains(u"Sample time 2 ms"_s), qPrintable(opened.words()));
        QCOMPARE(opened.dialog()->options().sampleTime_s, std::optional(0.002));
    }
    void anErrorFarBelowNamesItsPlaceAndTheDialogStays()
    {
        Opened opened;
        const QByteArray text = germanSqueeze("9999,5;ERR;1,0\n");
        QVERIFY(text.size() > tableHeadBytes); // not in the preview
        opened.page.openRecordings({opened.file(text)});
        QVERIFY(opened.asked());
        QVERIFY(opened.import()->isEnabled());
        opened.import()->click();
        const QString place = u":%1:2"_s.arg(text.count('\n'));
        QVERIFY2(QTest::qWaitFor([&] { return opened.words().contains(place); }, test::longEnough_ms),
                 qPrintable(opened.words()));
        QVERIFY(opened.dialog() && opened.import()->isEnabled());
        QVERIFY(!opened.fixture.bench.navigator().fitSubject());
        QVERIFY(opened.fixture.bench.settings().importLayouts().isEmpty());
    }
    void aDamagedRecordingOfGripscopeIsReported()
    {
        Opened opened;
        opened.page.openRecordings(
            {opened.file("# gripscope-recording: 1\ntime_s,force,position\n0,1,2\n0.1,x,3\n0.2,1,3\n")});
        QTRY_COMPARE_WITH_TIMEOUT(opened.fixture.reports.size(), 1, test::longEnough_ms);
        QVERIFY(opened.fixture.reports.first().first().toString().contains(u":4:2"_s));
        QVERIFY(!opened.dialog());
    }
    void whatWasSaidReadsBack()
    {
        const ForeignTable table = tableOf("t;u;y\n0;1,5;2\n1;2;3\n");
        CsvReadOptions options = proposedReading(table);
        options.forceUnit = u"kN"_s;
        options.hold = ForceHold::First;
        options.timeUnit_s = 1e-3;
        QVERIFY(layoutIn(withLayout({}, table, options), table) == options);
        options.columns->time.reset();
        options.sampleTime_s = 0.25;
        const QByteArray kept = withLayout(withLayout({}, table, proposedReading(table)), table, options);
        QVERIFY(layoutIn(kept, table) == options);
        // A longer head in another file of the layout is not in the way.
        const ForeignTable later = tableOf("Versuch;2;x\nKommentar;;\nt;u;y\n0;1,5;2\n1;2;3\n2;2;3\n");
        const std::optional<CsvReadOptions> found = layoutIn(kept, later);
        QVERIFY(found && found->format == later.format);
    }
    void whatWasSaidIsThereAtTheNextStart()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(u"settings.ini"_s);
        const ForeignTable table = tableOf("t;u;y\n0;1,5;2\n1;2;3\n");
        {
            Settings settings(file);
            settings.setImportLayouts(withLayout({}, table, proposedReading(table)));
        }
        Settings settings(file);
        QVERIFY(layoutIn(settings.importLayouts(), table) == proposedReading(table));
        QVERIFY(settings.takeProblems().isEmpty());
    }
    void theOldestLayoutsAreForgotten()
    {
        QByteArray kept;
        for (int i = 0; i < 40; ++i) {
            const ForeignTable table = tableOf("t" + QByteArray::number(i) + ",u,y\n0,1,2\n1,2,3\n");
            kept = withLayout(kept, table, proposedReading(table));
        }
        QVERIFY(!layoutIn(kept, tableOf("t0,u,y\n0,1,2\n1,2,3\n")));
        QVERIFY(layoutIn(kept, tableOf("t39,u,y\n0,1,2\n1,2,3\n")));
        QVERIFY(kept.size() < 32 * 500);
    }
    void whatMakesNoSenseIsAsIfNothingHadBeenSaid_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("delimiter") << QByteArray(R"("delimiter":";")") << QByteArray(R"("delimiter":"x")");
        QTest::newRow("column") << QByteArray(R"("force":1)") << QByteArray(R"("force":-1)");
        QTest::newRow("unit of time") << QByteArray(R"("time_unit_s":1)") << QByteArray(R"("time_unit_s":0)");
        QTest::newRow("no document") << QByteArray("[") << QByteArray("{");
    }
    void whatMakesNoSenseIsAsIfNothingHadBeenSaid()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        const ForeignTable table = tableOf("t;u;y\n0;1,5;2\n1;2;3\n");
        QByteArray kept = withLayout({}, table, proposedReading(table));
        QVERIFY(layoutIn(kept, table) && kept.contains(from));
        QVERIFY(!layoutIn(kept.replace(from, to), table));
    }
};

GRIPSCOPE_TEST(ForeignTableDialogTest)
#include "foreign_table_dialog_test.moc"
