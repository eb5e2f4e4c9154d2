// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/recipe_columns.h"

#include "core/base/csv.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Numbers in their shortest form that reads back to the same bits, a space between them.
QString textOf(const std::vector<double>& levels)
{
    QStringList numbers;
    for (const double level : levels)
        numbers << exactText(level);
    return numbers.join(u' ');
}

/// None where one of them is no number: such a recipe cannot be squeezed by, and says so.
std::vector<double> levelsFrom(const QString& text)
{
    std::vector<double> levels;
    for (const QString& field : text.split(u' ', Qt::SkipEmptyParts)) {
        const QByteArray utf8 = field.toUtf8();
        const std::optional<double> level = parseNumber({utf8.constData(), std::size_t(utf8.size())});
        if (!level || levels.size() >= mostLevels)
            return {};
        levels.push_back(*level);
    }
    return levels;
}

} // namespace

QString recipeColumns(const QString& table)
{
    QStringList columns{u"recipe_name"_s, u"peak_n"_s,       u"bias_n"_s,     u"bit_s"_s,       u"seconds"_s,
                        u"max_force_n"_s, u"max_travel_m"_s, u"force_kind"_s, u"force_levels"_s};
    for (QString& column : columns)
        column.prepend(table);
    return columns.join(u", "_s);
}

QString recipePlaces()
{
    return QStringList(recipeColumns().count(u',') + 1, u"?"_s).join(u", "_s);
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
    recipe.levels = levelsFrom(row.takeText());
    return recipe;
}

void bindRecipe(Statement& row, const Recipe& recipe)
{
    row.bind(recipe.name).bind(recipe.peak_N).bind(recipe.bias_N).bind(recipe.bit_s).bind(recipe.seconds);
    row.bind(recipe.maxForce_N)
        .bind(recipe.maxTravel_m)
        .bind(toString(recipe.kind))
        .bind(textOf(recipe.levels));
}

} // namespace gripscope
