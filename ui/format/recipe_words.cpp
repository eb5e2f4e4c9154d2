// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/recipe_words.h"

namespace gripscope {

const std::vector<ExcitationKind>& RecipeWords::kinds()
{
    static const std::vector<ExcitationKind> all{ExcitationKind::FourLevel, ExcitationKind::Prbs,
                                                 ExcitationKind::InverseRepeat, ExcitationKind::Multisine};
    return all;
}

QString RecipeWords::name(ExcitationKind kind)
{
    switch (kind) {
    case ExcitationKind::FourLevel:
        return tr("Four levels");
    case ExcitationKind::Prbs:
        return tr("Two levels");
    case ExcitationKind::InverseRepeat:
        return tr("Repeating");
    case ExcitationKind::Multisine:
        return tr("Sum of sines");
    case ExcitationKind::Step:
    case ExcitationKind::Chirp:
        break; // no recipe has them: one squeeze by them tells little of m, b and k
    }
    return {};
}

QString RecipeWords::tells(ExcitationKind kind)
{
    switch (kind) {
    case ExcitationKind::FourLevel:
        return tr("Tells friction from stiffness; m is less certain.");
    case ExcitationKind::Prbs:
        return tr("Most certain where there is no friction, which hides in k.");
    case ExcitationKind::InverseRepeat:
        return tr("Sets noise apart; friction hides in k.");
    case ExcitationKind::Multisine:
        return tr("Sees friction too, with less force on average.");
    case ExcitationKind::Step:
    case ExcitationKind::Chirp:
        break;
    }
    return {};
}

} // namespace gripscope
