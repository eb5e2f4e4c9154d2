// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/recursive/recursive_estimator.h"

#include "core/identification/model/discretization.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t unknowns = 6;
/// Kept samples that the second pass reads for each new one: it catches up while the record grows by a third,
/// or by a fifteenth where the point is too far off for its step to be believed.
constexpr std::size_t readingSpeed = 4, hurriedReadingSpeed = 16;
/// A point this close to the optimum, in standard errors, is not moved.
constexpr double closeEnough = 0.05;
/// What curvature leaves of a linearised step, in standard errors, is about its length in standard errors
/// times the change of the logarithms. Below this it is believed.
constexpr double believable = 0.35, largestChange = 0.5;
/// A change that is nothing but rounding, where there is no noise.
constexpr double settledChange = 1e-8;
/// Damping after the first trial that fits worse.
constexpr double firstDamping = 1e-3, mostDamping = 1e6;
/// Relative error above which a start from the first samples is worth less than waiting.
constexpr double uselessError = 0.7;
/// Samples a new start is looked for in.
constexpr std::size_t mostStartSamples = 4000;

/// The way to go from the point to the optimum, in standard errors of the parameters.
double standardErrorsToGo(const RecursivePass::Solution& solution, std::size_t rows)
{
    const double gain = std::max(solution.cost - solution.costAtStep, 0.0);
    const double variance = solution.costAtStep / static_cast<double>(rows - unknowns);
    return variance > 0 ? std::sqrt(gain / variance) : (gain > 0 ? 1e300 : 0);
}

bool isBelievable(const RecursivePass::Solution& solution, std::size_t rows)
{
    if (!solution.determined)
        return false;
    const double change = solution.step.cwiseAbs().maxCoeff();
    return change < settledChange ||
           (change < largestChange && standardErrorsToGo(solution, rows) * change < believable);
}

} // namespace

QString toString(RecursiveStatus status)
{
    switch (status) {
    case RecursiveStatus::Waiting:
        return u"waiting"_s;
    case RecursiveStatus::Searching:
        return u"searching"_s;
    case RecursiveStatus::Following:
        return u"following"_s;
    }
    return {};
}

RecursiveEstimator::RecursiveEstimator(const RecursiveOptions& options)
    : m_options(options), m_lag(options.lag_s, options.sampleTime_s), m_delay(m_lag, options.hold)
{
    m_options.startSamples = std::clamp<std::size_t>(m_options.startSamples, 2 * unknowns, mostStartSamples);
    m_options.keptSamples = std::max(m_options.keptSamples, m_options.startSamples);
    m_nextStart = m_options.startSamples;
    m_kept.reserve(std::min<std::size_t>(m_options.keptSamples, mostStartSamples));
}

void RecursiveEstimator::update(double force, double position)
{
    if (!(m_options.sampleTime_s > 0) || !std::isfinite(m_options.sampleTime_s))
        return;
    if (std::isfinite(force))
        m_lastForce = force;
    const bool lost = !std::isfinite(force) || !std::isfinite(position);
    ++m_samples;
    const std::optional<Sample> sample =
        m_delay.push(m_lastForce, lost ? std::numeric_limits<double>::quiet_NaN() : position);
    if (sample)
        follow(*sample);
}

void RecursiveEstimator::follow(const Sample& sample)
{
    if (m_followed == 0 && std::isfinite(sample.position))
        m_shift = sample.position;
    if (wholeRecordKept() && m_kept.size() < m_options.keptSamples)
        m_kept.push_back(sample);
    if (m_pass.usable())
        m_pass.add(sample.forces, sample.position - m_shift);
    ++m_followed;
    if (m_followed == m_nextStart && wholeRecordKept())
        tryToStart();
    if (m_trial.usable()) {
        read(m_trial, m_hurry ? hurriedReadingSpeed : readingSpeed);
        if (m_trial.samples() == m_followed)
            judgeTrial();
    } else if (m_pass.usable() && m_followed >= m_nextTrial && wholeRecordKept()) {
        launchTrial();
    }
}

/// The next `most` kept samples.
void RecursiveEstimator::read(RecursivePass& pass, std::size_t most) const
{
    std::size_t at = pass.samples();
    const std::size_t end = std::min(m_kept.size(), at + most);
    for (; at < end; ++at)
        pass.add(m_kept[at].forces, m_kept[at].position - m_shift);
}

RecursivePass::Point RecursiveEstimator::inSamples(const Estimate& estimate) const
{
    const double time = std::log(m_options.sampleTime_s);
    const MassDampingStiffness& p = *estimate.parameters;
    RecursivePass::Point point;
    point.theta << std::log(p.m) - 2 * time, std::log(p.b) - time, std::log(p.k);
    // The batch has its start at the first force's time, a pass at the first position's.
    const double force = m_kept.front().forces.now;
    const double end = force + m_lag.rest * (m_kept.front().forces.next - force);
    const ExactStep<2> step = discretize(p, m_lag.rest * m_options.sampleTime_s, m_options.hold);
    const Eigen::Vector2d start(estimate.nuisance.x0.value_or(0), estimate.nuisance.v0.value_or(0));
    const Eigen::Vector2d state = step.phi * start + step.gamma0 * force + step.gamma1 * end;
    point.nuisance << state(0), state(1) * m_options.sampleTime_s,
        estimate.nuisance.offset.value_or(m_shift) - m_shift;
    return point;
}

/// Output error on the samples so far, or on the first of them, unless there is a point that will do.
void RecursiveEstimator::tryToStart()
{
    m_nextStart = m_followed + m_followed / 2;
    if (m_pass.usable() && isBelievable(m_pass.solve(0), m_pass.rows()))
        return;
    std::vector<double> force, position;
    for (const Sample& sample : std::span(m_kept).first(std::min(m_kept.size(), mostStartSamples))) {
        force.push_back(sample.forces.now);
        const bool measured = std::isfinite(sample.position);
        position.push_back(measured ? sample.position : (position.empty() ? m_shift : position.back()));
    }
    OutputErrorOptions options;
    options.sampleTime_s = m_options.sampleTime_s;
    options.hold = m_options.hold;
    options.lag_s = m_lag.rest * m_options.sampleTime_s;
    options.maxIterations = 40;
    options.start = m_options.start;
    Estimate found = estimateOutputError(force, position, options);
    if (options.start && found.status != EstimateStatus::Converged) {
        options.start.reset();
        found = estimateOutputError(force, position, options);
    }
    const std::optional<Eigen::Vector3d> errors = found.standardErrors();
    if (found.status != EstimateStatus::Converged || !errors ||
        !(errors->cwiseQuotient(found.parameters->vector()).maxCoeff() < uselessError))
        return;
    m_trial = RecursivePass();
    m_pass = RecursivePass(inSamples(found), m_options.hold, m_lag.rest);
    if (m_pass.usable())
        read(m_pass, m_kept.size());
    m_damping = 0;
    m_nextTrial = m_followed + 1;
}

void RecursiveEstimator::launchTrial()
{
    // Solving is dearer than counting in; looking now and then is enough.
    m_nextTrial = m_followed + 8;
    if (m_pass.rows() <= unknowns)
        return;
    const RecursivePass::Solution solution = m_pass.solve(m_damping);
    if (!solution.determined || standardErrorsToGo(solution, m_pass.rows()) < closeEnough)
        return;
    const double longest = solution.step.cwiseAbs().maxCoeff();
    const double cut = std::min(1.0, search::longestStep / std::max(longest, 1e-300));
    RecursivePass::Point point = m_pass.point();
    point.theta += cut * solution.step;
    // The start and the offset come along, as far as the problem is linear.
    point.nuisance += cut * solution.nuisanceStep;
    m_trial = RecursivePass(point, m_options.hold, m_lag.rest);
    m_hurry = m_damping > 0 || !isBelievable(solution, m_pass.rows());
}

/// The trial has seen what the other pass has: the one that fits better stays.
void RecursiveEstimator::judgeTrial()
{
    const double now = m_pass.solve(0).cost;
    const double then = m_trial.solve(0).cost;
    // Where both are at the optimum, rounding must not decide.
    if (then < now * (1 + settledChange)) {
        m_pass = m_trial;
        m_damping = m_damping > firstDamping ? m_damping / 10 : 0;
    } else {
        m_damping = std::min(std::max(m_damping * 10, firstDamping), mostDamping);
    }
    m_trial = RecursivePass();
    m_nextTrial = m_followed + 1;
}

RecursiveState RecursiveEstimator::state() const
{
    RecursiveState state;
    state.samples = m_samples;
    if (!m_pass.usable() || m_pass.rows() <= unknowns)
        return state;
    const RecursivePass::Solution solution = m_pass.solve(0);
    const bool follows = solution.determined && isBelievable(solution, m_pass.rows());
    const Eigen::Vector3d theta =
        follows ? Eigen::Vector3d(m_pass.point().theta + solution.step) : m_pass.point().theta;
    const Eigen::Vector3d nuisance =
        follows ? Eigen::Vector3d(m_pass.point().nuisance + solution.nuisanceStep) : m_pass.point().nuisance;
    const double time = m_options.sampleTime_s;
    const Eigen::Vector3d p(std::exp(theta(0)) * time * time, std::exp(theta(1)) * time, std::exp(theta(2)));
    if (!p.allFinite() || !(p.minCoeff() > 0) || !nuisance.allFinite())
        return state;
    state.parameters = {p(0), p(1), p(2)};
    state.nuisance.x0 = nuisance(0);
    state.nuisance.v0 = nuisance(1) / time;
    state.nuisance.offset = nuisance(2) + m_shift;
    state.status = RecursiveStatus::Searching;
    const double variance = solution.costAtStep / static_cast<double>(m_pass.rows() - unknowns);
    if (!follows || !std::isfinite(variance))
        return state;
    state.noiseDeviation = std::sqrt(variance);
    const Eigen::Matrix3d covariance = variance * (p.asDiagonal() * solution.inverse * p.asDiagonal());
    if (!covariance.allFinite())
        return state;
    state.covariance = covariance;
    state.status = RecursiveStatus::Following;
    return state;
}

} // namespace gripscope
