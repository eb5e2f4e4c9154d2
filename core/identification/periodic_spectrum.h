// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

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

} // namespace gripscope
