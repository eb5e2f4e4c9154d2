// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/model/estimate.h"
#include "core/identification/output_error/output_error.h"
#include "core/signal/recording/measuring_chain.h"

#include <Eigen/Core>
#include <QString>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// By how much m, b and k differ from one part of the record (or one squeeze, or one amplitude) to the next
/// beyond what the stated noise explains: what the model leaves out, as far as it changes with time and
/// amplitude.
struct ModelDiscrepancy {
    /// Of (ln m, ln b, ln k) from one part to another; zero when the parts agree. It belongs to each part and
    /// to the whole alike, undivided: more samples of the same do not average a wrong model out.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector3d degreesOfFreedom = Eigen::Vector3d::Ones(); ///< of its three variances
    int parts = 0;                                              ///< how many were compared; 0: none
    std::optional<double> agreementP; ///< p-value of the hypothesis that all parts have one m, b and k
    Finding words;                    ///< what was found, or why it could not be
    [[nodiscard]] bool found() const { return covariance.trace() > 0; }
};

/// Parts whose probability of agreeing is above this are taken to agree. A true model is charged so seldom
/// that its intervals grow by 1 to 2 % on average.
inline constexpr double discrepancyLevel = 0.003;

/// From estimates of different parts, each with its own covariance. Cochran's Q in three dimensions, theta =
/// (ln m, ln b, ln k), with Student's correction for estimated variances, against F(3 (K - 1), sum of their
/// degrees of freedom); when it is significant, the between-part covariance by moments,
///     Psi = S - mean V_i, S the sample covariance of the theta_i,
/// cut to its positive part (DerSimonian and Laird 1986; Jackson, White and Riley 2013, in several
/// dimensions, unweighted), with (K - 1) (Psi_jj / S_jj)^2 degrees of freedom, at least one.
///
/// Estimates that did not converge, without a covariance or with a standard error above 25 % are left out;
/// fewer than three say nothing.
[[nodiscard]] ModelDiscrepancy discrepancyBetween(std::span<const Estimate> estimates);

/// The stretches of equal length a record is split into: 4 to 6 of at least 60 samples, 4 time constants and
/// 2 swings each; none when it is too short.
[[nodiscard]] std::vector<Window> discrepancyWindows(std::size_t samples, double sampleTime_s,
                                                     const MassDampingStiffness& parameters);

/// Estimates every window of a record on its own (`estimate` with a free initial state; any estimator; called
/// from several threads at once) and compares them. `whole` is the estimate from all samples.
[[nodiscard]] ModelDiscrepancy modelDiscrepancy(std::size_t samples, double sampleTime_s,
                                                const Estimate& whole,
                                                const std::function<Estimate(Window)>& estimate);

/// How a standard uncertainty was found (JCGM 100, 2.3): A from the statistics of this record, B otherwise.
enum class EvaluationType { A, B };
[[nodiscard]] QString toString(EvaluationType type); ///< "A", "B"

/// One effect's part in the uncertainty of m, b and k. `id` is one of position_noise, noise (position and
/// force noise together, coloured), force_noise, quantization, lag, friction, jitter, hold, calibration,
/// frame_compliance, baseline, model_discrepancy.
struct BudgetLine {
    QString id;
    Finding words; ///< what it is and how large, plain words
    EvaluationType type = EvaluationType::B;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of (m, b, k), the channels' units squared
    std::optional<Eigen::Vector3d> degreesOfFreedom;      ///< of m, b, k; none: as good as infinite
    Eigen::Vector3d share = Eigen::Vector3d::Zero();      ///< of the combined variances of m, b, k, 0 to 1
    [[nodiscard]] Eigen::Vector3d standardUncertainties() const;
};

/// The range that holds the value with the stated probability.
struct CoverageInterval {
    double lower = 0, upper = 0;
    bool logarithmic = false; ///< symmetric in the logarithm, else symmetric
    /// The data says only that the value is at most `upper`: the relative standard uncertainty is above 50 %,
    /// or the range begins at zero.
    bool onlyUpperBound = false;
};

/// A standard uncertainty with its effective degrees of freedom and the factor that gives the expanded one.
struct CombinedUncertainty {
    double standardUncertainty = 0;
    std::optional<double> degreesOfFreedom; ///< none: as good as infinite
    double coverageFactor = 0;              ///< Student's t
};

/// One of a motion's parameters that m, b, k and their budget do not hold: Fc, k1, tau, k3; all of them where
/// there is no mass or no spring.
struct FurtherParameter {
    MotionParameter parameter = MotionParameter::Friction;
    double value = 0; ///< the channels' units
    CombinedUncertainty combined;
    CoverageInterval interval;
};

/// What a motion's parameters are uncertain by beside noise and scales.
struct MotionDoubts {
    std::vector<MotionEstimate> parts; ///< of the record, each estimated on its own, with the same terms
    /// The same with a term more or less that is not refuted: with a mass, or with damping and friction of
    /// their own each way.
    std::optional<MotionEstimate> otherForm;
    /// What one standard deviation of an effect, such as the lag, moves the parameters by.
    std::vector<MotionValues> shifts;
    Eigen::VectorXd roundingVariances; ///< roundingVariances(); of the motion's parameters, or of none
};

/// Their uncertainties: the estimate's own, the scales of the channels, what the frame's compliance is
/// uncertain by (k alone, k^2 times that), and the doubts: what the parts differ by beyond their errors
/// (Cochran's Q and the variance between them by moments, as discrepancyBetween()), the whole difference to
/// the other form (of two ways their mean), the shifts and what rounding adds. Friction's interval is cut at
/// zero; the gripper's own friction, and of m, b and k the empty gripper's, are taken off where they are
/// known; what is not above zero then is left out.
[[nodiscard]] std::vector<FurtherParameter> furtherParameters(const MotionEstimate& motion,
                                                              const MeasuringChain& chain,
                                                              const MotionDoubts& doubts, double coverage);

/// What the position's counts, `step` apart, do to the parameters of a motion where its noise does not hide
/// them: quantizationLines(), one by one, or, where there is next to no noise, what counts do that err each
/// for itself, if that is more. Empty where there is nothing.
[[nodiscard]] Eigen::VectorXd roundingVariances(const Estimate& estimate, double step);

/// k that is known to lie between two bounds: at the middle of their logarithms, with the deviation of a
/// rectangular distribution there (JCGM 100, 4.3.7). The interval is the bounds themselves, wider by what the
/// channels' scales are uncertain by.
[[nodiscard]] FurtherParameter boundedStiffness(double lower, double upper, const MeasuringChain& chain,
                                                double coverage);

/// What a mass that a motion of damper and spring (`static`) left out may have done to its b: as far as b
/// gets in a motion with a mass that the record does not refute (likelihood ratio, 95 %; m k / b^2 up to 4),
/// all alike (JCGM 100, 4.3.7). Samples that are far apart see the end of a motion alone, which a little
/// damping and no mass explain as well as more of both. Nothing for other motions. `options`: as it was
/// estimated.
[[nodiscard]] std::optional<MotionValues> hiddenMassShift(const Estimate& estimate,
                                                          const std::vector<double>& force,
                                                          const std::vector<double>& position,
                                                          const OutputErrorOptions& options);

/// Coulomb friction beside a motion of damper and spring, or spring alone (`static`): at rest after each step
/// the part hangs back by Fc / k, on the side it came from.
struct RestingFriction {
    /// Of the square of that effect, what k, b and the offset cannot imitate: next to nothing with two levels
    /// of force, where each is always reached from the same side.
    double ownShare = 0;
    /// What the friction that the residuals leave possible, or that is known of the gripper, moves k and b
    /// by: the root of its mean square, all that is not below zero alike before. Zero where nothing is known.
    MotionValues shift;
    /// Else friction hides in k altogether.
    [[nodiscard]] bool isTold() const { return ownShare >= 0.01; }
};
/// Nothing for other motions, and where the position does not move. First order in the friction.
[[nodiscard]] std::optional<RestingFriction> restingFriction(const Estimate& estimate, double sampleTime_s,
                                                             const std::optional<GripperFriction>& known);
/// The uncertainty of one estimate as a whole, in the manner of the Guide to the Expression of Uncertainty in
/// Measurement (JCGM 100:2008): every effect a line, covariances added up, effective degrees of freedom after
/// Welch and Satterthwaite (G.4.1), intervals after Student.
struct UncertaintyBudget {
    Finding message; ///< why there is no budget, or what could not be counted; empty when all was
    std::optional<MassDampingStiffness> parameters; ///< without the empty gripper's; none: no budget
    std::vector<BudgetLine> lines;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< sum over the lines
    std::array<CombinedUncertainty, 3> combined;          ///< of m, b, k
    std::array<CoverageInterval, 3> intervals;            ///< of m, b, k
    std::vector<FurtherParameter> further;                ///< of a motion with further terms
    double coverage = 0.95;

    [[nodiscard]] const BudgetLine* find(const QString& id) const;
    /// Of a quantity with these derivatives to m, b, k; to first order.
    [[nodiscard]] CombinedUncertainty propagate(const Eigen::Vector3d& gradient) const;
};

/// What m, b and k would be under the other hold, and how probable that one is after the data (0 to 1).
struct HoldAmbiguity {
    MassDampingStiffness other;
    double probability = 0;
};

struct BudgetOptions {
    std::optional<HoldAmbiguity> hold;
    std::optional<ModelDiscrepancy> discrepancy; ///< between windows, amplitudes or squeezes
    double lagBound_s = 0;        ///< half of the range of a lag that nobody measured; 0: it is known
    double positionStep = 0;      ///< of the position's counts, its unit; 0: none
    bool frictionIsKnown = true;  ///< false: the gripper's own, or the part's, may be there
    bool subtractBaseline = true; ///< false: `estimate` is that of the object alone already
    double coverage = 0.95;
};

/// The budget of an output-error estimate (or another one of the same model) of this record. Linear
/// propagation (effect_regression.h):
/// - noise: the estimate's own covariance; where the chain states the noise of the force, the covariance that
///   its filtered answer causes and s^2 (J'J)^-1 with the rest of s^2, unless the residuals are coloured so
///   strongly that their own noise model asks for more;
/// - quantization: what rounding adds to the residuals' white noise where it follows the motion
///   (quantizationLines());
/// - lag: the velocity is what a second of lag adds, with the chain's uncertainty or, where nobody measured
///   the lag, a rectangular distribution within BudgetOptions::lagBound_s (JCGM 100, 4.3.7); frame
///   compliance: the force is what a unit of compliance adds (a declared compliance was taken off the
///   position before the estimate);
/// - friction: where it is neither known nor in the estimate, what friction that the record cannot exclude
///   did to it (hiddenFrictionLines()); where it is in the estimate, how it begins to slide
///   (frictionFormLines());
/// - jitter: the part of the noise that grows with the speed, where the residuals show it (jitterLines());
/// - calibration: m, b, k are proportional to force over position, exactly; after the baseline, which the
///   same channels measured;
/// - hold: so much that the interval reaches the parameters under the other hold. With coverage 1 - 2 q and a
///   probability P of the other hold those are missed with probability q / P when they are true; a P of q
///   needs no line. As P comes from a likelihood ratio, 1 / P is 2 on average where the other hold is true:
///   the interval covers under either hold, however well the record tells them apart;
/// - baseline: subtracted, its variances added.
/// A line appears for every effect that is there. Intervals are symmetric in the logarithm, which positive
/// parameters with relative uncertainties suit better and where a scale error is exact, but symmetric after
/// a baseline and where an uncertainty is above half the value; they do not reach below zero.
[[nodiscard]] UncertaintyBudget uncertaintyBudget(const Estimate& estimate, const std::vector<double>& force,
                                                  const std::vector<double>& position,
                                                  const OutputErrorOptions& options,
                                                  const MeasuringChain& chain,
                                                  const BudgetOptions& budgetOptions = {});

} // namespace gripscope
