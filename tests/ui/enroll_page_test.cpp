// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/enroll_steps.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/type_map.h"
#include "ui/context/language.h"
#include "ui/pages/enroll/enroll_review_panel.h"
#include "ui/pages/enroll/enroll_squeeze_panel.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/widgets/progress.h"
#include "ui/windows/question.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollArea>
#include <QTableView>
#include <QTableWidget>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::pageAtSqueezes;
using gripscope::test::squeezeAndAccept;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;

namespace {

void theFactsAreWhole(WindowFixture& f)
{
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Review);
    const auto* facts = f.find<QScrollArea>("reviewFacts"); // cannot be scrolled to the side
    for (const QSize size : {QSize(1024, 640), QSize(1440, 900)}) {
        f.window->resize(size);
        QTRY_VERIFY(facts->widget()->minimumSizeHint().width() <= facts->viewport()->width());
    }
    f.window->resize(1024, 640);
}

} // namespace

/// The Enroll page by click and key, with the virtual gripper.
class EnrollPageTest : public QObject {
    Q_OBJECT
private slots:
    void enrollsATypeFromNameToApproval();
    void theFactsOfTheReviewAreWholeInGerman();
    void theTableOfSqueezesUsesTheWidth();
    void aSqueezeCanBeRejectedOrDroppedWithAReason();
    void spaceSqueezesAndAccepts();
    void aRecipeAboveItsLimitIsRefusedBeforeItIsSent();
    void aKnownNameKeepsItsRecipe();
    void oneMoreSqueezeTakesAnApprovedTypeOutOfForceAndTheReviewPutsItBack();
    void reviewFindsMeanSpreadAndTheNearestType();
    void anOutlierIsMarkedWithItsReasonAndOfferedToDrop();
    void theSqueezeStepSaysWhetherItIsEnoughAndKeepsTheParts();
    void theRingIsFullWhenMoreWouldGainLittle();
};

void EnrollPageTest::enrollsATypeFromNameToApproval()
{
    WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
    pageAtSqueezes(f, u"Cola 330 ml"_s);
    QVERIFY(!f.find<QPushButton>("enrollSqueezeButton")->isVisible());
    f.click(f.find<QPushButton>("enrollArmButton"));
    for (int i = 0; i < EnrollSession::leastSqueezes; ++i) {
        QVERIFY(!f.find<QPushButton>("reviewButton")->isEnabled());
        squeezeAndAccept(f);
    }
    QTRY_VERIFY(f.find<QPushButton>("reviewButton")->isEnabled());
    f.click(f.find<QPushButton>("reviewButton"));
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Review);
    theFactsAreWhole(f);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("distanceLabel")->text().contains(u" sd away"_s),
                             gripscope::test::longEnough_ms);
    // Four types of ten, one of three: each squeeze is judged by the others.
    auto* table = f.find<QTableWidget>("heldOutTable");
    QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 5, gripscope::test::longEnough_ms);
    QVERIFY(f.find<QLabel>("heldOutWords")->text().contains(u"wrong of 43"_s));
    f.click(f.find<QPushButton>("approveButton"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Approved,
                              gripscope::test::longEnough_ms);
    QTRY_VERIFY(f.find<QLabel>("doneLabel")->text().contains(u"Cola 330 ml"_s));
    // It is a type that inspections know from now on.
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().types().size(), std::size_t{5},
                              gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->inspection().models().find(u"Cola 330 ml"_s),
                             gripscope::test::longEnough_ms);
    const TypeModel* model = f.bench->inspection().models().find(u"Cola 330 ml"_s);
    QCOMPARE(model->squeezes, EnrollSession::leastSqueezes);
    // The virtual gripper scatters stiffness by about 5 % a squeeze; three squeezes' mean is within 15 %.
    QVERIFY(std::abs(std::exp(model->meanLog[2]) / 13500 - 1) < 0.15);
    f.click(f.find<QPushButton>("enrollAnother"));
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Name);
    QTRY_COMPARE(f.find<QLineEdit>("typeName")->text(), u"Type 1"_s);
}

void EnrollPageTest::theFactsOfTheReviewAreWholeInGerman()
{
    QVERIFY(applyLanguage(u"de"_s));
    const auto english = qScopeGuard([] { (void)applyLanguage(u"en"_s); });
    WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
    pageAtSqueezes(f, u"Cola 330 ml"_s);
    f.click(f.find<QPushButton>("enrollArmButton"));
    for (int i = 0; i < EnrollSession::leastSqueezes; ++i)
        squeezeAndAccept(f);
    auto* review = f.find<QPushButton>("reviewButton");
    QTRY_VERIFY(review->isEnabled());
    f.click(review);
    QTRY_VERIFY_WITH_TIMEOUT(!f.find<QLabel>("distanceLabel")->text().isEmpty(),
                             gripscope::test::longEnough_ms);
    theFactsAreWhole(f);
}

void EnrollPageTest::theTableOfSqueezesUsesTheWidth()
{
    WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
    pageAtSqueezes(f, u"Cola 330 ml"_s);
    f.click(f.find<QPushButton>("enrollArmButton"));
    squeezeAndAccept(f);
    const auto* table = f.find<QTableView>("squeezeTable");
    for (const QSize size : {QSize(2048, 1280), QSize(1440, 900)}) {
        f.window->resize(size);
        const auto used = [table] { return table->horizontalHeader()->length(); };
        QTRY_COMPARE(used(), table->viewport()->width());
        // Not by one column alone: the words at the end begin where two thirds are over.
        const int last = table->columnViewportPosition(int(EnrollSqueezeModel::Column::Verdict));
        QVERIFY2(last > 0.66 * table->viewport()->width(), qPrintable(QString::number(last)));
    }
    for (int column = 0; column < table->model()->columnCount(); ++column) // and none is cut
        QVERIFY(table->isColumnHidden(column) ||
                table->columnWidth(column) >=
                    static_cast<const QAbstractItemView*>(table)->sizeHintForColumn(column));
}

void EnrollPageTest::aSqueezeCanBeRejectedOrDroppedWithAReason()
{
    WindowFixture f(false, unhurriedA);
    pageAtSqueezes(f, u"Can"_s);
    auto* table = f.find<QTableView>("squeezeTable");
    const QAbstractItemModelTester tester(table->model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    f.click(f.find<QPushButton>("enrollArmButton"));
    squeezeAndAccept(f);
    f.click(f.find<QPushButton>("enrollSqueezeButton"));
    auto* reject = f.find<QPushButton>("rejectButton");
    QTRY_VERIFY_WITH_TIMEOUT(reject->isVisible(), gripscope::test::longEnough_ms);
    f.click(reject);
    QTRY_COMPARE(f.bench->enrollment().activity(), EnrollSession::Activity::Waiting);
    QCOMPARE(f.bench->enrollment().acceptedCount(), 1);
    QCOMPARE(table->model()->rowCount(), 2);

    auto* drop = f.find<QPushButton>("dropButton");
    table->selectRow(1);
    QVERIFY(!drop->isEnabled()); // a rejected one is not in the type
    table->selectRow(0);
    QTRY_VERIFY(drop->isEnabled());
    f.click(drop);
    QTRY_VERIFY(f.window->findChild<TextQuestion*>(u"dropDialog"_s));
    auto* dialog = f.window->findChild<TextQuestion*>(u"dropDialog"_s);
    dialog->field()->setText(u"slipped"_s);
    dialog->accept();
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 0, gripscope::test::longEnough_ms);
    const auto last = static_cast<int>(EnrollSqueezeModel::Column::Verdict);
    QTRY_COMPARE(table->model()->index(0, last).data().toString(), u"rejected: slipped"_s);
}

void EnrollPageTest::spaceSqueezesAndAccepts()
{
    WindowFixture f(false, unhurriedA);
    pageAtSqueezes(f, u"Can"_s);
    f.bench->arm();
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QPushButton>("enrollSqueezeButton")->isEnabled(),
                             gripscope::test::longEnough_ms);
    QTest::keyClick(f.page(u"enroll"_s), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().activity(), EnrollSession::Activity::Deciding,
                              gripscope::test::longEnough_ms);
    QTest::keyClick(f.page(u"enroll"_s), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);
}

void EnrollPageTest::aRecipeAboveItsLimitIsRefusedBeforeItIsSent()
{
    WindowFixture f(false);
    EnrollRecipeForm form(*f.bench, EnrollRecipeForm::Gripped::Part);
    Recipe recipe;
    form.setRecipe(recipe, false);
    QVERIFY(form.isValid());
    recipe.bias_N = 35; // 35 + 10 above the crush limit of 40
    form.setRecipe(recipe, false);
    QVERIFY(!form.isValid());
    recipe.bias_N = 5; // would have to pull
    form.setRecipe(recipe, false);
    QVERIFY(!form.isValid());
    recipe.bias_N = 900; // above what any gripper here allows
    recipe.maxForce_N = 1000;
    form.setRecipe(recipe, false);
    QVERIFY(!form.isValid());
    QVERIFY(form.findChild<QLabel*>(u"recipeSummary"_s)->text().contains(u"gripper"_s));
}

void EnrollPageTest::aKnownNameKeepsItsRecipe()
{
    WindowFixture f;
    f.window->showPage(u"enroll"_s);
    f.find<QLineEdit>("typeName")->selectAll(); // a name is proposed
    QTest::keyClicks(f.find<QLineEdit>("typeName"), u"B"_s);
    f.click(f.find<QPushButton>("nameNext"));
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Recipe);
    auto* form = f.page(u"enroll"_s)->findChild<EnrollRecipeForm*>(); // the Calibrate page has another
    for (QDoubleSpinBox* field : form->findChildren<QDoubleSpinBox*>())
        QTRY_VERIFY(!field->isEnabled());
    f.click(f.find<QPushButton>("recipeBack"));
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Name);
}

void EnrollPageTest::oneMoreSqueezeTakesAnApprovedTypeOutOfForceAndTheReviewPutsItBack()
{
    WindowFixture f(true, unhurriedA);
    const auto& inspection = f.bench->inspection();
    QVERIFY(inspection.models().find(u"A"_s));
    pageAtSqueezes(f, u"A"_s);
    QVERIFY(f.find<QLabel>("recipeHint")->text().contains(u"its approval is void"_s));
    f.click(f.find<QPushButton>("enrollArmButton"));
    QVERIFY(inspection.models().find(u"A"_s)); // nothing is added yet
    squeezeAndAccept(f);
    QTRY_VERIFY_WITH_TIMEOUT(inspection.approvedTypes().size() == 3 && !inspection.models().find(u"A"_s),
                             gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("reviewButton"));
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Review);
    const auto* map = f.page(u"enroll"_s)->findChild<TypeMap*>();
    const auto squeezesInMap = [map] {
        const PlotTable table = map->numbers();
        return std::count(table[0].texts->begin(), table[0].texts->end(), u"squeeze"_s);
    };
    QTRY_COMPARE_WITH_TIMEOUT(squeezesInMap(), 41, gripscope::test::longEnough_ms); // and the one just made
    f.click(f.find<QPushButton>("approveButton"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Approved,
                              gripscope::test::longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(inspection.models().find(u"A"_s), gripscope::test::longEnough_ms);
    QCOMPARE(inspection.models().find(u"A"_s)->squeezes, 11);
}

void EnrollPageTest::reviewFindsMeanSpreadAndTheNearestType()
{
    // Two types a factor 1.5 apart in stiffness, each with squeezes at -2, 0 and +2 % in all three
    // parameters.
    std::vector<TypeSqueeze> squeezes;
    for (const double step : {0.98, 1.0, 1.02}) {
        squeezes.push_back({u"one"_s, {0.04 * step, 43 / step, 10000 * step}});
        squeezes.push_back({u"two"_s, {0.04 / step, 43 * step, 15000 * step}});
        squeezes.push_back({u"far"_s, {0.04 * step, 43 * step, 90000 / step}});
    }
    const TypeReview review = reviewType(squeezes, ModelsBySpace(squeezes), u"one"_s, {});
    QCOMPARE(review.squeezes, 3);
    QVERIFY(std::abs(review.quantities[2].mean - 10000) < 1e-6);
    QVERIFY(std::abs(*review.quantities[2].deviation - 200) < 1e-6); // sd of -2, 0, +2 %
    QCOMPARE(review.nearest, u"two"_s);
    QVERIFY(review.gateSd && *review.nearestSd > *review.gateSd);
    QCOMPARE(review.squeezesOfAll.size(), std::size_t(9)); // for the map
    std::vector<TypeSqueeze> more = squeezes;
    more.push_back({u"in units that cannot be compared"_s, {1, 1, 1}});
    QCOMPARE(reviewType(more, ModelsBySpace(squeezes), u"one"_s, {}).squeezesOfAll.size(), std::size_t(9));
    QCOMPARE(reviewType(squeezes, ModelsBySpace(squeezes), u"nobody"_s, {}).squeezes, 0);
    VerdictOptions loose;
    loose.falseReject = 0.05;
    const TypeReview looser = reviewType(squeezes, ModelsBySpace(squeezes), u"one"_s, loose);
    QVERIFY(*looser.gateSd < *review.gateSd);
    QCOMPARE(looser.falseReject, 0.05);
}

void EnrollPageTest::anOutlierIsMarkedWithItsReasonAndOfferedToDrop()
{
    EnrollSqueezeModel model;
    EnrollSqueeze squeeze;
    squeeze.decision = EnrollSqueeze::Decision::Accepted;
    squeeze.part = u"7"_s;
    model.refresh({squeeze, squeeze}, {{1, u"Stiffness is 8 % above the others."_s}});
    const auto last = static_cast<int>(EnrollSqueezeModel::Column::Verdict);
    QVERIFY(!model.index(0, last).data().toString().contains(u"outlier"_s));
    QCOMPARE(model.index(1, last).data().toString(), u"outlier: Stiffness is 8 % above the others."_s);
    QVERIFY(model.index(1, 0).data(Qt::ForegroundRole) != model.index(0, 0).data(Qt::ForegroundRole));
    QVERIFY(model.hasParts());
    const auto part = static_cast<int>(EnrollSqueezeModel::Column::Part);
    QCOMPARE(model.index(0, part).data().toString(), u"7"_s);
}

void EnrollPageTest::theSqueezeStepSaysWhetherItIsEnoughAndKeepsTheParts()
{
    WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
    pageAtSqueezes(f, u"Cola"_s);
    f.click(f.find<QPushButton>("enrollArmButton"));
    QTest::keyClicks(f.find<QLineEdit>("partField"), u"12"_s);
    squeezeAndAccept(f);
    QCOMPARE(f.bench->enrollment().squeezes().back().part, u"12"_s);
    QTRY_VERIFY_WITH_TIMEOUT(
        f.find<QLabel>("adviceLabel")->text().contains(u"One squeeze tells the stiffness"_s),
        gripscope::test::longEnough_ms);
    squeezeAndAccept(f);
    QTRY_VERIFY_WITH_TIMEOUT(!f.find<QLabel>("adviceLabel")->text().contains(u"One squeeze"_s),
                             gripscope::test::longEnough_ms);
    QVERIFY(f.find<QLabel>("adviceLabel")->text().contains(u"is called unknown"_s));
}

void EnrollPageTest::theRingIsFullWhenMoreWouldGainLittle()
{
    // Beside four types of ten the scatter is known well: fewer than ten are enough.
    WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
    pageAtSqueezes(f, u"Cola"_s);
    f.click(f.find<QPushButton>("enrollArmButton"));
    const auto* ring = f.find<ProgressRing>("ring");
    const auto* advice = f.find<QLabel>("adviceLabel");
    const auto enough = [&] { return advice->text().contains(u"more squeezes would gain little"_s); };
    const auto ringIsFull = [&] {
        const int accepted = f.bench->enrollment().acceptedCount();
        return ring->accessibleName() == u"%1 of %1 squeezes"_s.arg(accepted);
    };
    const auto turns = [&] {
        const QList<QLabel*> labels = f.page(u"enroll"_s)->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains(u"Turn or change the part"_s);
        });
    };
    while (!enough() && f.bench->enrollment().acceptedCount() < EnrollSession::suggestedSqueezes) {
        squeezeAndAccept(f);
        QTRY_COMPARE_WITH_TIMEOUT(ringIsFull(), enough(), gripscope::test::longEnough_ms);
        QTRY_COMPARE(turns(), !enough());
    }
    QVERIFY(enough());
    QVERIFY(f.bench->enrollment().acceptedCount() < EnrollSession::suggestedSqueezes);
}

GRIPSCOPE_TEST(EnrollPageTest)
#include "enroll_page_test.moc"
