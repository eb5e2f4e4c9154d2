// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"
#include "core/recognition/types/type_shift.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace gripscope {

/// Since when squeezes lie elsewhere: behind the first `before` of those that were looked at.
struct ChangePoint {
    int before = 0;               ///< the most probable
    int earliest = 0, latest = 0; ///< the fewest and the most of the smallest set that has it with 95 %
    double probability = 0;       ///< of `before` itself
    LogVector shift = Eigen::Vector3d::Zero(); ///< behind it: s, of logarithms
    LogMatrix covariance = Eigen::Matrix3d::Zero();
    std::vector<double> posterior = {}; ///< of each place 0, 1, ... squeezes - 1
};

/// When `types` (all of the models where empty) moved together. Model, for squeeze t of type i,
///     log x_t = mu_i + o_i + [t > tau] H_i s + e_t,   e_t ~ N(0, S_t),
/// with o_i ~ N(0, C_i) what is not known of the enrolled mean mu_i, H_i as in commonShift(), s without
/// knowledge beforehand and tau alike likely at any squeeze. o and s are integrated out exactly,
///     ln p(tau) = b' A^-1 b / 2 - ln|A| / 2 + constant,
/// A the precision of (o, s) given tau and b the weighted residuals (Bayesian linear model; Smith, A Bayesian
/// approach to inference about a change-point in a sequence of random variables, Biometrika 1975). S_t is
/// taken for known.
///
/// tau = 0: moved since before the first of these. A change that creeps is dated to about its middle.
/// `squeezes`: oldest first; those of other types, or that do not determine models.space, are passed over but
/// counted in `before`. Nothing for fewer than five that count, or without a scatter.
[[nodiscard]] std::optional<ChangePoint> findChange(const TypeModels& models,
                                                    const std::vector<TypeSqueeze>& squeezes, ShiftKind kind,
                                                    const QStringList& types = {});

} // namespace gripscope
