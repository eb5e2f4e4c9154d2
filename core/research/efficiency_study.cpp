// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/efficiency_study.h"

#include "core/base/parallel_runs.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/math/distributions.h"
#include "core/math/gaussian.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// What a run leaves behind.
struct Outcome {
    EstimateStatus status = EstimateStatus::NotApplicable;
    Eigen::Vector3d estimate = Eigen::Vector3d::Zero();
    Eigen::Vector3d standardError = Eigen::Vector3d::Zero();
    double degreesOfFreedom = 0;
};

Estimate estimateWith(Estimator estimator, const EfficiencySetting& setting, const std::vector<double>& force,
                      const std::vector<double>& position)
{
    if (!factsOf(estimator).assumesLinear)
        return {};
    PreparedRecord record;
    record.sampleTime_s = setting.sampleTime_s;
    record.force = force;
    record.position = position;
    EstimatorTask task;
    task.hold = ForceHold::Zero;
    return runEstimator(estimator, record, task);
}

/// The runs of all settings and estimators.
class Runs {
public:
    explicit Runs(const EfficiencyOptions& options)
        : m_options(options), m_runs(std::max(options.runs, 0)),
          m_total(static_cast<std::int64_t>(options.settings.size()) * m_runs)
    {
        for (const EfficiencySetting& setting : options.settings)
            m_experiments.push_back(makeExperiment(setting));
        m_outcomes.resize(static_cast<std::size_t>(m_total) * options.estimators.size());
    }

    void perform()
    {
        performRuns(m_total, m_options.threads, m_options.progress,
                    [this](std::int64_t run) { performOne(static_cast<std::size_t>(run)); });
    }

    [[nodiscard]] const EfficiencyExperiment& experiment(std::size_t setting) const
    {
        return m_experiments[setting];
    }
    [[nodiscard]] const Outcome& outcome(std::size_t setting, std::size_t estimator, int run) const
    {
        return m_outcomes[(setting * static_cast<std::size_t>(m_runs) + static_cast<std::size_t>(run)) *
                              m_options.estimators.size() +
                          estimator];
    }

private:
    void performOne(std::size_t index)
    {
        const std::size_t at = index / static_cast<std::size_t>(m_runs);
        const int run = static_cast<int>(index % static_cast<std::size_t>(m_runs));
        const EfficiencySetting& setting = m_options.settings[at];
        const EfficiencyExperiment& experiment = m_experiments[at];
        GaussianNoise noise(runSeed(m_options.seed, setting.name(), static_cast<std::uint64_t>(run)));
        std::vector<double> position = experiment.position;
        for (double& y : position)
            y += experiment.noiseDeviation * noise();
        for (std::size_t e = 0; e < m_options.estimators.size(); ++e) {
            const Estimate estimate =
                estimateWith(m_options.estimators[e], setting, experiment.force, position);
            Outcome& outcome = m_outcomes[index * m_options.estimators.size() + e];
            outcome.status = estimate.status;
            const std::optional<Eigen::Vector3d> errors = estimate.standardErrors();
            if (estimate.status != EstimateStatus::Converged || !estimate.parameters || !errors)
                continue;
            outcome.estimate = estimate.parameters->vector();
            outcome.standardError = *errors;
            outcome.degreesOfFreedom = estimate.residuals.degreesOfFreedom;
        }
    }

    const EfficiencyOptions& m_options;
    int m_runs;
    std::int64_t m_total;
    std::vector<EfficiencyExperiment> m_experiments;
    std::vector<Outcome> m_outcomes; ///< each element is written by one thread
};

/// Two-sided 95 % quantiles of Student's t, each found once.
class StudentQuantiles {
public:
    double operator()(double degreesOfFreedom)
    {
        const auto [at, isNew] = m_known.try_emplace(degreesOfFreedom, 0.0);
        if (isNew)
            at->second = studentQuantile(0.975, std::max(degreesOfFreedom, 1.0));
        return at->second;
    }

private:
    std::map<double, double> m_known;
};

SettingEfficiency summarize(const Runs& runs, const EfficiencyOptions& options, std::size_t setting,
                            std::size_t estimator, StudentQuantiles& quantiles)
{
    SettingEfficiency row;
    row.setting = options.settings[setting];
    row.experiment = runs.experiment(setting);
    row.experiment.force.clear();
    row.experiment.position.clear();
    row.estimator = options.estimators[estimator];
    row.runs = std::max(options.runs, 0);
    const Eigen::Vector3d truth = row.setting.truth.vector();
    Eigen::Vector3d errors = Eigen::Vector3d::Zero();
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    Eigen::Array3d covered = Eigen::Array3d::Zero();
    Eigen::Array3d logCovered = Eigen::Array3d::Zero();
    for (int run = 0; run < row.runs; ++run) {
        const Outcome& outcome = runs.outcome(setting, estimator, run);
        if (outcome.status != EstimateStatus::Converged || outcome.degreesOfFreedom <= 0) {
            ++row.failed[outcome.status];
            continue;
        }
        ++row.used;
        const double t = quantiles(outcome.degreesOfFreedom);
        const Eigen::Array3d error = outcome.estimate - truth;
        errors += error.matrix();
        squares += error.square().matrix();
        const Eigen::Array3d half = t * outcome.standardError.array();
        covered += (error.abs() <= half).cast<double>();
        const Eigen::Array3d logError = (outcome.estimate.array() / truth.array()).log().abs();
        logCovered += (logError * outcome.estimate.array() <= half).cast<double>();
    }
    const double used = std::max(row.used, 1);
    for (Eigen::Index i = 0; i < 3; ++i) {
        ParameterEfficiency& parameter = row.parameters[static_cast<std::size_t>(i)];
        parameter.truth = truth(i);
        parameter.bound = row.experiment.bound(i);
        parameter.bias = errors(i) / used;
        parameter.rootMeanSquareError = std::sqrt(squares(i) / used);
        parameter.ratio = parameter.bound > 0 ? parameter.rootMeanSquareError / parameter.bound : 0;
        parameter.coveragePercent = 100 * covered(i) / used;
        parameter.logCoveragePercent = 100 * logCovered(i) / used;
    }
    return row;
}

PooledEfficiency pool(const std::vector<SettingEfficiency>& rows, Estimator estimator)
{
    PooledEfficiency pooled;
    pooled.estimator = estimator;
    double squares = 0, count = 0;
    for (const SettingEfficiency& row : rows) {
        if (row.estimator != estimator)
            continue;
        pooled.runs += row.runs;
        pooled.used += row.used;
        for (std::size_t i = 0; row.used > 0 && i < row.parameters.size(); ++i) {
            const ParameterEfficiency& parameter = row.parameters[i];
            squares += parameter.ratio * parameter.ratio;
            ++count;
            const double weight = row.used;
            pooled.coveragePercent += weight * parameter.coveragePercent;
            pooled.logCoveragePercent += weight * parameter.logCoveragePercent;
            if (parameter.ratio > pooled.worstRatio) {
                pooled.worstRatio = parameter.ratio;
                pooled.worstSetting = row.setting.name();
                pooled.worstParameter = static_cast<int>(i);
            }
        }
    }
    const double intervals = std::max(3.0 * static_cast<double>(pooled.used), 1.0);
    pooled.ratio = count > 0 ? std::sqrt(squares / count) : 0;
    pooled.coveragePercent /= intervals;
    pooled.logCoveragePercent /= intervals;
    return pooled;
}

} // namespace

std::vector<Estimator> studiedEstimators()
{
    std::vector<Estimator> studied;
    studied.reserve(estimatorTable().size());
    for (const EstimatorFacts& facts : estimatorTable())
        if (facts.assumesLinear)
            studied.push_back(facts.estimator);
    return studied;
}

EfficiencyStudy studyEfficiency(const EfficiencyOptions& options)
{
    Runs runs(options);
    runs.perform();
    EfficiencyStudy study;
    StudentQuantiles quantiles;
    for (std::size_t setting = 0; setting < options.settings.size(); ++setting) {
        for (std::size_t estimator = 0; estimator < options.estimators.size(); ++estimator)
            study.rows.push_back(summarize(runs, options, setting, estimator, quantiles));
    }
    for (const Estimator estimator : options.estimators)
        study.pooled.push_back(pool(study.rows, estimator));
    return study;
}

} // namespace gripscope
