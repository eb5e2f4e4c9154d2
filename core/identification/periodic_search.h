// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic_spectrum.h"
#include "core/signal/recording.h"

#include <Eigen/Core>

#include <optional>

namespace gripscope {

/// The estimate from a periodic spectrum, time in samples; theta = (ln M, ln B, ln K).
struct PeriodicProblem {
    PeriodicSpectrum spectrum;
    std::vector<LocalFit> lines; ///< the harmonics that count
    ForceHold hold = ForceHold::First;
    double rest = 0;                   ///< of the lag, in samples, 0 to 1
    std::vector<std::size_t> usedBins; ///< harmonics of `lines` and the bins beside them, ascending
    double noiseFloor =
        0; ///< smallest variance of a bin: rounding, which a record without noise is left with
    double startScale = 0; ///< a priori deviation of the start's transient: the range of the position

    PeriodicProblem(PeriodicSpectrum spectrum, ForceHold hold, double rest, double positionRange);
};

/// The cost of sample maximum likelihood (Schoukens, Pintelon, Vandersteen, Guillaume 1997; Pintelon and
/// Schoukens, System Identification: A Frequency Domain Approach, 2nd ed., ch. 9 and 12),
///     V(theta) = sum over lines of (v - 1)/v |e|^2 / s^2,   e = Y - G(theta) U,
/// e corrected for leakage by the line's local fit and s^2 its variance, measured from the same e on the
/// bins beside with v complex degrees of freedom. s^2 is sigY^2 + |G|^2 sigU^2 - 2 Re(conj(G) sigYU) with the
/// sample covariances of both noises, but with G at each bin's own frequency; its dependence on theta is part
/// of the derivatives, without which force noise would bias the estimate. (v - 1)/v makes the weights
/// unbiased: at the truth V is the number of lines, and at the minimum 3/2 less.
struct PeriodicCost {
    bool finite = false;
    double value = 0;
    Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero(); ///< sum of w Re(conj(d r) d r'), r = e / s
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< sum of w Re(conj(d r) r)
    /// The information at known s, and its middle factor when s was measured: each line by (v - 1)/(v - 2).
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero(), scatter = Eigen::Matrix3d::Zero();
    std::vector<double> variances; ///< s^2 a line
};
/// With `variances` these stand for s^2, as constants. That keeps a search that is far away from buying a
/// small cost with a large s^2: a resonance without damping between two harmonics.
[[nodiscard]] PeriodicCost periodicCost(const PeriodicProblem& problem, const Eigen::Vector3d& theta,
                                        const Eigen::Vector2d& start,
                                        const std::vector<double>* variances = nullptr);

/// What the state has more at the first sample than after the last, from all used bins with the local fits
/// taken out: linear least squares with the range of the position as prior, so that a start whose effect is
/// below the noise stays zero.
[[nodiscard]] Eigen::Vector2d fitStart(const PeriodicProblem& problem, const Eigen::Vector3d& theta,
                                       const Eigen::Vector2d& lastStart);

/// Where the search can begin, best first: linear least squares of 1/G = K - M w^2 + j w B on the measured
/// ratios U / Y, hold and lag divided out, and a grid over natural frequency and damping ratio.
[[nodiscard]] std::vector<Eigen::Vector3d> periodicStarts(const PeriodicProblem& problem,
                                                          const std::optional<Eigen::Vector3d>& given);

enum class PeriodicOutcome { Converged, NotConverged, Diverged };
struct PeriodicSearch {
    PeriodicOutcome outcome = PeriodicOutcome::Diverged;
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    PeriodicCost cost;
    int iterations = 0;
};
/// Levenberg-Marquardt from the best starts, at first with variances that are constant while it goes on; the
/// start's transient is refitted between rounds.
[[nodiscard]] PeriodicSearch searchPeriodic(const PeriodicProblem& problem,
                                            const std::optional<Eigen::Vector3d>& given, int maxIterations);

} // namespace gripscope
