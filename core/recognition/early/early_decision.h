// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error/output_error_problem.h"
#include "core/recognition/early/linearized_evidence.h"
#include "core/recognition/types/instrument_range.h"

#include <Eigen/Core>
#include <QString>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// A type as a squeeze of it will be: mean and covariance of (ln m, ln b, ln k), in the channels' units, with
/// the uncertainty of the enrolment in the covariance.
struct CandidateType {
    QString name;
    Eigen::Vector3d meanLog = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covarianceLog = Eigen::Matrix3d::Zero();
};

/// From a third of the smallest to three times the largest value of any type, each parameter by itself: for
/// channels whose units say nothing of what a gripper may meet.
[[nodiscard]] InstrumentRange rangeAround(const std::vector<CandidateType>& types);

struct EarlyDecisionOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
    bool freeInitialState = true, freeOffset = true;
    double strangerShare = 0.1; ///< of strangers among the objects squeezed
    double statedError = 0.01;  ///< of the squeezes decided, wrong at the most
    /// Of the squeezes decided to be a type, those of another type at the most; absent: as statedError has
    /// it.
    std::optional<double> otherTypes = {};
    bool colouredNoise = true;        ///< noise may be first-order autoregressive; else it is white
    std::size_t firstSamples = 10;    ///< before the first look
    double growth = 1.03;             ///< of the record from one look to the next
    std::size_t mostSamples = 20'000; ///< kept; no looks after that many
    friend bool operator==(const EarlyDecisionOptions&, const EarlyDecisionOptions&) = default;
};

enum class EarlyVerdict { Undecided, Type, Unknown };

/// What the squeeze says so far.
struct EarlyJudgement {
    EarlyVerdict verdict = EarlyVerdict::Undecided;
    std::size_t samples = 0;
    std::optional<std::size_t> best; ///< the likeliest candidate's index; empty: a stranger
    std::vector<double> posterior;   ///< one a candidate, in order, then that of a stranger; sums to 1
    /// The likeliest mass, damping, stiffness with no type assumed.
    std::optional<MassDampingStiffness> parameters;
    std::optional<Eigen::Matrix3d> covarianceLog; ///< of their logarithms, the range a weak prior
};

/// Follows a squeeze and stops it as soon as the stated error rate is reached.
///
/// Each type's density of the record, with m, b and k scattered as the type's do, x0, v0 and offset free and
/// the noise's deviation and pole unknown, all integrated out (linearized_evidence.h), against the density
/// under a stranger (the same about the likeliest m, b, k, for a flat prior over the background's range). The
/// squeeze is decided at the first look where one of them has a posterior of at least 1 - statedError. A
/// posterior does not mind when one stops (Berger, Statistical Decision Theory, 7.4.7): of the squeezes
/// decided, at most the stated share is wrong when objects, noise and types are as assumed.
///
/// Looks are made at lengths that grow by a fixed ratio, so that all together cost a few times the last one.
/// A value; the same samples give the same judgements.
class EarlyDecider {
public:
    /// Types whose covariance is not positive definite are never the verdict. With no type at all nothing is
    /// decided. Strangers lie in `range`, in the channels' units; one that is no range is taken for
    /// rangeAround().
    EarlyDecider(std::vector<CandidateType> types, const InstrumentRange& range,
                 const EarlyDecisionOptions& options);

    /// The next sample, in the channels' units; one that was lost has a value that is not a number. True: it
    /// is time to look.
    bool add(double force, double position);
    /// Looks at all samples so far. Milliseconds for a thousand samples and ten types.
    [[nodiscard]] const EarlyJudgement& look();
    [[nodiscard]] const EarlyJudgement& judgement() const { return m_judgement; }
    [[nodiscard]] bool decided() const { return m_judgement.verdict != EarlyVerdict::Undecided; }

private:
    [[nodiscard]] OutputErrorProblem problem() const;
    [[nodiscard]] double logEvidence(std::size_t type, const OutputErrorProblem& problem,
                                     std::span<const NoiseNode> nodes);
    void conclude(const std::vector<double>& logs);

    std::vector<CandidateType> m_types;
    Eigen::Vector3d m_lowestLog, m_highestLog; ///< the strangers' range
    EarlyDecisionOptions m_options;
    std::vector<double> m_force, m_position;
    std::vector<std::size_t> m_lost;
    std::size_t m_nextLook;
    /// Where the record is linearised: for each type and for a stranger, ln of m, b, k.
    std::vector<Eigen::Vector3d> m_points;
    EarlyJudgement m_judgement;
};

} // namespace gripscope
