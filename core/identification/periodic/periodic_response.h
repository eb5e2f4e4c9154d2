// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/recording.h"

#include <Eigen/Core>

#include <complex>
#include <memory>

namespace gripscope {

/// The exact transfer function from the force's samples to the position's of M x'' + B x' + K x = F, for the
/// force as it is held between samples, and its derivatives by theta = (ln M, ln B, ln K). Time is in
/// samples; `rest`, 0 to 1, is how much later than the force the position is sampled. With
/// s[t+1] = phi s[t] + gamma0 F[t] + gamma1 F[t+1] and z = exp(j w),
///     G(z) = C (z I - phi)^-1 (gamma0 + z gamma1), C = (1, 0), rest = 0.
/// No approximation: what the sampling folds is folded in G too, so that output error and the periodic
/// estimate answer the same question. (A band-limited force that was sampled is not quite a straight line
/// between samples; declared first-order, its G is low by (w T)^2 / 12, as it is for output error.)
class PeriodicResponse {
public:
    PeriodicResponse(const Eigen::Vector3d& theta, ForceHold hold, double rest);
    ~PeriodicResponse();
    PeriodicResponse(const PeriodicResponse&) = delete;
    PeriodicResponse& operator=(const PeriodicResponse&) = delete;

    /// False when exp(theta) leaves the range of numbers; the rest means nothing then.
    [[nodiscard]] bool finite() const;

    using Complex = std::complex<double>;
    struct Value {
        Complex position;                      ///< X
        Eigen::Matrix<Complex, 3, 1> gradient; ///< d X / d theta
    };
    /// The position's transform X = G U for a force with the transform U at this frequency. `start` is what
    /// the state (x, x' over the natural frequency, where that is above one radian a sample) at the first
    /// sample has more than after the last one, over sqrt(samples); what it adds, C (z I - phi)^-1 z start,
    /// is the whole of the start's transient.
    [[nodiscard]] Value at(double radiansPerSample, Complex force,
                           const Eigen::Vector2d& start = Eigen::Vector2d::Zero()) const;
    /// d X / d start.
    [[nodiscard]] Eigen::Matrix<Complex, 2, 1> byStart(double radiansPerSample) const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
