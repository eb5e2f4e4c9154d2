// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/comparison/hold_evidence.h"

#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/model/lag_alignment.h"
#include "core/identification/noise/noise_model.h"
#include "core/math/decompositions.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double clearHoldGain = 10;
/// Mean 10 less 1.645 times sqrt(20): 95 % of the gains are above it when the expected gain is 10.
constexpr double enoughGain = 2.5;
/// A little less than 10, since it is known from the noise found, not exactly.
constexpr double tellableGain = 8;
/// A lag known no better than this share of a sample time: nothing can be told, and its effect is not linear.
constexpr double uselessLag = 0.5;

ForceHold otherThan(ForceHold hold)
{
    return hold == ForceHold::Zero ? ForceHold::First : ForceHold::Zero;
}

/// Simulations around an estimate, and differences of them.
class Neighbourhood {
public:
    Neighbourhood(const std::vector<double>& force, const OutputErrorOptions& options, const Estimate& oe)
        : m_force(force), m_rest(force.size(), 0.0), m_options(options), m_estimate(oe)
    {
    }
    /// x0, v0, offset (those that are free), ln m, ln b, ln k and, last, the lag.
    [[nodiscard]] Eigen::MatrixXd rows() const
    {
        std::vector<std::vector<double>> all;
        const MassDampingStiffness& p = *m_estimate.parameters;
        if (m_options.freeInitialState) {
            all.push_back(simulate(p, m_rest, at(1, 0)));
            all.push_back(simulate(p, m_rest, at(0, 1 / m_options.sampleTime_s)));
        }
        if (m_options.freeOffset)
            all.emplace_back(m_force.size(), 1.0);
        constexpr double step = 1e-4; // relative: the truncation is its square, rounding 1e-12
        all.push_back(slope({p.m * (1 + step), p.b, p.k}, {p.m * (1 - step), p.b, p.k}, 0));
        all.push_back(slope({p.m, p.b * (1 + step), p.k}, {p.m, p.b * (1 - step), p.k}, 0));
        all.push_back(slope({p.m, p.b, p.k * (1 + step)}, {p.m, p.b, p.k * (1 - step)}, 0));
        all.push_back(slope(p, p, 1e-3 * m_options.sampleTime_s));
        Eigen::MatrixXd rows(static_cast<Eigen::Index>(all.size()),
                             static_cast<Eigen::Index>(m_force.size()));
        for (std::size_t i = 0; i < all.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)) =
                Eigen::Map<const Eigen::RowVectorXd>(all[i].data(), rows.cols());
        // Per second, so that the prior's width is one too.
        rows.bottomRows(1) /= 2e-3 * m_options.sampleTime_s;
        return rows;
    }

private:
    [[nodiscard]] SimulationOptions at(double x0, double v0) const
    {
        return {m_options.sampleTime_s, m_options.hold, m_options.lag_s, x0, v0, 0};
    }
    [[nodiscard]] std::vector<double> slope(const MassDampingStiffness& above,
                                            const MassDampingStiffness& below, double lag) const
    {
        SimulationOptions options =
            at(m_estimate.nuisance.x0.value_or(0), m_estimate.nuisance.v0.value_or(0));
        options.lag_s = m_options.lag_s + lag;
        std::vector<double> difference = simulate(above, m_force, options);
        options.lag_s = m_options.lag_s - lag;
        const std::vector<double> other = simulate(below, m_force, options);
        for (std::size_t t = 0; t < difference.size(); ++t)
            difference[t] -= other[t];
        return difference;
    }

    const std::vector<double>& m_force;
    std::vector<double> m_rest;
    const OutputErrorOptions& m_options;
    const Estimate& m_estimate;
};

/// Samples [first, end) at which both holds say where the object is, whatever a small change of the lag.
struct Range {
    Eigen::Index first = 0, count = 0;
    Range(std::size_t samples, const OutputErrorOptions& options)
    {
        const LagAlignment lag(options.lag_s, options.sampleTime_s);
        const auto all = static_cast<std::ptrdiff_t>(samples);
        const std::ptrdiff_t whole = std::clamp<std::ptrdiff_t>(lag.samples, -all, all);
        first = std::max<std::ptrdiff_t>(-whole, 0) + 1;
        count = std::max<std::ptrdiff_t>(std::min(all - whole, all) - 1 - first, 0);
    }
};

Eigen::RowVectorXd toRow(const std::vector<double>& values)
{
    return Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The noise that both holds are held against: that of the better fit, its innovations no smaller than
/// rounding.
AutoregressiveNoise commonNoise(const Estimate& oe, const Estimate& other, double largest)
{
    const Estimate& better = other.residuals.sse < oe.residuals.sse ? other : oe;
    AutoregressiveNoise noise = better.noise.value_or(AutoregressiveNoise());
    if (!better.noise)
        noise.innovationDeviation =
            std::sqrt(better.residuals.sse / std::max(better.residuals.degreesOfFreedom, 1.0));
    noise.innovationDeviation = std::max(noise.innovationDeviation, roundingShare * largest);
    return noise;
}

/// Gain and expected gain of the sums; none where they are no numbers.
void evaluate(HoldEvidence& evidence)
{
    const HoldSums& sums = evidence.sums;
    const double ridge = 1 + sums.lag;
    const double squared = std::max(sums.difference - sums.lagDifference * (sums.lagDifference / ridge), 0.0);
    const double cross = sums.residual - sums.lagResidual * (sums.lagDifference / ridge);
    if (!std::isfinite(squared) || !std::isfinite(cross) || !std::isfinite(ridge)) {
        evidence.gain.reset();
        evidence.expectedGain = 0;
        return;
    }
    evidence.expectedGain = squared / 2;
    evidence.gain = cross - squared / 2;
}

} // namespace

double HoldEvidence::otherProbability() const
{
    return 1 / (1 + std::exp(-gain.value_or(0)));
}

double HoldEvidence::limit() const
{
    return expectedGain > tellableGain ? enoughGain : clearHoldGain;
}

bool HoldEvidence::declaresAs(const HoldEvidence& other) const
{
    return declared == other.declared && lag_s == other.lag_s && lagUncertainty_s == other.lagUncertainty_s;
}

HoldVerdict HoldEvidence::verdict() const
{
    if (!gain)
        return HoldVerdict::NotJudged;
    if (*gain > limit())
        return HoldVerdict::Contradicts;
    return expectedGain > tellableGain ? HoldVerdict::Agrees : HoldVerdict::Ambiguous;
}

Estimate estimateOtherHold(const std::vector<double>& force, const std::vector<double>& position,
                           const OutputErrorOptions& options, const Estimate& oe)
{
    if (oe.status != EstimateStatus::Converged || !oe.parameters)
        return oe;
    OutputErrorOptions otherOptions = options;
    otherOptions.hold = otherThan(options.hold);
    otherOptions.start = oe.parameters;
    return estimateBeside(oe, force, position, otherOptions);
}

HoldEvidence weighHolds(const std::vector<double>& force, const OutputErrorOptions& options,
                        const Estimate& oe, const Estimate& other, double lagUncertainty_s)
{
    HoldEvidence evidence;
    evidence.declared = options.hold;
    evidence.lag_s = options.lag_s;
    evidence.lagUncertainty_s = lagUncertainty_s;
    const Range range(force.size(), options);
    if (oe.status != EstimateStatus::Converged || other.status != EstimateStatus::Converged ||
        !oe.parameters || !other.parameters || oe.residual.size() != force.size() ||
        other.residual.size() != force.size() || range.count < 10)
        return evidence;
    OutputErrorOptions otherOptions = options;
    otherOptions.hold = otherThan(options.hold);
    evidence.parameters = oe.parameters;
    evidence.otherParameters = other.parameters;
    if (!(lagUncertainty_s < uselessLag * options.sampleTime_s)) {
        evidence.gain = 0;
        evidence.squeezes = 1;
        return evidence;
    }

    // In units of the largest position, so that squares neither overflow nor vanish.
    const Eigen::RowVectorXd model = toRow(oe.simulated);
    const double largest = (model.array() - model.mean()).abs().maxCoeff();
    if (!(largest > 0) || !std::isfinite(largest) || !std::isfinite(1 / largest))
        return evidence;
    AutoregressiveNoise noise = commonNoise(oe, other, largest);
    const double unit = noise.innovationDeviation;
    noise.innovationDeviation = 1;
    // Half way between the two models, where both are equally far and their difference is linear to third
    // order.
    Eigen::MatrixXd rows =
        (Neighbourhood(force, options, oe).rows() + Neighbourhood(force, otherOptions, other).rows()) / 2;
    Eigen::MatrixXd pair(2, rows.cols());
    pair.row(0) = toRow(oe.residual);
    pair.row(1) = toRow(oe.residual) - toRow(other.residual);
    for (const std::size_t lost : options.lost) {
        if (static_cast<Eigen::Index>(lost) < rows.cols()) {
            rows.col(static_cast<Eigen::Index>(lost)).setZero();
            pair.col(static_cast<Eigen::Index>(lost)).setZero();
        }
    }
    rows = whitened(rows.middleCols(range.first, range.count), noise);
    pair = whitened(pair.middleCols(range.first, range.count) / unit, noise);
    const Eigen::Index parameters = rows.rows() - 1;
    const OrthonormalRows known = orthonormalize(rows.topRows(parameters), {});
    const auto project = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
        return values - (values * known.basis.transpose()) * known.basis;
    };
    const Eigen::MatrixXd left = project(pair);
    const Eigen::RowVectorXd velocity = project(rows.bottomRows(1)) * (lagUncertainty_s / unit);
    const Eigen::RowVectorXd e = left.row(0);
    const Eigen::RowVectorXd d = left.row(1);
    evidence.sums = {d.squaredNorm(), e.dot(d), velocity.squaredNorm(), velocity.dot(d), velocity.dot(e)};
    evaluate(evidence);
    evidence.squeezes = evidence.gain ? 1 : 0;
    return evidence;
}

HoldEvidence combine(std::span<const HoldEvidence> squeezes)
{
    HoldEvidence all;
    if (squeezes.empty())
        return all;
    const HoldEvidence& last = squeezes.back();
    all.declared = last.declared;
    all.lag_s = last.lag_s;
    all.lagUncertainty_s = last.lagUncertainty_s;
    all.parameters = last.parameters;
    all.otherParameters = last.otherParameters;
    for (const HoldEvidence& one : squeezes) {
        if (!one.gain || !one.declaresAs(last))
            continue;
        all.sums.difference += one.sums.difference;
        all.sums.residual += one.sums.residual;
        all.sums.lag += one.sums.lag;
        all.sums.lagDifference += one.sums.lagDifference;
        all.sums.lagResidual += one.sums.lagResidual;
        all.squeezes += one.squeezes;
    }
    if (all.squeezes > 0)
        evaluate(all);
    return all;
}

} // namespace gripscope
