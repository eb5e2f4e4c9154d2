// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/periodic/periodic.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// The period of a force in whole samples, found from the force alone: the shortest lag at which the
/// normalised autocorrelation of the force, its trend taken out, has a peak as high as its highest, refined
/// by the lag at which the longest possible distance between periods fits best. Nothing when four periods
/// do not fit into the record, when the correlation from period to period is below 0.8 (noise of half the
/// signal's deviation), or when the force does not change. O(n log n).
[[nodiscard]] std::optional<std::size_t> findPeriod(std::span<const double> force);

/// The stretch in which the force repeats after `period` samples: the longest in which the change from one
/// period to the next is nowhere (over a period) much larger than is usual in the record; what precedes the
/// excitation (touch, preload) and follows it is left out. Empty when the force does not repeat.
[[nodiscard]] Window periodicStretch(std::span<const double> force, std::size_t period);

/// Force and position over P whole periods as one discrete Fourier transform each. Bin q is the frequency
/// 2 pi q / samples radians a sample: what repeats lies in the bins that are multiples of P (the harmonics),
/// and what differs from period to period, noise and drift, in all bins alike. The mean (bin 0) and a
/// straight line, which the differences between periods tell, are taken out first.
struct PeriodicSpectrum {
    std::size_t samples = 0;
    std::size_t periods = 0;                           ///< P
    std::vector<std::complex<double>> force, position; ///< bins 0..samples / 2, divided by sqrt(samples)
    double forceSlope = 0, positionSlope = 0;          ///< of the straight lines taken out, a sample

    [[nodiscard]] double radiansPerSample(std::size_t bin) const;
};
[[nodiscard]] PeriodicSpectrum periodicSpectrum(std::span<const double> force,
                                                std::span<const double> position, std::size_t periods);

/// The local polynomial method (Pintelon, Schoukens, Vandersteen, Barbe 2010) around one harmonic: a smooth
/// function, least squares on the bins beside it that are no harmonics, says what leakage of start and drift
/// has put into the harmonic's bin, and what it leaves of these bins measures the noise. The function is
/// a + b q, and near zero frequency a + b q + c / q, which is what the step between the two ends of a
/// drifting record leaks.
struct LocalFit {
    std::size_t bin = 0;             ///< of the harmonic
    std::vector<std::size_t> beside; ///< bins that are no harmonics
    Eigen::VectorXd interpolation;   ///< the smooth function at `bin` is their sum with these weights
    Eigen::MatrixXd basis;           ///< orthonormal columns: the smooth functions on `beside`
    double degreesOfFreedom = 0;     ///< complex ones, of the noise's variance: bins less functions
    double varianceFactor = 1;       ///< of the corrected harmonic against a bin: 1 + |interpolation|^2

    [[nodiscard]] Eigen::VectorXcd gather(std::span<const std::complex<double>> bins) const;
    /// `bins` at the harmonic less the smooth function.
    [[nodiscard]] std::complex<double> atHarmonic(std::span<const std::complex<double>> bins) const;
    /// What the smooth function leaves of the bins beside.
    [[nodiscard]] Eigen::VectorXcd residual(const Eigen::VectorXcd& gathered) const;
};
/// For a harmonic of a transform with `binCount` bins; `degreesOfFreedom` below 3 when there are too few.
[[nodiscard]] LocalFit localFit(std::size_t bin, std::size_t periods, std::size_t binCount);

/// A local fit for every harmonic that the force excites: an amplitude of at least 1 % of the largest and
/// well above the force's own noise. At most 20,000, the lowest.
[[nodiscard]] std::vector<LocalFit> excitedLines(const PeriodicSpectrum& spectrum);

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

/// p-value of a cost V of so many lines: V is compared with a gamma distribution of its mean, lines - 3/2,
/// and its variance, sum of v/(v - 2) over lines (F ratios) and lines^2 over all measured degrees of freedom,
/// since neighbouring lines share bins.
[[nodiscard]] double periodicCostP(const PeriodicProblem& problem, double cost);

/// Ratios, noise levels and distortion, forces and positions in the problem's units times these scales.
[[nodiscard]] PeriodicDiagnostics periodicDiagnostics(const PeriodicProblem& problem,
                                                      const PeriodicSearch& search, double forceScale,
                                                      double positionScale, double sampleTime_s);

/// Fills `simulated`, `residual`, `fit`, `nuisance` and the residuals' sum of squares of an estimate with
/// known m, b, k: the exact response to the whole force, its start (x0, v0) and offset by linear least
/// squares on the positions that were measured. Left empty when the numbers leave their range.
void fitPeriodicResponse(const std::vector<double>& force, const std::vector<double>& position,
                         const PeriodicOptions& options, Estimate& estimate);

} // namespace gripscope
