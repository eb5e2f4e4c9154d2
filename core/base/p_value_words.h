// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

namespace gripscope {

/// "p = 0.023" with three digits, and "p < 0.001" below that: nothing is impossible by chance, and no test
/// is right to more digits than that.
[[nodiscard]] inline Finding pValueInWords(double p)
{
    constexpr double least = 0.001;
    return p < least ? Finding(u"p < ") + Finding::number(least, 'f', 3)
                     : Finding(u"p = ") + Finding::number(p, 'f', 3);
}

} // namespace gripscope
