// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of the other kinds from the button to the verdict and its papers, by click and key.
#include "tests/support/test_registry.h"
#include "tests/ui/studying.h"
#include "ui/charts/study_charts.h"
#include "ui/pages/quality/study_views.h"
#include "ui/reports/quality_reports.h"
#include "ui/widgets/quantity_box.h"

#include <QComboBox>
#include <QFile>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::studying;

namespace {

void typeInto(WindowFixture& f, const char* field, const QString& text)
{
    auto* line = f.find<QLineEdit>(field);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
}

void beginAsTyped(WindowFixture& f)
{
    auto* begin = f.find<QPushButton>("studyFormBegin");
    QTRY_VERIFY2(begin->isEnabled(), qPrintable(f.find<QLabel>("studyHint")->text()));
    f.click(begin);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
}

/// Squeezes parts of these stiffnesses as the plan asks for them, to its end.
void squeezeAll(WindowFixture& f, const QList<double>& stiffnesses)
{
    while (study(f).nextRow()) {
        const PlanRow row = study(f).study()->plan.rows[*study(f).nextRow()];
        const std::size_t before = study(f).progress().done;
        f.connectTo(u"virtual:?object=0.04,43,%1&seed=5&speed=0&part=%2&trial=%3&repeat-spread=0.002"_s
                        .arg(stiffnesses[row.part])
                        .arg(row.part + 1)
                        .arg(row.trial + 1));
        auto* arm = f.find<QPushButton>("studyArm");
        QTRY_VERIFY_WITH_TIMEOUT(arm->isVisible() && arm->isEnabled(), longEnough_ms);
        f.click(arm);
        pressSpaceOn(f, "studyAct");
        QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, before + 1, longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    }
    pressSpaceOn(f, "studyAct");
}

void judgeAll(WindowFixture& f)
{
    while (study(f).nextRow()) {
        const std::size_t before = study(f).progress().done;
        const int part = study(f).study()->plan.rows[*study(f).nextRow()].part;
        QTRY_VERIFY(f.window->findChild<QPushButton*>(u"rate-good"_s));
        f.clickWhenEnabled(f.find<QPushButton>(part % 2 == 0 ? "rate-good" : "rate-bad"));
        QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, before + 1, longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    }
    pressSpaceOn(f, "studyAct");
}

/// Writes both papers by what the buttons do, and gives the words of the report.
QString papersOf(WindowFixture& f)
{
    const QTemporaryDir folder;
    const QString csv = folder.filePath(u"study.csv"_s), pdf = folder.filePath(u"study.pdf"_s);
    auto* outcome = f.window->findChild<StudyOutcome*>();
    if (!f.find<QPushButton>("studyReport")->isVisible() || !f.find<QPushButton>("studyReport")->isEnabled())
        return u"there is no report"_s;
    outcome->writeCsv(csv);
    outcome->writeReport(pdf);
    const auto begins = [](const QString& name, const char* with) {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) && file.readAll().startsWith(with);
    };
    if (!QTest::qWaitFor([&] { return begins(csv, "part,") && begins(pdf, "%PDF"); }, longEnough_ms))
        return u"nothing was written"_s;
    StudyReport report;
    report.study = *study(f).study();
    report.result = **study(f).result();
    return studyReportHtml(report);
}

QString numbersText(WindowFixture& f)
{
    const auto* table = f.find<QTableWidget>("studyNumbers");
    QString text;
    for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column)
            text += table->item(row, column)->text() + u'|';
    return text;
}

} // namespace

class QualityKindsTest : public QObject {
    Q_OBJECT
private slots:
    void aTypeOneStudyIsLedToItsReport()
    {
        WindowFixture f(false, unhurriedA);
        f.window->showPage(u"quality"_s);
        f.clickWhenEnabled(f.find<QPushButton>("begin-type1"));
        QVERIFY(f.find<QLineEdit>("studyReferences")->placeholderText().contains(u"kN/m"_s));
        typeInto(f, "studyReferences", u"9,99"_s);
        f.find<QuantityBox>("toleranceK")->setSi(2000);
        f.find<QSpinBox>("studyTrials")->setValue(8);
        beginAsTyped(f);
        QCOMPARE(study(f).study()->plan.design.references, QStringList{u"9990"_s});
        QCOMPARE(study(f).study()->options.tolerances[2], std::optional(2000.0));
        squeezeAll(f, {9990});
        const QString verdict = shownVerdict(f);
        QVERIFY2(verdict.contains(u"Cgk"_s), qPrintable(verdict));
        QCOMPARE(f.find<CategoryPlot>("studyReadings")->chart().series[0].points.size(), std::size_t(8));
        QVERIFY(f.find<CategoryPlot>("studyReadings")->isVisible());
        QVERIFY(!f.find<CategoryPlot>("studyComponents")->isVisible());
        QVERIFY2(numbersText(f).contains(u"|9.990 kN/m|"_s) || numbersText(f).contains(u"9.99"_s),
                 qPrintable(numbersText(f)));
        const QString report = papersOf(f);
        QVERIFY2(report.contains(u"Type-1 study"_s) && report.contains(u"Cgk"_s), qPrintable(report));
    }
    void linearityIsLedToItsReport()
    {
        WindowFixture f(false, unhurriedA);
        f.window->showPage(u"quality"_s);
        f.clickWhenEnabled(f.find<QPushButton>("begin-linearity"));
        f.find<QSpinBox>("studyParts")->setValue(3);
        f.find<QSpinBox>("studyTrials")->setValue(3);
        QVERIFY(!f.find<QPushButton>("studyFormBegin")->isEnabled()); // what the parts are is not known
        typeInto(f, "studyReferences", u"5; 10; 15"_s);
        beginAsTyped(f);
        QCOMPARE(study(f).study()->plan.design.references, (QStringList{u"5000"_s, u"10000"_s, u"15000"_s}));
        squeezeAll(f, {5000, 10000, 15000});
        const QString verdict = shownVerdict(f);
        QVERIFY2(verdict.contains(u"inear"_s), qPrintable(verdict));
        QCOMPARE(f.find<CategoryPlot>("studyReadings")->chart().categories.size(), 3);
        QCOMPARE(f.find<QTableWidget>("studyNumbers")->rowCount(), 4); // three references, and all
        const QString report = papersOf(f);
        QVERIFY2(report.contains(u"Bias at each reference"_s), qPrintable(report));
    }
    void ratersAreLedToTheirReport_data()
    {
        QTest::addColumn<QString>("raters");
        QTest::newRow("two raters") << u"Anna, Ben"_s;
        QTest::newRow("whoever is there") << u""_s;
    }
    void ratersAreLedToTheirReport()
    {
        QFETCH(QString, raters);
        WindowFixture f(false, unhurriedA);
        f.window->showPage(u"quality"_s);
        f.clickWhenEnabled(f.find<QPushButton>("begin-attributes"));
        f.find<QSpinBox>("studyParts")->setValue(4);
        f.find<QSpinBox>("studyTrials")->setValue(2);
        typeInto(f, "studyOperators", raters);
        if (raters.isEmpty())
            f.find<QLineEdit>("studyOperators")->clear();
        typeInto(f, "studyReferences", u"good; bad; good; bad"_s);
        beginAsTyped(f);
        judgeAll(f);
        const QString verdict = shownVerdict(f);
        QVERIFY2(verdict.contains(u"agree well"_s), qPrintable(verdict));
        QVERIFY2(numbersText(f).startsWith(raters.isEmpty() ? u"Mai|"_s : u"Anna|"_s),
                 qPrintable(numbersText(f)));
        const QString report = papersOf(f);
        QVERIFY2(report.contains(u"Attribute agreement"_s) && report.contains(u"False alarms"_s),
                 qPrintable(report));
    }
};

GRIPSCOPE_TEST(QualityKindsTest)
#include "quality_kinds_test.moc"
