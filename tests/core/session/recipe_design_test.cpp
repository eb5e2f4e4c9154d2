// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"
#include "core/session/squeeze/recipe_design.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

GripperIdentity usual()
{
    GripperIdentity identity;
    identity.sampleTime_s = 5e-4;
    return identity;
}

Recipe designed(const Recipe& recipe, const TypeModels& types = {})
{
    Recipe result = recipe;
    const auto force = designedForce(recipe, usual(), types);
    if (!force)
        qFatal("%s", qPrintable(force.error().describe()));
    result.kind = ExcitationKind::Levels;
    result.levels = force->levels;
    result.bit_s = force->bit_s;
    return result;
}

double halfWidthOf(const Recipe& recipe, MotionParameter parameter)
{
    return expectationOf(recipe, usual()).front().of(parameter).value_or(1e9);
}

} // namespace

class RecipeDesignTest : public QObject {
    Q_OBJECT
private slots:
    void itKeepsToTheRecipe()
    {
        Recipe recipe;
        const auto force = designedForce(recipe, usual(), {});
        QVERIFY(force);
        QCOMPARE(force->bias, recipe.bias_N);
        QCOMPARE(force->peak, recipe.peak_N);
        QVERIFY(force->bit_s >= recipe.bit_s);
        QVERIFY(std::abs(force->seconds() - recipe.seconds) < force->bit_s);
        QVERIFY(std::ranges::all_of(force->levels, [](double level) { return std::abs(level) == 1; }));
        recipe.maxForce_N = 26; // leaves 6 N above the preload
        const auto less = designedForce(recipe, usual(), {});
        QVERIFY(less);
        QCOMPARE(less->peak, 6.0);
    }
    /// D-optimal: the product of the errors of m, b and k is below that of any sequence of two levels.
    void itTellsMoreThanTwoLevelsByChance()
    {
        using P = MotionParameter;
        const auto volume = [](const Recipe& recipe) {
            return halfWidthOf(recipe, P::Mass) * halfWidthOf(recipe, P::Damping) *
                   halfWidthOf(recipe, P::Stiffness);
        };
        const Recipe recipe; // PRBS
        QVERIFY(volume(designed(recipe)) < volume(recipe));
    }
    void itIsForTheTypesThatAreEnrolled()
    {
        const TypeModels cans = fitTypeModels(paperSqueezesInSi());
        QVERIFY(designed({}, cans).levels != designed({}).levels);
        // Parts of a tenth of the frequency take longer pushes.
        std::vector<TypeSqueeze> slow = paperSqueezesInSi();
        for (TypeSqueeze& squeeze : slow)
            squeeze.parameters = {100 * squeeze.parameters.m, 10 * squeeze.parameters.b,
                                  squeeze.parameters.k};
        Recipe recipe;
        recipe.seconds = 4;
        const auto turns = [](const Recipe& made) {
            int count = 0;
            for (std::size_t i = 1; i < made.levels.size(); ++i)
                count += made.levels[i] != made.levels[i - 1];
            return count * made.bit_s / made.seconds;
        };
        QVERIFY(turns(designed(recipe, fitTypeModels(slow))) < turns(designed(recipe, cans)));
    }
    void ofManyTypesItTakesThoseHardestToTell()
    {
        std::vector<TypeSqueeze> squeezes;
        for (int type = 0; type < 40; ++type)
            for (int i = 0; i < 3; ++i) {
                const double away = std::exp(0.1 * type + 0.002 * i);
                squeezes.push_back({QString::number(type), {0.04 * away, 43 * away, 1e4 * away}});
            }
        QVERIFY(designedForce({}, usual(), fitTypeModels(squeezes)));
    }
    void whatCannotBeDesignedSaysWhy()
    {
        Recipe recipe;
        recipe.maxForce_N = recipe.bias_N; // no room above the preload
        const auto force = designedForce(recipe, usual(), {});
        QVERIFY(!force);
        QVERIFY2(force.error().describe().contains(u"limit"_s), qPrintable(force.error().describe()));
    }
};

GRIPSCOPE_TEST(RecipeDesignTest)
#include "recipe_design_test.moc"
