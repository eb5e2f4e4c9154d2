// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/recipe_words.h"

#include <algorithm>
#include <array>

namespace gripscope {

namespace {

struct KindWords {
    ExcitationKind kind;
    const char* name;
    const char* tells;
};

/// Steps and chirps are missing: one squeeze by them tells little of m, b and k.
constexpr std::array<KindWords, 7> kindWords{
    {{ExcitationKind::FourLevel, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Four levels"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Tells friction from stiffness; m is less certain.")},
     {ExcitationKind::PrbsSine, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Two levels, slow sine"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Tells friction best, and stiffness over all of its way.")},
     {ExcitationKind::PrbsHold, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Two levels, ramp and hold"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Shows how far and how fast a part goes on yielding.")},
     {ExcitationKind::Prbs, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Two levels"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords",
                        "Most certain where there is no friction, which hides in k.")},
     {ExcitationKind::InverseRepeat, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Repeating"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Sets noise apart; friction hides in k.")},
     {ExcitationKind::Multisine, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Sum of sines"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Sees friction too, with less force on average.")},
     {ExcitationKind::Levels, QT_TRANSLATE_NOOP("gripscope::RecipeWords", "Levels of your own"),
      QT_TRANSLATE_NOOP("gripscope::RecipeWords", "As a file has them, or the designer.")}}};

const KindWords* wordsFor(ExcitationKind kind)
{
    const auto found = std::ranges::find(kindWords, kind, &KindWords::kind);
    return found != kindWords.end() ? &*found : nullptr;
}

} // namespace

const std::vector<ExcitationKind>& RecipeWords::kinds()
{
    static const std::vector<ExcitationKind> all = [] {
        std::vector<ExcitationKind> kinds;
        for (const KindWords& one : kindWords)
            kinds.push_back(one.kind);
        return kinds;
    }();
    return all;
}

QString RecipeWords::name(ExcitationKind kind)
{
    const KindWords* const found = wordsFor(kind);
    return found != nullptr ? tr(found->name) : QString();
}

QString RecipeWords::tells(ExcitationKind kind)
{
    const KindWords* const found = wordsFor(kind);
    return found != nullptr ? tr(found->tells) : QString();
}

} // namespace gripscope
