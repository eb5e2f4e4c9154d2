// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// The response of a record at one frequency.
struct EmpiricalLine {
    double frequency_Hz = 0;
    std::complex<double> response; ///< position over force, the channels' units
    double coherence = 0;          ///< 0 to 1: the share of the position's power that is linear in the force
    /// Standard error of the magnitude as a share of it, and of the phase in radians. None where the
    /// coherence is below EmpiricalResponse::coherenceLimit: it is good to first order only, and the point is
    /// not worth more than "somewhere here".
    std::optional<double> relativeError;
};

struct EmpiricalResponse {
    enum class Status {
        Found,
        TooShort,   ///< less than `leastSamples` in one piece, or too many samples lost between
        NotExcited, ///< the force does not change
    };
    static constexpr std::size_t leastSamples = 224; ///< thirteen half-overlapping sections of 32
    /// The largest normalised error for which its first order is good (Bendat and Piersol, 9.2.4).
    static constexpr double largestRelativeError = 0.2;

    Status status = Status::TooShort;
    std::size_t sectionSamples = 0;
    std::size_t sections = 0;         ///< that were averaged
    double averages = 0;              ///< as many independent ones they are worth
    double coherenceLimit = 1;        ///< where the relative error is `largestRelativeError`
    std::vector<EmpiricalLine> lines; ///< ascending; frequencies that the force does not hold are left out
};

/// The transfer function from force to position that the record shows without any model (Welch 1967; Bendat
/// and Piersol, Random Data, 4th ed., ch. 9 and 11.5):
///     G(f) = Suy / Suu,   coherence g2 = |Suy|^2 / (Suu Syy),   var|G| / |G|^2 = var(phase) = (1 - g2) / (2
///     g2 n)
/// with the spectra averaged over half-overlapping sections of equal length under a Hann window, each
/// section's weighted mean taken off first. K sections, A of them next to each other, are worth
/// n = K^2 / (K + 2 A / 36) independent ones, 1/6 being the correlation of two such windows that overlap by
/// half. Sections are the largest power of two of which thirteen fit (32 to 2048 samples); a section with a
/// lost sample is left out.
///
/// Assumes: the force is the input and free of noise (noise of the force makes |G| low by its share of Suu;
/// an object that drives the force biases it), the object is linear and a section is long against its memory
/// (2 m / b): what it still answers from the section before counts as noise and lowers the coherence. The
/// position's noise may have any colour. Lines begin at two sections' frequencies, the half width of the
/// window's main lobe, and end below half the sample rate.
///
/// `force` and `position` equally long, finite, at a regular sample time above zero; `lost`: ascending
/// indexes where nothing was measured. No NaN out. O(n log sectionSamples).
[[nodiscard]] EmpiricalResponse empiricalResponse(std::span<const double> force,
                                                  std::span<const double> position, double sampleTime_s,
                                                  std::span<const std::size_t> lost = {});

/// How the channels were sampled that a model's response is to be compared with.
struct ResponseSampling {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
};

/// The response of m x'' + b x' + k x = F at one frequency.
struct ModelLine {
    double frequency_Hz = 0;
    std::complex<double> response; ///< position over force, the channels' units
    double phase = 0;              ///< of `response`, radians, without jumps from one frequency to the next
    /// Standard errors to first order: of the magnitude as a share of it, of the phase in radians. Zero
    /// without a covariance.
    double relativeError = 0, phaseError = 0;
};

/// The exact transfer function from force samples to position samples (periodic_response.h) with the lag
/// between the channels, so that it answers the question of empiricalResponse(): hold and folding are in it.
/// With theta = (ln m, ln b, ln k), whose covariance is that of (m, b, k) divided by them,
///     d ln|G| = Re(G^-1 dG/dtheta),   d arg G = Im(G^-1 dG/dtheta)
/// give the errors. A 95 % band is |G| exp(+-1.96 relativeError), phase +- 1.96 phaseError, frequency by
/// frequency.
///
/// Parameters above zero, frequencies ascending, above zero and below half the sample rate. Empty when the
/// parameters leave the range of numbers. Linear in the frequencies.
[[nodiscard]] std::vector<ModelLine> modelResponse(const MassDampingStiffness& parameters,
                                                   const std::optional<Eigen::Matrix3d>& covariance,
                                                   const ResponseSampling& sampling,
                                                   std::span<const double> frequencies_Hz);

/// `count` frequencies from `low_Hz` to `high_Hz`, both above zero, evenly on a logarithmic axis.
[[nodiscard]] std::vector<double> logarithmicFrequencies(double low_Hz, double high_Hz, std::size_t count);

} // namespace gripscope
