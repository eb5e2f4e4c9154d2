// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

/// What a part is squeezed by.
class InspectRecipeTest : public QObject {
    Q_OBJECT
private slots:
    void whereNothingIsExpectedTheGentlestApprovedRecipeHolds()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("recipes.db"));
        const auto library = Library::open(file).value();
        const auto add = [&](const QString& name, double maxForce_N, double maxTravel_m, bool approve) {
            Recipe recipe;
            recipe.maxForce_N = maxForce_N;
            recipe.maxTravel_m = maxTravel_m;
            recipe.kind = ExcitationKind::FourLevel;
            const TypeRecord type =
                library->addType(name, recipe, QStringLiteral("N"), QStringLiteral("m")).value();
            if (approve)
                QVERIFY(library->approveType(type.id, {}));
        };
        add(QStringLiteral("firm"), 40, 0.005, true);
        add(QStringLiteral("soft"), 32, 0.02, true);
        add(QStringLiteral("softest, not approved"), 31, 0.001, false);
        InspectionRun run(file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        const Recipe next = run.inspection.nextRecipe();
        QCOMPARE(next.maxForce_N, 32.0);
        QCOMPARE(next.maxTravel_m, 0.005);
        QVERIFY(next.kind == ExcitationKind::FourLevel);
        run.inspection.setExpectedType(QStringLiteral("firm"));
        QCOMPARE(run.inspection.nextRecipe().maxForce_N, 40.0);
        run.inspection.setExpectedType({});
        Recipe asked;
        asked.maxForce_N = 35;
        run.inspection.setRecipe(asked);
        QCOMPARE(run.inspection.nextRecipe().maxForce_N, 35.0);
    }
};

GRIPSCOPE_TEST(InspectRecipeTest)
#include "inspect_recipe_test.moc"
