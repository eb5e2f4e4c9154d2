// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/studying.h"
#include "ui/charts/study_charts.h"
#include "ui/pages/quality/study_views.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::studying;

namespace {

void typeLabel(WindowFixture& f, const QString& label)
{
    auto* field = f.find<QLineEdit>("studyLabel");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, label);
    QTest::keyClick(field, Qt::Key_Return);
}

QByteArray contentOf(const QString& name)
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writesReportAndTable(WindowFixture& f)
{
    QTemporaryDir folder;
    const QString csv = folder.filePath(u"study.csv"_s), pdf = folder.filePath(u"study.pdf"_s);
    auto* outcome = f.window->findChild<StudyOutcome*>();
    outcome->writeCsv(csv);
    outcome->writeReport(pdf);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(csv) && QFile::exists(pdf), longEnough_ms);
    QCOMPARE(contentOf(csv).trimmed().count('\n'), 12); // a header and 12 measurements
    QVERIFY(contentOf(csv).startsWith("part,operator,"));
    QVERIFY(contentOf(pdf).startsWith("%PDF"));
}

} // namespace

/// Studies from the button to the verdict, by click and key.
class QualityPageTest : public QObject {
    Q_OBJECT
private slots:
    void withoutStudiesItSaysWhatToDoFirst();
    void aStudyIsLedToItsVerdictThroughTheEndOfTheProgram();
    void aWrongPartIsRefused();
    void theLastSqueezeIsTakenBack();
    void stopEndsTheSqueezeAndNothingIsStored();
    void aTypeOneStudyAndRatersAreLedToo();
};

void QualityPageTest::withoutStudiesItSaysWhatToDoFirst()
{
    WindowFixture f(false, unhurriedA);
    f.window->showPage(u"quality"_s);
    auto* advice = f.find<QLabel>("studyAdvice");
    QVERIFY(advice->isVisible() && advice->text().contains(u"Begin with"_s));
    QVERIFY(!f.find<QWidget>("openStudies")->isVisible());
    QVERIFY(!f.find<QWidget>("pastStudies")->isVisible());
    for (const char* kind : {"begin-type1", "begin-gauge", "begin-linearity", "begin-attributes"})
        QVERIFY(f.find<QPushButton>(kind)->isVisible());
    f.click(f.find<QPushButton>("begin-gauge"));
    QTRY_VERIFY(f.find<QPushButton>("studyFormBegin")->isEnabled());
    QVERIFY(f.find<QLabel>("studyHint")->text().contains(u"90 squeezes"_s)); // 10 x 3 x 3
    f.find<QLineEdit>("studyNameField")->clear();
    QVERIFY(!f.find<QPushButton>("studyFormBegin")->isEnabled());
    f.click(f.find<QPushButton>("studyFormBack"));
    QTRY_VERIFY(f.find<QPushButton>("begin-gauge")->isVisible());
}

void QualityPageTest::aStudyIsLedToItsVerdictThroughTheEndOfTheProgram()
{
    WindowFixture f(false, unhurriedA);
    beginSmallStudy(f);
    QVERIFY(f.find<QLabel>("studyWho")->text().contains(study(f).study()->plan.operatorName(0)));
    QVERIFY(f.find<QLabel>("studyPart")->text().contains(nextPart(f)));
    for (int i = 0; i < 5; ++i)
        squeezeNext(f);
    QVERIFY(f.find<QLabel>("studyProgress")->text().contains(u"6 of 12"_s));
    const QString name = study(f).study()->record.study.name;
    putIn(f, study(f).study()->plan.rows[5]);
    pressSpaceOn(f, "studyAct"); // under way when the program ends
    startAgain(f);
    f.window->showPage(u"quality"_s);
    QPushButton* goOn = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((goOn = f.window->findChild<QPushButton*>(u"goOnWithStudy"_s)) != nullptr,
                             longEnough_ms);
    QVERIFY(goOn->accessibleName().contains(name));
    f.clickWhenEnabled(goOn);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    QVERIFY(study(f).progress().done >= 5);
    while (study(f).nextRow())
        squeezeNext(f);
    QVERIFY(!f.find<QLabel>("studyVerdict")->isVisible()); // blind to the end
    pressSpaceOn(f, "studyAct");
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("studyVerdict")->text().contains(u"kinds of"_s), longEnough_ms);
    QVERIFY(f.find<QLabel>("studyVerdict")->isVisible());
    QVERIFY(f.find<QLabel>("studyCategories")->text().contains(u"k: "_s));
    QCOMPARE(f.find<QTabBar>("studyQuantityTabs")->count(), 3);
    const CategoryChart& bars = f.find<CategoryPlot>("studyComponents")->chart();
    QCOMPARE(bars.series.size(), std::size_t(2));
    QVERIFY(bars.categories.size() >= 3);
    QCOMPARE(f.find<CategoryPlot>("studyByPart")->chart().categories.size(), 3);
    QVERIFY(f.find<QTableWidget>("studyNumbers")->rowCount() >= 4);
    writesReportAndTable(f);
    f.click(f.find<QPushButton>("studyOutcomeBack"));
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QPushButton*>(u"openStudy"_s), longEnough_ms);
    QVERIFY(!f.find<QWidget>("openStudies")->isVisible());
}

void QualityPageTest::aWrongPartIsRefused()
{
    WindowFixture f(false, unhurriedA);
    beginSmallStudy(f);
    putIn(f, study(f).study()->plan.rows[0]);
    auto* act = f.find<QPushButton>("studyAct");
    QTRY_VERIFY_WITH_TIMEOUT(act->isEnabled(), longEnough_ms);
    const QString right = nextPart(f);
    const QString wrong = right == u"1"_s ? u"2"_s : u"1"_s;
    typeLabel(f, wrong);
    auto* words = f.find<QLabel>("wrongPart");
    QTRY_VERIFY(words->isVisible());
    QVERIFY2(words->text().contains(wrong) && words->text().contains(right), qPrintable(words->text()));
    QVERIFY(!act->isEnabled());
    QTest::keyClick(f.window->focusWidget(), Qt::Key_Space);
    QVERIFY(study(f).state() == State::Waiting);
    typeLabel(f, right); // a scanner's Enter squeezes nothing
    QTRY_VERIFY(!words->isVisible() && act->isEnabled());
    QVERIFY(study(f).state() == State::Waiting);
    pressSpaceOn(f, "studyAct");
    QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, std::size_t(1), longEnough_ms);
}

void QualityPageTest::theLastSqueezeIsTakenBack()
{
    WindowFixture f(false, unhurriedA);
    beginSmallStudy(f);
    const QString first = nextPart(f);
    auto* undo = f.find<QPushButton>("studyUndo");
    QVERIFY(!undo->isEnabled());
    squeezeNext(f);
    QVERIFY(*study(f).nextRow() == 1);
    f.clickWhenEnabled(undo);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).nextRow() == std::optional<std::size_t>(0), longEnough_ms);
    QTRY_VERIFY(f.find<QLabel>("studyPart")->text().contains(first));
    QVERIFY(f.find<QLabel>("studyLast")->text().contains(u"taken back"_s));
    squeezeNext(f);
    QCOMPARE(study(f).progress().done, std::size_t(1));
}

void QualityPageTest::stopEndsTheSqueezeAndNothingIsStored()
{
    WindowFixture f(false, u"virtual:?object=A&seed=5"_s); // in real time, so that there is time to stop
    beginSmallStudy(f);
    auto* arm = f.find<QPushButton>("studyArm");
    f.clickWhenEnabled(arm);
    pressSpaceOn(f, "studyAct");
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Squeezing, longEnough_ms);
    f.bench->stop();
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    QVERIFY(study(f).study()->measurements.empty());
    QVERIFY(!f.bench->connection().armed());
    QTRY_VERIFY(arm->isVisible());
}

void QualityPageTest::aTypeOneStudyAndRatersAreLedToo()
{
    WindowFixture f(false, unhurriedA);
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>("begin-attributes"));
    f.find<QSpinBox>("studyParts")->setValue(2);
    auto* raters = f.find<QLineEdit>("studyOperators");
    raters->selectAll();
    QTest::keyClicks(raters, u"Anna, Ben"_s);
    QTest::keyClick(raters, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    QTRY_VERIFY(f.window->findChild<QPushButton*>(u"rate-good"_s));
    f.clickWhenEnabled(f.find<QPushButton>("rate-good"));
    QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, std::size_t(1), longEnough_ms);
    QCOMPARE(study(f).study()->measurements[0].measured.rating, u"good"_s);
    while (study(f).nextRow()) {
        const std::size_t before = study(f).progress().done;
        f.clickWhenEnabled(f.find<QPushButton>(nextPart(f) == u"1"_s ? "rate-good" : "rate-bad"));
        QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, before + 1, longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    }
    pressSpaceOn(f, "studyAct");
    auto* verdict = f.find<QLabel>("studyVerdict");
    QTRY_VERIFY_WITH_TIMEOUT(verdict->isVisible() && !verdict->text().isEmpty() &&
                                 !verdict->text().contains(u"worked out"_s),
                             longEnough_ms);
    QVERIFY2(verdict->text().contains(u"agree"_s), qPrintable(verdict->text()));
    f.clickWhenEnabled(f.find<QPushButton>("studyOutcomeBack"));
    f.clickWhenEnabled(f.find<QPushButton>("begin-type1"));
    auto* begin = f.find<QPushButton>("studyFormBegin");
    QVERIFY(!begin->isEnabled());                                      // no reference, no tolerance
    QTest::keyClicks(f.find<QLineEdit>("studyReferences"), u"9.99"_s); // kN/m
    QVERIFY(!begin->isEnabled());
    auto* tolerance = f.find<QDoubleSpinBox>("toleranceK");
    tolerance->setValue(1);
    QTRY_VERIFY(begin->isEnabled());
    f.click(begin);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    QVERIFY(study(f).study()->plan.design.kind == StudyKind::TypeOne);
    QCOMPARE(study(f).study()->plan.design.references, QStringList{u"9990"_s});
    f.clickWhenEnabled(f.find<QPushButton>("studyPause"));
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QPushButton*>(u"goOnWithStudy"_s), longEnough_ms);
}

GRIPSCOPE_TEST(QualityPageTest)
#include "quality_page_test.moc"
