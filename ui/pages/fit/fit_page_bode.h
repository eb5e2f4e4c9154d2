// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/bode_plots.h"

#include <optional>

namespace gripscope {

struct FitSubject;

/// What the Bode plot of a squeeze shows: `measured`, and the model that `estimator` found, with the band of
/// its own covariance. What both have in common (calibration, the empty gripper) is in neither interval.
[[nodiscard]] BodeContent bodeContent(const FitSubject& subject, Estimator estimator,
                                      const std::optional<EmpiricalResponse>& measured);

} // namespace gripscope
