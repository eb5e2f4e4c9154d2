// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/migrations/migration.h"

namespace gripscope::test {

/// What an earlier version of the program knew.
inline std::vector<Migration> migrationsUpTo(int version)
{
    std::vector<Migration> steps = migrations();
    std::erase_if(steps, [version](const Migration& step) { return step.version > version; });
    return steps;
}

} // namespace gripscope::test
