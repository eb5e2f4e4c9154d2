// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/recipe_design.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using P = MotionParameter;

namespace {

GripperIdentity sampling(double sampleTime_s)
{
    GripperIdentity identity;
    identity.sampleTime_s = sampleTime_s;
    return identity;
}

std::vector<ModelExpectation> expected(ExcitationKind kind, double seconds = 1)
{
    Recipe recipe;
    recipe.kind = kind;
    recipe.seconds = seconds;
    return expectationOf(recipe, sampling(5e-4));
}

} // namespace

class RecipeExpectationTest : public QObject {
    Q_OBJECT
private slots:
    void everyModelHasItsParameters()
    {
        const std::vector<ModelExpectation> models = expected(ExcitationKind::FourLevel);
        QCOMPARE(models.size(), std::size_t(3));
        for (const ModelExpectation& model : models) {
            QCOMPARE(model.relative.size(), model.terms.parameters().size());
            for (const double half : model.relative)
                QVERIFY(half > 0 && half < 1);
        }
        QVERIFY(!models[0].of(P::Friction) && models[1].of(P::Friction) && models[2].of(P::Relaxing));
    }
    void whatHidesSaysSo()
    {
        // Two levels hide friction in k, four and a slow sine do not; a further term never makes k surer.
        const auto two = expected(ExcitationKind::Prbs);
        const auto four = expected(ExcitationKind::FourLevel);
        const auto sine = expected(ExcitationKind::PrbsSine);
        QVERIFY(*two[1].of(P::Stiffness) > 5 * *four[1].of(P::Stiffness));
        QVERIFY(*sine[1].of(P::Friction) < *four[1].of(P::Friction));
        for (const auto& models : {two, four, sine})
            for (std::size_t i = 1; i < models.size(); ++i)
                QVERIFY(*models[i].of(P::Stiffness) >= *models[0].of(P::Stiffness));
    }
    void aLongerSqueezeTellsMore()
    {
        // Four times the samples: half the error, but for the sequence drawn.
        const double ratio = *expected(ExcitationKind::FourLevel, 4)[0].of(P::Mass) /
                             *expected(ExcitationKind::FourLevel, 1)[0].of(P::Mass);
        QVERIFY2(ratio > 0.4 && ratio < 0.6, qPrintable(QString::number(ratio)));
    }
    void whatCannotBeSqueezedHasNone()
    {
        QVERIFY(expected(ExcitationKind::InverseRepeat, 0.1).empty()); // eight periods do not fit
        QVERIFY(expected(ExcitationKind::Prbs, 51).empty());           // 102,000 samples
        Recipe recipe;
        QVERIFY(expectationOf(recipe, sampling(0)).empty());
    }
    void aSlowGripperTellsNoMass()
    {
        // The can swings 80 times a second: sampled 20 times a second a squeeze does not hold its mass.
        Recipe recipe;
        recipe.bit_s = 0.1;
        recipe.seconds = 10;
        const auto models = expectationOf(recipe, sampling(0.05));
        QVERIFY(models.empty() || models[0].relative.empty() || *models[0].of(P::Mass) > 0.5);
    }
};

GRIPSCOPE_TEST(RecipeExpectationTest)
#include "recipe_expectation_test.moc"
