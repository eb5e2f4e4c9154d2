// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early/early_decision.h"

#include "core/recognition/early/stranger_search.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace gripscope {

namespace {

constexpr std::array colouredPoles{-0.4, -0.2, 0.0, 0.2, 0.4, 0.55, 0.7, 0.8, 0.88, 0.94};
constexpr std::array whitePole{0.0};
/// Deviations looked at, about that of the likeliest fit: their logarithms.
constexpr double lowestDeviation = -1.0, highestDeviation = 1.4, deviationStep = 0.1;
/// A standard deviation of three times the largest position for start and offset, beside noise of a hundredth
/// of it: so wide that it decides nothing.
constexpr double ridge = 1e-4 / 9;
/// Share of the stated error that the posterior may leave open. The rest is for what the densities leave out:
/// the curvature of the response, and noise of a higher order. With it the study's measured rates keep below
/// the stated one also with strongly coloured noise.
constexpr double spentOnDeciding = 0.7;
constexpr double impossible = -std::numeric_limits<double>::infinity();

std::span<const double> polesOf(const EarlyDecisionOptions& options)
{
    return options.colouredNoise ? std::span<const double>(colouredPoles)
                                 : std::span<const double>(whitePole);
}

std::vector<NoiseNode> noiseNodes(const LinearizedRecord& likeliest, std::span<const double> poles)
{
    const auto spare = static_cast<double>(likeliest.products.rows() - likeliest.products.columns() + 1);
    std::vector<NoiseNode> nodes;
    for (const double pole : poles) {
        const ReducedRecord record = reduceRecord(likeliest.products, pole, ridge);
        const double misfit =
            record.residual - record.slope.dot(record.information.ldlt().solve(record.slope));
        NoiseNode node{pole, {}};
        const double about = std::sqrt(std::max(misfit, 1e-12 * record.residual) / std::max(spare, 4.0));
        for (double log = lowestDeviation; log < highestDeviation; log += deviationStep)
            node.deviations.push_back(about * std::exp(log));
        nodes.push_back(std::move(node));
    }
    return nodes;
}

bool positiveDefinite(const Eigen::Matrix3d& matrix)
{
    return matrix.allFinite() && matrix.llt().info() == Eigen::Success;
}

/// Of the likeliest parameters, under the noise that is likeliest.
std::optional<Eigen::Matrix3d> covarianceAt(const LinearizedRecord& likeliest,
                                            const LinearizedEvidence& evidence,
                                            const std::vector<NoiseNode>& nodes, const ThetaRange& range)
{
    auto place = static_cast<std::size_t>(std::max_element(evidence.log.begin(), evidence.log.end()) -
                                          evidence.log.begin());
    for (const NoiseNode& node : nodes) {
        if (place >= node.deviations.size()) {
            place -= node.deviations.size();
            continue;
        }
        const double variance = node.deviations[place] * node.deviations[place];
        Eigen::Matrix3d precision = reduceRecord(likeliest.products, node.pole, ridge).information / variance;
        precision.diagonal() += range.variance().cwiseInverse();
        const Eigen::Matrix3d covariance = precision.llt().solve(Eigen::Matrix3d::Identity());
        return positiveDefinite(covariance) ? std::optional(covariance) : std::nullopt;
    }
    return {};
}

double logOfSum(const std::vector<double>& logs)
{
    const double largest = *std::max_element(logs.begin(), logs.end());
    if (!std::isfinite(largest))
        return impossible;
    double sum = 0;
    for (const double log : logs)
        sum += std::exp(log - largest);
    return largest + std::log(sum);
}

/// ln of (density of a flat prior) over (density of the Gaussian of equal variance at its centre).
double flatOverGaussian()
{
    return 1.5 * std::log(2 * std::numbers::pi / 12);
}

} // namespace

InstrumentRange rangeAround(const std::vector<CandidateType>& types)
{
    if (types.empty())
        return {};
    Eigen::Vector3d lowest = types.front().meanLog, highest = lowest;
    for (const CandidateType& type : types) {
        lowest = lowest.cwiseMin(type.meanLog);
        highest = highest.cwiseMax(type.meanLog);
    }
    lowest = lowest.array().exp() / 3;
    highest = highest.array().exp() * 3;
    return {{lowest(0), lowest(1), lowest(2)}, {highest(0), highest(1), highest(2)}};
}

EarlyDecider::EarlyDecider(std::vector<CandidateType> types, const InstrumentRange& range,
                           const EarlyDecisionOptions& options)
    : m_types(std::move(types)), m_options(options), m_nextLook(options.firstSamples)
{
    const InstrumentRange strangers = range.logVolume() ? range : rangeAround(m_types);
    m_lowestLog = strangers.lowest.vector().array().log();
    m_highestLog = strangers.highest.vector().array().log();
    for (const CandidateType& type : m_types)
        m_points.push_back(type.meanLog);
}

bool EarlyDecider::add(double force, double position)
{
    if (m_force.size() >= m_options.mostSamples)
        return false;
    if (!std::isfinite(force) || !std::isfinite(position))
        m_lost.push_back(m_force.size());
    m_force.push_back(std::isfinite(force) ? force : 0);
    m_position.push_back(std::isfinite(position) ? position : 0);
    if (m_force.size() < m_nextLook)
        return false;
    m_nextLook =
        std::max(m_force.size() + 1,
                 static_cast<std::size_t>(std::ceil(static_cast<double>(m_nextLook) * m_options.growth)));
    return true;
}

OutputErrorProblem EarlyDecider::problem() const
{
    ContinuousTimeOptions options;
    options.sampleTime_s = m_options.sampleTime_s;
    options.hold = m_options.hold;
    options.lag_s = m_options.lag_s;
    options.freeInitialState = m_options.freeInitialState;
    options.freeOffset = m_options.freeOffset;
    options.lost = m_lost;
    return makeOutputErrorProblem(m_force, m_position, options);
}

double EarlyDecider::logEvidence(std::size_t type, const OutputErrorProblem& problem,
                                 std::span<const NoiseNode> nodes)
{
    const CandidateType& candidate = m_types[type];
    const LinearizedRecord record = linearize(problem, m_points[type] + problem.toTheta({1, 1, 1}));
    if (!record.finite || !positiveDefinite(candidate.covarianceLog))
        return impossible;
    const LinearizedEvidence evidence = linearizedEvidence(
        record.products, {candidate.meanLog - m_points[type], candidate.covarianceLog}, nodes, ridge);
    // The next look linearises where this one ended, within reach of the type.
    const Eigen::Vector3d reach = 3 * candidate.covarianceLog.diagonal().cwiseSqrt();
    const Eigen::Vector3d away = m_points[type] + evidence.step - candidate.meanLog;
    m_points[type] = candidate.meanLog + away.cwiseMax(-reach).cwiseMin(reach);
    return logOfSum(evidence.log);
}

void EarlyDecider::conclude(const std::vector<double>& logs)
{
    const double all = logOfSum(logs);
    if (!std::isfinite(all))
        return;
    const auto best = static_cast<std::size_t>(std::max_element(logs.begin(), logs.end()) - logs.begin());
    for (const double log : logs)
        m_judgement.posterior.push_back(std::exp(log - all));
    const bool known = best < m_types.size();
    if (known)
        m_judgement.best = best;
    double others = 0; // types
    for (std::size_t i = 0; i < m_types.size(); ++i)
        others += i == best ? 0 : m_judgement.posterior[i];
    const bool ruledOut =
        !known || others <= spentOnDeciding * m_options.otherTypes.value_or(m_options.statedError);
    if (ruledOut && m_judgement.posterior[best] >= 1 - spentOnDeciding * m_options.statedError)
        m_judgement.verdict = known ? EarlyVerdict::Type : EarlyVerdict::Unknown;
}

const EarlyJudgement& EarlyDecider::look()
{
    m_judgement = {};
    m_judgement.samples = m_force.size();
    if (m_types.empty() || m_force.empty())
        return m_judgement;
    const OutputErrorProblem problem = this->problem();
    const Eigen::Vector3d toTheta = problem.toTheta({1, 1, 1});
    const ThetaRange range{m_lowestLog + toTheta, m_highestLog + toTheta};
    std::vector<Eigen::Vector3d> starts;
    for (const Eigen::Vector3d& point : m_points)
        starts.push_back(point + toTheta);
    const std::span<const double> poles = polesOf(m_options);
    const LinearizedRecord stranger = searchStranger(problem, starts, range, poles, ridge);
    if (!stranger.finite)
        return m_judgement;
    m_points.resize(m_types.size());
    m_judgement.parameters = problem.toChannelUnits(stranger.theta);

    const std::vector<NoiseNode> nodes = noiseNodes(stranger, poles);
    std::vector<double> logs;
    for (std::size_t i = 0; i < m_types.size(); ++i)
        logs.push_back(std::log((1 - m_options.strangerShare) / static_cast<double>(m_types.size())) +
                       logEvidence(i, problem, nodes));
    const Eigen::Matrix3d spread = range.variance().asDiagonal();
    const LinearizedEvidence evidence =
        linearizedEvidence(stranger.products, {Eigen::Vector3d::Zero(), spread}, nodes, ridge);
    logs.push_back(std::log(m_options.strangerShare) + flatOverGaussian() + logOfSum(evidence.log));
    m_judgement.covarianceLog = covarianceAt(stranger, evidence, nodes, range);
    m_points.push_back(stranger.theta - toTheta);
    conclude(logs);
    return m_judgement;
}

} // namespace gripscope
