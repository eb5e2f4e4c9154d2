// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/recipe_columns.h"

namespace gripscope {

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
    return recipe;
}

void bindRecipe(Statement& row, const Recipe& recipe)
{
    row.bind(recipe.name).bind(recipe.peak_N).bind(recipe.bias_N).bind(recipe.bit_s).bind(recipe.seconds);
    row.bind(recipe.maxForce_N).bind(recipe.maxTravel_m);
}

} // namespace gripscope
