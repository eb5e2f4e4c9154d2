// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <optional>

namespace gripscope {

/// What a part is allowed to be; either side may be open.
struct ToleranceLimits {
    std::optional<double> lower, upper;
    /// Usage: no side, a side that is no finite number, or lower not below upper.
    [[nodiscard]] std::optional<Error> validate() const;
    friend bool operator==(const ToleranceLimits&, const ToleranceLimits&) = default;
};

} // namespace gripscope
