// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/recursive/recursive_pass.h"

#include <optional>
#include <vector>

namespace gripscope {

struct RecursiveOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
    std::optional<MassDampingStiffness> start; ///< empty: found from the data
    /// Output error is tried on this many samples, and on half as many again each time it does not determine
    /// m, b and k.
    std::size_t startSamples = 60;
    /// So many samples are kept for reading again; later ones are only counted in, where the estimate moves
    /// too little for it to matter.
    std::size_t keptSamples = 50'000;
};

enum class RecursiveStatus {
    Waiting,   ///< the samples do not determine m, b and k yet
    Searching, ///< an estimate, but further than its own error from where the search is going
    Following, ///< at the least-squares optimum of all samples so far, but for a small fraction of its error
};
[[nodiscard]] QString toString(RecursiveStatus status); ///< "waiting", "searching", "following"

struct RecursiveState {
    RecursiveStatus status = RecursiveStatus::Waiting;
    std::size_t samples = 0;                        ///< seen, lost ones included
    std::optional<MassDampingStiffness> parameters; ///< channel units; absent while waiting
    std::optional<Eigen::Matrix3d> covariance;      ///< of m, b, k; absent unless following
    Nuisance nuisance;         ///< x0, v0, offset; x0 and v0 at the first position's time
    double noiseDeviation = 0; ///< of the residuals, position's unit
};

/// Output error (output_error.h) that follows a squeeze sample by sample: m, b, k with free x0, v0 and
/// offset, at a bounded price a sample.
///
/// One pass carries the exact sensitivities at the latest point through every new sample and adds them to the
/// information (recursive least squares in information form); the estimate is its Gauss-Newton step, the
/// covariance s^2 (J'J)^-1 as in the batch. Recursions that only do this are stuck with the first samples'
/// linearisation (Ljung, System Identification, 2nd ed., section 11.4). So a second pass at a newer point
/// reads the kept samples again, a few for every new one, and takes over once it has caught up and fits
/// better; its point is damped after Levenberg and Marquardt. When it has caught up, the estimate is that of
/// the batch but for the square of the last step.
///
/// A value: copies are independent. Same samples, same states. A position or force that is not a finite
/// number was lost: the last force is held and no position is counted. Not for positions or forces beyond
/// 1e+-140, whose squares leave the range of numbers: it then waits for ever.
class RecursiveEstimator {
public:
    explicit RecursiveEstimator(const RecursiveOptions& options);

    /// The force and the position at the next sample time.
    void update(double force, double position);
    [[nodiscard]] RecursiveState state() const;

private:
    using Sample = LagDelay::Sample;
    void follow(const Sample& sample);
    void tryToStart();
    void read(RecursivePass& pass, std::size_t most) const;
    void launchTrial();
    void judgeTrial();
    [[nodiscard]] bool wholeRecordKept() const { return m_followed == m_kept.size(); }
    [[nodiscard]] RecursivePass::Point inSamples(const Estimate& estimate) const;

    RecursiveOptions m_options;
    LagAlignment m_lag;
    LagDelay m_delay;
    double m_lastForce = 0;
    std::vector<Sample> m_kept;
    std::size_t m_samples = 0;  ///< that came
    std::size_t m_followed = 0; ///< that came out of the delay
    double m_shift = 0;         ///< the first position: what is left of it is small
    RecursivePass m_pass;       ///< up to date, at the best point so far; not usable before the start
    RecursivePass m_trial;      ///< on its way from the first sample; not usable when there is none
    double m_damping = 0;
    bool m_hurry = false;                         ///< the trial is needed soon
    std::size_t m_nextStart = 0, m_nextTrial = 0; ///< of m_followed
};

} // namespace gripscope
