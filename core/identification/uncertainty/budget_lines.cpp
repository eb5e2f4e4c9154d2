// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/budget_lines.h"

#include "core/base/words.h"
#include "core/math/decompositions.h"
#include "core/math/distributions.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Finding budgetPercent(double share)
{
    return Finding::number(100 * share, 'g', 2);
}

/// Values within +-a, all alike (JCGM 100, 4.3.7): a shift that may be there wholly, in part or not at all.
Eigen::Matrix3d rectangular(const Eigen::Vector3d& shift)
{
    return shift * shift.transpose() / 3;
}

/// How far `other` is from p, relative: as a share or as a logarithm, whichever is more, so that an interval
/// of either kind reaches it.
Eigen::Vector3d relativeShift(const Eigen::Vector3d& p, const Eigen::Vector3d& other)
{
    const Eigen::Array3d ratio = other.cwiseQuotient(p);
    const Eigen::Array3d logarithm = ratio.max(1e-12).log();
    return (logarithm.abs() > (ratio - 1).abs()).select(logarithm, ratio - 1);
}

/// The standard deviations, with the signs of `shift`, that make the interval of a normal quantity with
/// variance `known` reach the same quantity moved by `shift`, which is true with `probability`; see
/// uncertaintyBudget().
Eigen::Vector3d reachingDeviations(const Eigen::Vector3d& shift, const Eigen::Vector3d& known,
                                   double probability, double coverage)
{
    const double tail = (1 - std::clamp(coverage, 0.0, 0.999999)) / 2;
    Eigen::Vector3d deviations = Eigen::Vector3d::Zero();
    if (!(probability > tail))
        return deviations;
    const double factor = normalQuantileAbove(tail);
    const double beyond = normalQuantileAbove(tail / probability);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double half = std::abs(shift(i)) + beyond * std::sqrt(std::max(known(i), 0.0));
        const double wanted = half > 0 ? std::pow(half / factor, 2) : 0;
        deviations(i) = std::copysign(std::sqrt(std::max(wanted - known(i), 0.0)), shift(i));
    }
    return deviations;
}

} // namespace

Eigen::Matrix3d positivePart(const Eigen::Matrix3d& symmetric, const Eigen::Vector3d& scale)
{
    const Eigen::Vector3d inverse = scale.cwiseInverse();
    const SymmetricAxes solver = symmetricAxes(inverse.asDiagonal() * symmetric * inverse.asDiagonal());
    const Eigen::Matrix3d vectors = scale.asDiagonal() * solver.directions;
    return vectors * solver.values.cwiseMax(0.0).asDiagonal() * vectors.transpose();
}

BudgetLine lineOf(const QString& id, const Finding& words, EvaluationType type, const Eigen::Vector3d& p,
                  const Eigen::Matrix3d& relative)
{
    BudgetLine line;
    line.id = id;
    line.words = words;
    line.type = type;
    line.covariance = p.asDiagonal() * relative * p.asDiagonal();
    return line;
}

std::vector<BudgetLine> effectLines(const Eigen::Vector3d& p, const LinearizedRecord& record,
                                    const MeasuringChain& chain, double lagBound_s)
{
    std::vector<BudgetLine> lines;
    const Eigen::Matrix3Xd shifts =
        shiftsBy(record, std::vector<std::vector<double>>{record.velocity, record.forceAtSample});
    if (shifts.cols() != 2)
        return lines;
    if (chain.forceLagUncertainty_s > 0) {
        const Eigen::Vector3d shift = shifts.col(0) * chain.forceLagUncertainty_s;
        lines.push_back(lineOf(u"lag"_s,
                               Words::say("the lag between the channels is known to %1 us")
                                   .arg(chain.forceLagUncertainty_s * 1e6, 'g', 3),
                               EvaluationType::B, p, shift * shift.transpose()));
    } else if (lagBound_s > 0) {
        lines.push_back(lineOf(u"lag"_s,
                               Words::say("the lag between the channels was never measured: it is taken to "
                                          "be within %1 us of what is assumed, a tenth of the sample time")
                                   .arg(lagBound_s * 1e6, 'g', 3),
                               EvaluationType::B, p, rectangular(shifts.col(0) * lagBound_s)));
    }
    if (chain.frameComplianceUncertainty > 0) {
        const Eigen::Vector3d shift = shifts.col(1) * chain.frameComplianceUncertainty;
        const double share = chain.frameComplianceUncertainty * p(2);
        lines.push_back(
            lineOf(u"frame_compliance"_s,
                   Words::say("the compliance of frame and fingers is known to %1 % of the object's")
                       .arg(budgetPercent(share)),
                   EvaluationType::B, p, shift * shift.transpose()));
    }
    return lines;
}

std::vector<BudgetLine> holdLines(const Eigen::Vector3d& p, const std::optional<HoldAmbiguity>& hold,
                                  double coverage, const ModelMisfit& misfit, const Eigen::Matrix3d& others)
{
    std::vector<BudgetLine> lines;
    Eigen::Matrix3d relative = Eigen::Matrix3d::Zero();
    Findings words;
    for (const MissingTerm& term : misfit.terms) {
        if (term.id != u"smooth_force"_s)
            continue;
        relative += rectangular(term.shift);
        words.push_back(Words::say("the residuals ask for %1: m would be %2 % away")
                            .arg(term.words, budgetPercent(std::abs(term.shift(0)))));
    }
    if (hold) {
        const Eigen::Vector3d shift = relativeShift(p, hold->other.vector());
        const Eigen::Vector3d known = relative.diagonal() + others.diagonal().cwiseQuotient(p.cwiseAbs2());
        const Eigen::Vector3d more = reachingDeviations(shift, known, hold->probability, coverage);
        relative += more * more.transpose();
        if (!more.isZero(0))
            words.insert(
                words.begin(),
                Words::say(
                    "it is not certain how the force is held between samples: the other way m would be "
                    "%1 % away")
                    .arg(budgetPercent(std::abs(shift(0)))));
    }
    if (relative.allFinite() && relative.trace() > 0)
        lines.push_back(lineOf(u"hold"_s, Finding::joined(words, u"; "_s), EvaluationType::B, p, relative));
    return lines;
}

std::vector<BudgetLine> calibrationLines(const Eigen::Vector3d& p, const MeasuringChain& chain)
{
    const double force = chain.forceScaleUncertainty;
    const double position = chain.positionScaleUncertainty;
    if (!(force > 0) && !(position > 0))
        return {};
    const double variance = force * force + position * position;
    return {lineOf(u"calibration"_s,
                   Words::say("the scales of force and position are known to %1 % and %2 %")
                       .arg(budgetPercent(force), budgetPercent(position)),
                   EvaluationType::B, p, Eigen::Matrix3d::Constant(variance))};
}

std::vector<BudgetLine> baselineLines(const GripperBaseline& baseline)
{
    BudgetLine line;
    line.id = u"baseline"_s;
    line.words = Words::say("the empty gripper's own m, b and k, which were taken off");
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double error = baseline.standardErrors[static_cast<std::size_t>(i)];
        line.covariance(i, i) = error * error;
    }
    return {line};
}

std::vector<BudgetLine> discrepancyLines(const Eigen::Vector3d& p,
                                         const std::optional<ModelDiscrepancy>& discrepancy,
                                         const ModelMisfit& misfit)
{
    Findings words;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    for (const MissingTerm& term : misfit.terms) {
        if (term.id == u"smooth_force"_s)
            continue;
        shift += term.shift;
        words.push_back(Words::say("the residuals ask for %1").arg(term.words));
    }
    Eigen::Matrix3d relative = misfit.remainder + rectangular(shift);
    if (misfit.remainder.trace() > 0)
        words.push_back(
            Words::say("the force explains a part of the residuals that the model does not have"));
    // Welch-Satterthwaite within the line.
    Eigen::Vector3d quartic = Eigen::Vector3d::Zero();
    if (misfit.remainderDegreesOfFreedom > 0)
        quartic += misfit.remainder.diagonal().cwiseAbs2() / misfit.remainderDegreesOfFreedom;
    if (discrepancy && discrepancy->found()) {
        relative += discrepancy->covariance;
        quartic +=
            discrepancy->covariance.diagonal().cwiseAbs2().cwiseQuotient(discrepancy->degreesOfFreedom);
        words.push_back(discrepancy->words);
    }
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    BudgetLine line =
        lineOf(u"model_discrepancy"_s, Finding::joined(words, u"; "_s), EvaluationType::A, p, relative);
    const Eigen::Vector3d degrees = relative.diagonal().cwiseAbs2().cwiseQuotient(quartic);
    if (degrees.allFinite())
        line.degreesOfFreedom = degrees.cwiseMax(1.0);
    return {line};
}

} // namespace gripscope
