// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/model/motion_terms.h"
#include "core/signal/recording/measuring_chain.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>
#include <QString>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gripscope {

enum class Estimator {
    Arx,
    ArxMeanForce,
    Arx221,
    InstrumentalVariables,
    OutputError,
    Duffing,
    Periodic,
    Friction,
    Zener,
    FrictionZener,
    FrictionDuffing,
    ZenerDuffing,
    Static,
    StaticZener,
    StaticDuffing,
    Carriage
};

/// "arx", "oe", "friction+zener", ...: ids of the table of estimators (estimators/estimator_table.h), which
/// knows all else. The terms of a sum may come in any order.
[[nodiscard]] QString toString(Estimator estimator);
[[nodiscard]] std::optional<Estimator> estimatorFromString(const QString& text);

enum class EstimateStatus {
    Converged,
    NotConverged,
    NotIdentifiable,   ///< the data does not determine the parameters (rank deficient, constant force)
    NoPhysicalMapping, ///< coefficients exist, but no m, b, k > 0 belongs to them
    TooFewSamples,
    NotApplicable,
};
[[nodiscard]] QString toString(EstimateStatus status); ///< "converged", "not_converged", ...

/// Effective mass, damping and stiffness of m x'' + b x' + k x = F, in the channels' units.
struct MassDampingStiffness {
    double m = 0, b = 0, k = 0;
    [[nodiscard]] Eigen::Vector3d vector() const { return {m, b, k}; }
    friend bool operator==(const MassDampingStiffness&, const MassDampingStiffness&) = default;
};

/// What the estimators in continuous time are told of a record alike.
struct ContinuousTimeOptions {
    double sampleTime_s = 0;
    ForceHold hold = ForceHold::First;
    double lag_s = 0; ///< how much later the position channel samples than the force channel
    bool freeInitialState = true;
    bool freeOffset = true;
    /// Indexes where neither force nor position was measured (the values there are ignored).
    std::vector<std::size_t> lost;
    std::optional<MassDampingStiffness> start; ///< empty: found from the data
};

/// What an estimator needs to find besides m, b and k. Absent: not part of the model, or fixed at zero.
struct Nuisance {
    std::optional<double> x0, v0, offset;
};

/// Coefficients of y[t] + a1 y[t-1] + a2 y[t-2] = b1 u[t-1] (+ b2 u[t-2]) + constant + e[t].
struct ArxCoefficients {
    double a1 = 0, a2 = 0, b1 = 0;
    std::optional<double> b2, constant;
};

/// 100 (1 - |y - yhat| / |y - mean y|), percent; see contracts for the windows. Absent: not defined (a
/// constant y).
struct Fit {
    std::optional<double> simulationPercent, predictionPercent;
};

struct ResidualSummary {
    double sse = 0;
    double degreesOfFreedom = 0;
    std::optional<double> whitenessP;         ///< Ljung-Box
    std::optional<double> inputIndependenceP; ///< F test of past and present input on the residuals
    /// How many times larger the worst standard error became because the noise model was counted; output
    /// error only, as all that follows.
    std::optional<double> errorInflation;
    /// Ljung-Box on what the noise model leaves, and what counting that would do to the errors once more.
    std::optional<double> innovationWhitenessP, innovationInflation;
    /// The size of what the input explains of the residuals, and future input, in standard errors of a
    /// typical parameter: the root of F.
    std::optional<double> inputMisfit, feedbackP, feedbackMisfit;
    /// Test of a spring that is not straight (x^2 and x^3); by what share m, b or k moves, at the most, when
    /// such a spring is fitted too, and how many standard errors that is.
    std::optional<double> linearityP, linearityShift, linearityShiftInErrors;
};

/// What an estimator of the family of MotionTerms found, in the channels' units.
struct MotionEstimate {
    MotionTerms terms;
    MotionValues values;
    Eigen::MatrixXd covariance;          ///< of terms.parameters(), in their order
    std::optional<double> frictionLimit; ///< Fc is below it with 95 % confidence (one-sided)
    /// What a unit of position at a sample does to the parameters: a row a sample, zero where it was not
    /// used. For the budget; an identification that is done holds none.
    Eigen::MatrixXd influences;
    /// How far Fc is from what was known of it, in that one's standard errors, where that was counted.
    std::optional<double> offKnownFriction;

    /// Nothing for a parameter that its terms do not have.
    [[nodiscard]] std::optional<double> standardError(MotionParameter parameter) const;
};

/// k lies between these for certain, as far as what was assumed is true: limits, not a confidence interval.
struct StiffnessBounds {
    double lower = 0;
    std::optional<double> upper; ///< none: the record does not tell the object from a rigid one
};

/// Residuals that are not white: e[t] = sum_i coefficients[i-1] e[t-i] + w[t] + sum_j movingAverage[j-1]
/// w[t-j], w white.
struct AutoregressiveNoise {
    std::vector<double> coefficients;  ///< empty: white
    std::vector<double> movingAverage; ///< empty unless noise of the force channel was found
    double innovationDeviation = 0;    ///< standard deviation of w, in the position's unit
    /// Standard deviation of white noise in the measured force, in its unit, where that is what was found.
    std::optional<double> forceDeviation;
};

/// One estimator's answer to one window. `parameters` is empty for every status but Converged and, where a
/// usable last iterate exists, NotConverged. `covariance` is that of (m, b, k); only finite numbers appear
/// anywhere.
struct Estimate {
    Estimator estimator = Estimator::OutputError;
    EstimateStatus status = EstimateStatus::NotApplicable;
    Finding message; ///< why the status is what it is, in plain words
    /// What NotIdentifiable is about, where a parameter cannot be told from zero.
    std::optional<MotionParameter> notFromZero;
    std::optional<MassDampingStiffness> parameters;
    std::optional<Eigen::Matrix3d> covariance;
    /// With terms that m, b and k do not tell. Where it lacks a mass or a spring there are no `parameters`.
    std::optional<MotionEstimate> motion;
    std::optional<StiffnessBounds> stiffnessBounds; ///< of `static` where the position is held
    std::optional<AutoregressiveNoise> noise; ///< the model behind `covariance` where residuals are not white
    Nuisance nuisance;
    std::vector<double> lostForces; ///< found for the lost samples, in their order; output error only
    std::optional<ArxCoefficients> coefficients;
    Fit fit;
    ResidualSummary residuals;
    int iterations = 0;
    Window part; ///< the samples of the identification's window that it is of
    /// Model output on that part (simulation) and residuals y - yhat, for plots; empty when there is no
    /// model. ARX models run free from the measured y[0], y[1]; their residuals are those of the one-step
    /// prediction and start at t = 2.
    std::vector<double> simulated;
    std::vector<double> residual;

    [[nodiscard]] std::optional<Eigen::Vector3d> standardErrors() const;
    /// A motion that has no mass or no spring, so that there are no `parameters`.
    [[nodiscard]] bool isPartialMotion() const { return motion && !parameters; }
    /// With m, b and k, or a motion without all of them that was found.
    [[nodiscard]] bool hasAnswer() const
    {
        return parameters || (motion && status == EstimateStatus::Converged);
    }
};

/// The estimate as a motion of the family, whichever estimator found it; nothing where nothing was found.
[[nodiscard]] std::optional<MotionEstimate> motionOf(const Estimate& estimate);

/// m, b, k of the object alone with their covariance, in the channels' units.
struct CorrectedParameters {
    MassDampingStiffness parameters;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The empty gripper's own mass, damping and stiffness move in parallel with the object's, so that the forces
/// add: what is measured is (m, b, k) of both together, and the object's are the differences. The baseline
/// was measured on its own, so that the covariances add (JCGM 100, 5.1.2); its three errors count as
/// independent, since only their sizes are kept.
///
/// Nothing when a difference is not above zero (the object is not told from the empty gripper) or when a
/// number is not finite.
[[nodiscard]] std::optional<CorrectedParameters> withoutGripper(const MassDampingStiffness& measured,
                                                                const Eigen::Matrix3d& covariance,
                                                                const GripperBaseline& baseline);

} // namespace gripscope
