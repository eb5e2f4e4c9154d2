// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/model_efficiency.h"

#include "core/base/parallel_runs.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/motion/expected_deviations.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;

/// What a run leaves behind, in the order of the parameters.
struct ModelOutcome {
    EstimateStatus status = EstimateStatus::NotApplicable;
    std::vector<double> errors, bounds;
    std::vector<bool> covered;
    bool limited = false; ///< friction is not above its limit
};

/// Of the estimator, so that friction that is zero in truth is among them.
MotionTerms termsOf(Estimator estimator)
{
    return motionTermsOf(estimator).value_or(MotionTerms());
}

PreparedRecord recordOf(const Recording& squeeze)
{
    PreparedRecord record;
    record.sampleTime_s = squeeze.sampleTime_s;
    record.force = squeeze.force;
    record.position = squeeze.position;
    return record;
}

ModelOutcome modelOutcomeOf(const ModelSetting& setting, std::uint64_t seed)
{
    constexpr double twoSided95 = 0.975;
    const Recording squeeze = drawSqueeze(setting.squeeze, seed);
    const MotionTerms terms = termsOf(setting.estimator);
    const MotionValues truth = valuesOf(setting.squeeze.part);
    ModelOutcome outcome;
    const auto bounds = expectedDeviations(terms, truth,
                                           {squeeze.force, setting.squeeze.bias, squeeze.sampleTime_s,
                                            ForceHold::Zero, setting.squeeze.noise_m});
    EstimatorTask task;
    task.hold = ForceHold::Zero;
    const Estimate estimate = runEstimator(setting.estimator, recordOf(squeeze), task);
    outcome.status = estimate.status;
    const std::optional<MotionEstimate> motion = motionOf(estimate);
    if (!bounds || !motion || estimate.status != EstimateStatus::Converged)
        return outcome;
    outcome.bounds = *bounds;
    const double t = studentQuantile(twoSided95, std::max(1.0, estimate.residuals.degreesOfFreedom));
    for (const P parameter : terms.parameters()) {
        const double error = motion->values[parameter] - truth[parameter];
        outcome.errors.push_back(error);
        outcome.covered.push_back(std::abs(error) <= t * motion->standardError(parameter).value_or(0));
    }
    outcome.limited = motion->frictionLimit.value_or(0) >= truth[P::Friction];
    return outcome;
}

double percentOfAll(double part, double whole)
{
    return whole > 0 ? 100 * part / whole : 0;
}

void addParameter(ModelEfficiencyRow& row, P parameter, std::size_t at,
                  std::span<const ModelOutcome> outcomes)
{
    ModelParameterEfficiency out;
    out.parameter = parameter;
    out.truth = valuesOf(row.setting.squeeze.part)[parameter];
    double ratios = 0;
    double bounds = 0;
    double covered = 0;
    for (const ModelOutcome& outcome : outcomes) {
        if (outcome.errors.empty())
            continue;
        const double ratio = outcome.errors[at] / outcome.bounds[at];
        ratios += ratio * ratio;
        bounds += outcome.bounds[at] * outcome.bounds[at];
        covered += outcome.covered[at] ? 1 : 0;
    }
    const double used = std::max(row.used, 1);
    out.bound = std::sqrt(bounds / used);
    out.ratio = std::sqrt(ratios / used);
    out.coveragePercent = percentOfAll(covered, row.used);
    row.parameters.push_back(out);
}

ModelEfficiencyRow summarize(const ModelSetting& setting, std::span<const ModelOutcome> outcomes)
{
    constexpr double farFromZero = 5;
    ModelEfficiencyRow row;
    row.setting = setting;
    row.runs = static_cast<int>(outcomes.size());
    int limited = 0;
    for (const ModelOutcome& outcome : outcomes) {
        if (outcome.errors.empty()) {
            ++row.failed[outcome.status];
            continue;
        }
        ++row.used;
        limited += outcome.limited ? 1 : 0;
    }
    const MotionTerms terms = termsOf(setting.estimator);
    const std::vector<P> parameters = terms.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i)
        addParameter(row, parameters[i], i, outcomes);
    if (terms.friction)
        row.limitPercent = percentOfAll(limited, row.used);
    for (const ModelParameterEfficiency& one : row.parameters)
        row.nearZero |= one.parameter == P::Friction && one.truth < farFromZero * one.bound;
    return row;
}

PooledModelEfficiency pool(const std::vector<ModelEfficiencyRow>& rows, Estimator estimator)
{
    PooledModelEfficiency pooled;
    pooled.estimator = estimator;
    double squares = 0;
    double count = 0;
    double covered = 0;
    double intervals = 0;
    double limited = 0;
    double limits = 0;
    for (const ModelEfficiencyRow& row : rows) {
        if (row.setting.estimator != estimator)
            continue;
        pooled.runs += row.runs;
        pooled.used += row.used;
        limited += row.limitPercent * row.used;
        limits += row.used;
        if (row.nearZero || row.used == 0)
            continue;
        for (const ModelParameterEfficiency& parameter : row.parameters) {
            squares += parameter.ratio * parameter.ratio;
            ++count;
            covered += parameter.coveragePercent * row.used;
            intervals += row.used;
        }
    }
    pooled.ratio = count > 0 ? std::sqrt(squares / count) : 0;
    pooled.coveragePercent = intervals > 0 ? covered / intervals : 0;
    if (termsOf(estimator).friction && limits > 0)
        pooled.limitPercent = limited / limits;
    return pooled;
}

} // namespace

ModelEfficiencyStudy studyModelEfficiency(const ModelEfficiencyOptions& options)
{
    const auto runs = static_cast<std::size_t>(std::max(options.runs, 0));
    std::vector<ModelOutcome> outcomes(options.settings.size() *
                                       runs); // each element is written by one thread
    performRuns(static_cast<std::int64_t>(outcomes.size()), options.threads, options.progress,
                [&](std::int64_t at) {
                    const auto index = static_cast<std::size_t>(at);
                    const ModelSetting& setting = options.settings[index / runs];
                    outcomes[index] =
                        modelOutcomeOf(setting, runSeed(options.seed, setting.squeeze.name, index % runs));
                });
    ModelEfficiencyStudy study;
    for (std::size_t i = 0; i < options.settings.size(); ++i)
        study.rows.push_back(summarize(options.settings[i], std::span(outcomes).subspan(i * runs, runs)));
    for (const ModelEfficiencyRow& row : study.rows) {
        const Estimator estimator = row.setting.estimator;
        const bool known = std::ranges::any_of(
            study.pooled, [&](const PooledModelEfficiency& one) { return one.estimator == estimator; });
        if (!known)
            study.pooled.push_back(pool(study.rows, estimator));
    }
    return study;
}

} // namespace gripscope
