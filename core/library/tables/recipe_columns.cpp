// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/recipe_columns.h"

#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

QString recipeColumns(const QString& table)
{
    QStringList columns{u"recipe_name"_s, u"peak_n"_s,      u"bias_n"_s,       u"bit_s"_s,
                        u"seconds"_s,     u"max_force_n"_s, u"max_travel_m"_s, u"force_kind"_s};
    for (QString& column : columns)
        column.prepend(table);
    return columns.join(u", "_s);
}

Recipe takeRecipe(Statement& row)
{
    Recipe recipe;
    recipe.name = row.takeText();
    recipe.peak_N = row.takeReal();
    recipe.bias_N = row.takeReal();
    recipe.bit_s = row.takeReal();
    recipe.seconds = row.takeReal();
    recipe.maxForce_N = row.takeReal();
    recipe.maxTravel_m = row.takeReal();
    // One of a later program squeezes as the first ones did here; what it wrote stays.
    recipe.kind = excitationKindFromString(row.takeText()).value_or(ExcitationKind::Prbs);
    return recipe;
}

void bindRecipe(Statement& row, const Recipe& recipe)
{
    row.bind(recipe.name).bind(recipe.peak_N).bind(recipe.bias_N).bind(recipe.bit_s).bind(recipe.seconds);
    row.bind(recipe.maxForce_N).bind(recipe.maxTravel_m).bind(toString(recipe.kind));
}

} // namespace gripscope
