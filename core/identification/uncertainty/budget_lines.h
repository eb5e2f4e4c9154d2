// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/uncertainty/effect_regression.h"
#include "core/identification/uncertainty/uncertainty_budget.h"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// A term that a linear spring and damper leave out and that the residuals ask for.
struct MissingTerm {
    QString id; ///< cubic_spring, quadratic_spring, quadratic_damping, dry_friction, smooth_force
    Finding words;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< what leaving it out did to ln m, ln b, ln k
};

/// What the residuals of one record, as far as force and motion explain them, say about the error of m, b and
/// k: model error, as opposed to noise.
struct ModelMisfit {
    std::vector<MissingTerm> terms;
    /// Of (ln m, ln b, ln k), from what no term explains but past and present force does: unmodelled linear
    /// dynamics.
    Eigen::Matrix3d remainder = Eigen::Matrix3d::Zero();
    double remainderDegreesOfFreedom = 0;
    std::optional<double> remainderP; ///< that past and present force explains nothing more
};

/// Probability that a true model in white (or well modelled) Gaussian noise is charged with a misfit; half of
/// it goes to the terms together, half to the remainder.
inline constexpr double misfitLevel = 1e-3;

/// Linear regression of the residuals on what candidate terms add to the position (force that x^3, x^2,
/// x'|x'| or the sign of x' take up; force that is smooth between the samples where first-order hold has
/// straight lines, straightAsSpline()), x0, v0, offset and the
/// sensitivities to m, b and k along. Terms enter one by one by their F test; the shifts of
/// (ln m, ln b, ln k) that leaving them out caused belong together, since terms that are alike share theirs.
/// A term that bends must also explain more than the linearisation leaves of the whole misfit.
///
/// What is left is regressed on the force at the lags of residual_tests.h. Where that explains more than
/// noise would, by the variance ratio F, the misfit is taken to be as large in the three directions of m, b
/// and k, where the fit has hidden it, as it is on average in the others: covariance (F - 1) s^2 (S'S)^-1.
///
/// `known` are effects that the budget counts already (a lag or a compliance declared with an uncertainty):
/// what they explain is no misfit. All rows are whitened by the autoregressive model of the residuals
/// (autoregressiveModel()). Nothing is found in residuals at the size of rounding errors (below 1e-9 of the
/// position).
/// Dry friction is no candidate where `frictionIsKnown` is false: then it is among `known`.
[[nodiscard]] ModelMisfit modelMisfit(const Estimate& estimate, const LinearizedRecord& record,
                                      const std::vector<double>& force, const OutputErrorOptions& options,
                                      const std::vector<std::vector<double>>& known = {},
                                      bool frictionIsKnown = true);

// The single lines of an uncertainty budget before they are added up; see uncertaintyBudget(). Effects that
// are not there give no line. `p` is what the line is about, in the channels' units.

/// Student's factor; without degrees of freedom that of the normal distribution.
[[nodiscard]] double coverageFactor(double coverage, const std::optional<double>& degreesOfFreedom);

/// A normal quantity's interval: symmetric in the logarithm where it may be and the uncertainty is at most
/// half of the value, else symmetric and, unless `mayBeNegative`, cut at zero.
[[nodiscard]] CoverageInterval intervalAround(double value, const CombinedUncertainty& u,
                                              bool mayBeLogarithmic, bool mayBeNegative = false);

/// A symmetric matrix without what its negative eigenvalues stand for, in units of `scale`.
[[nodiscard]] Eigen::Matrix3d positivePart(const Eigen::Matrix3d& symmetric,
                                           const Eigen::Vector3d& scale = Eigen::Vector3d::Ones());

/// The coefficients of the residuals' autoregressive model, none where they are white: their colour, which no
/// test may take for an effect.
[[nodiscard]] std::vector<double> residualColour(const Estimate& estimate, const LinearizedRecord& record);

/// A line whose covariance in (ln m, ln b, ln k) is `relative`.
[[nodiscard]] BudgetLine lineOf(const QString& id, const Finding& words, EvaluationType type,
                                const Eigen::Vector3d& p, const Eigen::Matrix3d& relative);

/// The lines of an uncertainty budget (see uncertaintyBudget()) that come from the channels' noise: one from
/// the residuals; or, where the force channel's noise is known, one for each channel. Then the force's noise
/// F(t) moves the position by g * F, g the model's impulse response, and the estimate by
///     A' (g * F),   A' = (S'S)^-1 S',
/// S the sensitivities without the nuisances: covariance sd^2 (A' G)(A' G)', G the convolution with g; the
/// position's noise has what is left of the residuals' variance. Exact for white noise, to first order in the
/// noise. Residuals whose colour this does not explain keep their own noise model where that asks for more.
[[nodiscard]] std::vector<BudgetLine> noiseLines(const Estimate& estimate, const LinearizedRecord& record,
                                                 const OutputErrorOptions& options,
                                                 double forceNoiseDeviation);

/// The lag of the chain with its uncertainty, or else one that nobody measured: within +-`lagBound_s`, all
/// values alike; and frame compliance.
[[nodiscard]] std::vector<BudgetLine> effectLines(const Eigen::Vector3d& p, const LinearizedRecord& record,
                                                  const MeasuringChain& chain, double lagBound_s);
/// The position's counts, `step` apart, as far as rounding does not act as the white noise that the residuals
/// show it to be. A position y with noise of deviation s before it is rounded is off by a function of y,
///     sum_h q / (pi h) exp(-2 (pi h s / q)^2) sin(2 pi h y / q) (up to signs)
/// (Widrow and Kollar, Quantization Noise, 2008, ch. 4). Where the object lies on the lattice is anybody's
/// guess, so that its phases are even: with A' the influences (effect_regression.h) the covariance is
///     sum_h v_h (|sum_t A_t exp(2 pi i h y_t / q)|^2 - sum_t A_t A_t'),
///     v_h = q^2 / (2 pi^2 h^2) exp(-4 (pi h s / q)^2),
/// cut to its positive part; the second term is in the noise's line already. s^2 is what q^2 / 12 leaves of
/// the residuals' variance. Nothing from a noise of two fifths of a step on, which hides the counts.
[[nodiscard]] std::vector<BudgetLine> quantizationLines(const Estimate& estimate,
                                                        const LinearizedRecord& record, double step);
/// Samples that are taken beside their times err by as much as the position moves meanwhile: their noise
/// grows with the square of the speed v. Where the residuals do so beyond doubt (r^2 regressed on v^2, errors
/// of the slope t^2 after White 1980, p < 0.001) the covariance is t^2 sum_i (v_i^2 - mean v^2) A_i A_i', A
/// the influences (effect_regression.h), cut to its positive part: what the noise's line, which takes all
/// samples for equal, lacks.
[[nodiscard]] std::vector<BudgetLine> jitterLines(const Estimate& estimate, const LinearizedRecord& record);
/// What a unit of Coulomb friction adds to the position: the answer to the force -s(v), v the speed of the
/// estimate's own motion, to first order (no sticking).
[[nodiscard]] std::vector<double> frictionEffect(const Estimate& estimate, const LinearizedRecord& record,
                                                 double sampleTime_s);
/// Friction that nobody measured, `effect` what a unit of it adds to the position. With the friction f that
/// the residuals hold, of deviation s, all that is not below zero alike before (a normal distribution cut at
/// zero, its middle not below it): the estimate was moved by f times what the effect does to (ln m, ln b, ln
/// k), so that the covariance is E f^2 times its square. With two levels of force friction acts as stiffness
/// and s is large; with four it is small. `known`: what was measured of the gripper's own, which f and s are
/// then of both together, unless the record refutes it.
[[nodiscard]] std::vector<BudgetLine> hiddenFrictionLines(const Estimate& estimate,
                                                          const LinearizedRecord& record,
                                                          const std::vector<double>& effect,
                                                          const std::optional<GripperFriction>& known = {});
/// For an estimate with friction: it may begin to slide over some reach instead of at once (Bouc's and Wen's
/// z, reach z' = v - |v| z), which acts as more stiffness after each turn and takes less energy. What a reach
/// of a twentieth of the travel would do to (ln m, ln b, ln k), by its shape with the friction found anew and
/// by the energy that is lost to it, times the share of it that the residuals leave possible: a normal
/// distribution between 0 and 1, all shares alike before. Where the record cannot tell, a third of the
/// square.
[[nodiscard]] std::vector<BudgetLine> frictionFormLines(const Estimate& estimate,
                                                        const LinearizedRecord& record, double sampleTime_s);
/// The other hold of HoldEvidence, and a force that is smooth between its samples. `others`: the covariance
/// that all other lines add up to.
[[nodiscard]] std::vector<BudgetLine> holdLines(const Eigen::Vector3d& p,
                                                const std::optional<HoldAmbiguity>& hold, double coverage,
                                                const ModelMisfit& misfit, const Eigen::Matrix3d& others);
[[nodiscard]] std::vector<BudgetLine> calibrationLines(const Eigen::Vector3d& p, const MeasuringChain& chain);
[[nodiscard]] std::vector<BudgetLine> baselineLines(const GripperBaseline& baseline);
[[nodiscard]] std::vector<BudgetLine> discrepancyLines(const Eigen::Vector3d& p,
                                                       const std::optional<ModelDiscrepancy>& discrepancy,
                                                       const ModelMisfit& misfit);

} // namespace gripscope
