// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/recording/recording.h"

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace gripscope {

/// How to find m, b, k from a force that repeats.
struct PeriodicOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
    /// Of the excitation, in samples; empty: found from the force. See excitationPeriod().
    std::optional<std::size_t> period;
    std::optional<MassDampingStiffness> start; ///< empty: found from the data
    std::vector<std::size_t> lost;             ///< sorted indexes where nothing was measured
    int maxIterations = 200;
};

/// One excited harmonic: the ratio of position to force, with no model but linearity.
struct PeriodicLine {
    double frequency_Hz = 0;
    std::complex<double> response; ///< position over force, channel units
    double deviation =
        0; ///< standard deviation of `response` (of real and imaginary part together) from noise
};

/// What repetition tells beside m, b and k.
struct PeriodicDiagnostics {
    std::size_t periodSamples = 0, periods = 0; ///< used
    Window window;                              ///< the samples used
    std::vector<PeriodicLine> lines;
    /// Standard deviation of what does not repeat, per sample, from the bins beside the lines, channel units;
    /// and the magnitude of its correlation between the channels, 0 to 1. A correlation says that the force
    /// answers to the position (or both to one disturbance).
    double forceNoise = 0, positionNoise = 0, noiseCorrelation = 0;
    /// What a straight line through the periods rises by over the window, channel units: the drift that was
    /// taken out first.
    double forceDrift = 0, positionDrift = 0;
    /// V / (lines - 3/2), 1 in expectation, and the p-value of so much or more: misfit that the noise does
    /// not explain. A small p has inflated the covariance by `costRatio`.
    double costRatio = 1, costP = 1;
    /// Harmonics within the band that the force does not excite (the even ones of an inverse-repeat
    /// sequence). What the position has there beyond noise and beyond the linear answer to what force there
    /// is comes from a nonlinear object: its size in percent of the excited lines' (root mean square), and
    /// the p-value of so much or more from noise. Absent: no such harmonics.
    std::optional<double> distortionPercent, distortionP;
};

struct PeriodicResult {
    Estimate estimate;
    std::optional<PeriodicDiagnostics> diagnostics; ///< where there are parameters
};

/// Sample maximum likelihood in the frequency domain on periods of an excitation, errors in both variables
/// (Pintelon and Schoukens, System Identification: A Frequency Domain Approach, 2nd ed., ch. 9 and 12):
///  - The force may be noisy and may answer to the position (feedback): what does not repeat with the
///    excitation counts as noise, of force and position and with their correlation, and is measured from the
///    record itself. The known, repeating command is the instrument.
///  - Drift and the start's transient leak smoothly into the spectrum; a straight line, the free response of
///    (m, b, k) and a local polynomial take them out (periodic_search.h). No period is
///    thrown away. The position's offset is bin 0, which is not used.
///  - `covariance` counts that the noise was measured with few degrees of freedom, and is inflated by the
///  cost
///    where this is larger than noise explains (p < 0.01; said in the message). Noise may have any colour
///    that is smooth over a few harmonics.
/// Needs at least 4 whole periods: 3 would give a covariance of both noises, 4 an estimate weighted with it
/// that has a variance; 6 and more are better. Cost is linear in lines and bins, n log n for the transform.
///
/// All numbers must be finite, force and position equally long, the sample time positive. `simulated` is the
/// response to the measured force from the best start and offset, `residual` its error: drift and all, so
/// that neither these nor the fit judge the estimate. `residuals.inputIndependenceP` is the p-value of the
/// cost. Statuses: Converged; NotConverged with the last iterate; NotApplicable when the force does not
/// repeat; TooFewSamples for less than four periods; NotIdentifiable when the lines do not determine m, b and
/// k.
[[nodiscard]] Estimate estimatePeriodic(const std::vector<double>& force, const std::vector<double>& position,
                                        const PeriodicOptions& options);
[[nodiscard]] PeriodicResult analysePeriodic(const std::vector<double>& force,
                                             const std::vector<double>& position,
                                             const PeriodicOptions& options);

/// The period that a recording's provenance states ("excitation_period_samples"), if any.
[[nodiscard]] std::optional<std::size_t> excitationPeriod(const Recording& recording);

} // namespace gripscope
