// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"

#include <QCoreApplication>

#include <vector>

namespace gripscope {

/// How the force of a recipe goes, in words.
struct RecipeWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::RecipeWords)
public:
    /// Those that a recipe can have, the one that is best for a new type first.
    [[nodiscard]] static const std::vector<ExcitationKind>& kinds();
    [[nodiscard]] static QString name(ExcitationKind kind);
    /// What it can tell, and what it costs.
    [[nodiscard]] static QString tells(ExcitationKind kind);
};

} // namespace gripscope
