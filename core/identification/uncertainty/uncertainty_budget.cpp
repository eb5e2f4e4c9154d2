// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/uncertainty_budget.h"

#include "core/base/words.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Above this relative standard uncertainty a value has no digits to show.
constexpr double withoutDigits = 0.5;

void addUp(UncertaintyBudget& budget, bool mayBeLogarithmic)
{
    for (const BudgetLine& line : budget.lines)
        budget.covariance += line.covariance;
    const Eigen::Vector3d variances = budget.covariance.diagonal();
    for (BudgetLine& line : budget.lines) {
        for (Eigen::Index i = 0; i < 3; ++i)
            line.share(i) = variances(i) > 0 ? line.covariance(i, i) / variances(i) : 0;
    }
    const Eigen::Vector3d p = budget.parameters->vector();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        budget.combined[at] = budget.propagate(Eigen::Vector3d::Unit(i));
        budget.intervals[at] = intervalAround(p(i), budget.combined[at], mayBeLogarithmic);
    }
}

void append(std::vector<BudgetLine>& lines, std::vector<BudgetLine> more)
{
    for (BudgetLine& line : more) {
        if (line.covariance.allFinite())
            lines.push_back(std::move(line));
    }
}

} // namespace

CoverageInterval intervalAround(double value, const CombinedUncertainty& u, bool mayBeLogarithmic,
                                bool mayBeNegative)
{
    CoverageInterval interval;
    const double expanded = u.coverageFactor * u.standardUncertainty;
    const double relative = value > 0 ? u.standardUncertainty / value : std::numeric_limits<double>::max();
    interval.logarithmic = mayBeLogarithmic && relative <= withoutDigits;
    if (interval.logarithmic) {
        // Student's factor grows without limit for one degree of freedom, the exponential must not.
        const double exponent = std::min(expanded / value, 50.0);
        interval.lower = value * std::exp(-exponent);
        interval.upper = std::min(value * std::exp(exponent), std::numeric_limits<double>::max());
        return interval;
    }
    const double least = mayBeNegative ? std::numeric_limits<double>::lowest() : 0.0;
    interval.lower = std::max(value - expanded, least);
    interval.upper = std::clamp(value + expanded, least, std::numeric_limits<double>::max());
    interval.onlyUpperBound = !mayBeNegative && (relative > withoutDigits || interval.lower == 0);
    return interval;
}

double coverageFactor(double coverage, const std::optional<double>& degreesOfFreedom)
{
    const double tail = (1 - std::clamp(coverage, 0.0, 0.999999)) / 2;
    if (!degreesOfFreedom)
        return normalQuantileAbove(tail);
    return studentQuantileAbove(tail, std::max(*degreesOfFreedom, 1.0));
}

QString toString(EvaluationType type)
{
    return type == EvaluationType::A ? u"A"_s : u"B"_s;
}

Eigen::Vector3d BudgetLine::standardUncertainties() const
{
    return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

const BudgetLine* UncertaintyBudget::find(const QString& id) const
{
    const auto found =
        std::find_if(lines.begin(), lines.end(), [&](const BudgetLine& line) { return line.id == id; });
    return found != lines.end() ? &*found : nullptr;
}

CombinedUncertainty UncertaintyBudget::propagate(const Eigen::Vector3d& gradient) const
{
    CombinedUncertainty out;
    const auto varianceOf = [&](const Eigen::Matrix3d& c) { return gradient.dot(c * gradient); };
    const double total = varianceOf(covariance);
    if (!(total > 0) || !std::isfinite(total)) {
        out.coverageFactor = coverageFactor(coverage, std::nullopt);
        return out;
    }
    double quartic = 0; // sum of (u_i / u)^4 / nu_i
    for (const BudgetLine& line : lines) {
        if (!line.degreesOfFreedom)
            continue;
        // Of a combination the degrees of its parts, each counted as far as it moves the result.
        const Eigen::Vector3d weight =
            gradient.cwiseAbs2().cwiseProduct(line.covariance.diagonal()).cwiseMax(0.0);
        const double sum = weight.sum();
        const double inverse = sum > 0 ? weight.dot(line.degreesOfFreedom->cwiseInverse()) / sum : 0;
        const double share = std::max(varianceOf(line.covariance), 0.0) / total;
        quartic += share * share * inverse;
    }
    out.standardUncertainty = std::sqrt(total);
    if (quartic > 0)
        out.degreesOfFreedom = std::max(1 / quartic, 1.0);
    out.coverageFactor = coverageFactor(coverage, out.degreesOfFreedom);
    return out;
}

UncertaintyBudget uncertaintyBudget(const Estimate& estimate, const std::vector<double>& force,
                                    const std::vector<double>& position, const OutputErrorOptions& options,
                                    const MeasuringChain& chain, const BudgetOptions& budgetOptions)
{
    UncertaintyBudget budget;
    budget.coverage = budgetOptions.coverage;
    if (!estimate.parameters || !estimate.covariance || !estimate.covariance->allFinite() ||
        !(estimate.parameters->vector().minCoeff() > 0) || force.size() != position.size()) {
        budget.message = Words::say("there is no estimate with a covariance to start from");
        return budget;
    }
    const LinearizedRecord record = linearizedRecord(estimate, force, options);
    std::vector<std::vector<double>> known;
    if (chain.forceLagUncertainty_s > 0)
        known.push_back(record.velocity);
    if (chain.frameComplianceUncertainty > 0)
        known.push_back(record.forceAtSample);
    const bool hidesFriction = !budgetOptions.frictionIsKnown && record.usable();
    if (hidesFriction)
        known.push_back(frictionEffect(estimate, record, options.sampleTime_s));
    const ModelMisfit misfit = modelMisfit(estimate, record, force, options, known, !hidesFriction);
    const Eigen::Vector3d measured = estimate.parameters->vector();
    append(budget.lines, noiseLines(estimate, record, options, chain.forceNoiseDeviation));
    append(budget.lines, quantizationLines(estimate, record, budgetOptions.positionStep));
    append(budget.lines, jitterLines(estimate, record));
    append(budget.lines, effectLines(measured, record, chain, budgetOptions.lagBound_s));
    if (hidesFriction)
        append(budget.lines, hiddenFrictionLines(estimate, record, known.back(), chain.friction));
    append(budget.lines, frictionFormLines(estimate, record, options.sampleTime_s));
    append(budget.lines, discrepancyLines(measured, budgetOptions.discrepancy, misfit));

    Eigen::Vector3d own = measured;
    const bool withBaseline = chain.baseline && budgetOptions.subtractBaseline;
    if (withBaseline) {
        append(budget.lines, baselineLines(*chain.baseline));
        own -= Eigen::Vector3d::Map(chain.baseline->parameters.data());
    }
    append(budget.lines, calibrationLines(own, chain));
    Eigen::Matrix3d others = Eigen::Matrix3d::Zero();
    for (const BudgetLine& line : budget.lines)
        others += line.covariance;
    append(budget.lines, holdLines(measured, budgetOptions.hold, budgetOptions.coverage, misfit, others));
    const bool needsRecord = chain.forceLagUncertainty_s > 0 || budgetOptions.lagBound_s > 0 ||
                             chain.frameComplianceUncertainty > 0;
    if (needsRecord && budget.find(u"lag"_s) == nullptr && budget.find(u"frame_compliance"_s) == nullptr)
        budget.message = Words::say("what the lag and the frame's compliance do could not be computed");
    budget.parameters = MassDampingStiffness{own(0), own(1), own(2)};
    addUp(budget, !withBaseline);
    return budget;
}

} // namespace gripscope
