// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gripscope {

/// What time stamps and sequence numbers say about the clock behind a recording: the model is
///     t[i] = t0 + (index[i] + jitter[i]) T,   index[i] whole, index[0] = 0,
/// with the mean sample time T by least squares.
struct SampleClock {
    double sampleTime_s = 0; ///< T, measured
    double drift = 0;        ///< T over the nominal sample time, less 1
    double driftError = 0;   ///< standard error of drift
    /// The drift is told from zero: five standard errors and a millionth, which is below any clock worth a
    /// name and above the rounding of printed times.
    bool drifts = false;
    double jitter = 0;     ///< root mean square of jitter[i], in sample times
    double resolution = 0; ///< lattice of the time stamps in sample times; zero when there is none
    /// The jitter is more than `smallestJitter` and more than the rounding of the stamps explains: the
    /// samples themselves were not taken regularly.
    bool jittered = false;
    std::size_t breaks = 0;          ///< places where stamps and sequence numbers contradict each other
    std::int64_t lost = 0;           ///< samples missing, without those at breaks
    std::size_t gaps = 0;            ///< places where they are missing
    std::vector<std::int64_t> index; ///< of each sample
    std::vector<double> time;        ///< index + jitter of each sample
};

/// Jitter below this share of a sample time changes nothing worth a resampling: on a signal of frequency
/// omega it acts as noise of omega T times the share, 0.1 % of the signal at omega T = 0.1.
inline constexpr double smallestJitter = 0.01;

/// A step of time (in sample times) and the step of the sample count beside it cannot both be right: they
/// differ by more than 0.7 samples (jitter of a quarter at both ends stays below) and by more than 1 %.
[[nodiscard]] bool stepsContradict(double timeSteps, double sequenceSteps);

/// Reads the clock. Lost samples come from the sequence numbers, or where there are none from the time
/// stamps, each rounded to the nearest place on a grid that follows the clock (a wrong count needs a jitter
/// of half a sample time). Where a step of time and one of the sequence contradict each other, or either runs
/// backwards, the clock was set, or the device started again. How many samples are missing there is not
/// known; at least two are taken as lost, after which nothing about the state before is assumed. A gap of
/// more than 50 samples without sequence numbers is as long as it is said to be, but does not count for T.
///
/// `sequence` is empty or as long as `time_s`; all times finite, `nominal_s` > 0. Fewer than two samples: the
/// nominal clock.
[[nodiscard]] SampleClock readSampleClock(std::span<const double> time_s,
                                          std::span<const std::uint64_t> sequence, double nominal_s);

} // namespace gripscope
