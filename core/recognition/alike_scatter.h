// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/scatter.h"

#include <optional>

namespace gripscope {

/// Scatter that is alike in log m, log b and log k and binds none to another, S = t I: one number to be known
/// instead of six, so that few squeezes already tell much of it. t is such that
///     tr((t I + C)^-1 (S + C)) = 3.
/// Nothing when the squeezes speak against it: when a scatter of another shape (an inverse Wishart
/// distribution about this one) is e^2 times as likely, which alike scatter passes one time in forty, or when
/// nothing is known of the scatter. Uses between, noise, total and degreesOfFreedom.
[[nodiscard]] std::optional<double> alikeVariance(const Scatter& scatter);

} // namespace gripscope
