// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/judgement.h"

#include "core/recognition/types/gates.h"
#include "core/recognition/types/instrument_range.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/verdict_reasons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

/// Where a squeeze is named a type rather than taken for a stranger.
struct StrangerLimit {
    /// Share of strangers inside the gates, before and after the limit. Gates that overlap count twice, and
    /// what lies outside the instrument's range too: it may only be less.
    double insideGates = 0, accepted = 0;
    /// Log of the least density a type must have; absent where the gates alone keep the rate.
    std::optional<double> leastLogDensity;
};

/// pi^(p/2) / G(p/2 + 1) q^(p/2) |V|^(1/2)
double ellipsoidVolume(const TypePrediction& prediction, double squared)
{
    constexpr double pi = std::numbers::pi;
    constexpr std::array<double, mostDimensions + 1> ofUnitBall{
        1, 2, pi, 4 * pi / 3, pi * pi / 2, 8 * pi * pi / 15, pi * pi * pi / 6};
    const Eigen::Index p = prediction.meanLog.size();
    double volume = ofUnitBall[std::size_t(p)];
    for (Eigen::Index i = 2; i <= p; i += 2)
        volume *= squared;
    if (p % 2 == 1)
        volume *= std::sqrt(squared);
    return volume * std::exp(prediction.logDeterminant / 2);
}

/// Squared distance at which the type's density falls to a level.
double squaredAt(const TypePrediction& prediction, double logLevel)
{
    const double v = prediction.tailDegrees;
    const double exponent = 2 / (v + 1) * (prediction.logDensityAtMean - logLevel);
    return v * std::expm1(std::clamp(exponent, 0.0, 600.0));
}

double volumeAbove(const std::vector<TypePrediction>& predictions, const std::vector<double>& gates,
                   double logLevel)
{
    double volume = 0;
    for (std::size_t i = 0; i < predictions.size(); ++i)
        volume += ellipsoidVolume(predictions[i], std::min(gates[i], squaredAt(predictions[i], logLevel)));
    return volume;
}

/// The region of the likelihood ratio test of types against strangers that holds a share of at most `rate` of
/// all strangers: density above a level, and inside the gate. `gates`: squared distances, one a type.
StrangerLimit strangerLimit(const std::vector<TypePrediction>& predictions, const std::vector<double>& gates,
                            double logVolume, double rate)
{
    StrangerLimit limit;
    for (std::size_t i = 0; i < predictions.size(); ++i)
        limit.insideGates += ellipsoidVolume(predictions[i], gates[i]) / logVolume;
    limit.insideGates = std::min(1.0, limit.insideGates);
    limit.accepted = limit.insideGates;
    if (limit.insideGates <= rate)
        return limit;
    double high = -1e300;
    for (const TypePrediction& prediction : predictions)
        high = std::max(high, prediction.logDensityAtMean);
    double low = high - 700;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (volumeAbove(predictions, gates, middle) > rate * logVolume ? low : high) = middle;
    }
    limit.leastLogDensity = high;
    limit.accepted = volumeAbove(predictions, gates, high) / logVolume;
    return limit;
}

/// What distances and gates are multiplied with, so that they read as those of falseRejectGate().
double spread(const TypeModel& type)
{
    return 1 + 1.0 / type.squeezes;
}

/// exp(log weight) over their sum, the largest taken out first so that nothing underflows to 0/0.
std::vector<double> normalised(std::vector<double> logWeights)
{
    const double largest = *std::max_element(logWeights.begin(), logWeights.end());
    double total = 0;
    for (double& weight : logWeights) {
        weight = std::exp(weight - largest);
        total += weight;
    }
    for (double& weight : logWeights)
        weight /= total;
    return logWeights;
}

} // namespace

Judgement::Judgement(const TypeModels& models, LogVector log, const std::optional<LogMatrix>& noise,
                     const VerdictOptions& options)
    : m_models(models), m_noise(noise), m_options(options), m_log(std::move(log)),
      m_predictions(predictTypes(models, m_log, noise, {options.robust}))
{
    findGates();
    findNearest();
}

std::optional<double> Judgement::gateOf(const TypePrediction& prediction) const
{
    const int p = m_models.space.dimensions();
    if (!m_options.confidence)
        return predictiveGate(prediction.degreesOfFreedom, m_options.falseReject, p);
    const int squeezes = std::max(1, int(std::min(1e6, prediction.effectiveSqueezes) + 1e-6));
    const std::optional<double> gate =
        toleranceGate(squeezes, prediction.degreesOfFreedom, m_options.falseReject, *m_options.confidence, p);
    return gate ? std::optional(*gate / (1 + 1 / prediction.effectiveSqueezes)) : std::nullopt;
}

void Judgement::findGates()
{
    // Most types have the same number of squeezes, and one gate serves them all.
    std::map<std::pair<double, double>, std::optional<double>> known;
    const double tails =
        m_options.robust ? heavyTailFactor(m_options.falseReject, m_models.space.dimensions()) : 1;
    for (const TypePrediction& prediction : m_predictions) {
        const std::pair key(prediction.degreesOfFreedom,
                            m_options.confidence ? prediction.effectiveSqueezes : 0.0);
        const auto [place, isNew] = known.try_emplace(key);
        if (isNew)
            place->second = gateOf(prediction);
        if (!place->second) {
            m_gates.clear();
            return;
        }
        m_gates.push_back(tails * *place->second);
    }
}

std::vector<GateIntervals> Judgement::gateIntervals() const
{
    std::vector<GateIntervals> all;
    for (std::size_t type = 0; type < m_gates.size(); ++type) {
        const TypePrediction& prediction = m_predictions[type];
        GateIntervals& intervals = all.emplace_back();
        for (Eigen::Index row = 0; row < prediction.meanLog.size(); ++row) {
            const double mean = prediction.meanLog(row);
            const double reach = std::sqrt(m_gates[type] * prediction.variance(row));
            intervals.push_back({std::exp(mean), std::exp(mean - reach), std::exp(mean + reach)});
        }
    }
    return all;
}

bool Judgement::inside(std::size_t type) const
{
    return !m_gates.empty() && m_predictions[type].squaredDistance <= m_gates[type];
}

void Judgement::findNearest()
{
    for (std::size_t i = 1; i < m_predictions.size(); ++i) {
        const bool nearer = m_predictions[i].squaredDistance < m_predictions[m_nearest].squaredDistance;
        if (inside(i) != inside(m_nearest) ? inside(i) : nearer)
            m_nearest = i;
    }
}

bool Judgement::heldForStranger(Verdict& verdict) const
{
    const std::optional<InstrumentRange> range = m_options.strangerRange();
    const std::optional<double> volume = range ? range->logVolume(m_models.space) : std::nullopt;
    if (!volume)
        return false;
    std::vector<double> logWeights;
    logWeights.reserve(m_predictions.size() + 1);
    const double share = m_options.strangerShare;
    const double each = std::log((1 - share) / double(m_predictions.size()));
    for (const TypePrediction& prediction : m_predictions)
        logWeights.push_back(prediction.logDensity + each);
    logWeights.push_back(std::log(share / *volume));
    verdict.strangerPosterior = normalised(logWeights).back();
    const StrangerLimit limit = strangerLimit(m_predictions, m_gates, *volume, m_options.strangerAccept);
    verdict.strangerAccept = limit.accepted;
    return limit.leastLogDensity && m_predictions[m_nearest].logDensity < *limit.leastLogDensity;
}

void Judgement::describeType(Verdict& verdict) const
{
    const TypeModel& type = m_models.types[m_nearest];
    verdict.kind = VerdictKind::Type;
    verdict.type = type.name;
    std::optional<NextType> next;
    for (std::size_t i = 0; i < m_predictions.size(); ++i) {
        const double distance = std::sqrt(spread(m_models.types[i]) * m_predictions[i].squaredDistance);
        if (i != m_nearest && (!next || distance < next->deviations))
            next = NextType{&m_models.types[i], distance};
    }
    verdict.reasons = typeReasons(m_models, type, next, m_log, m_options);
}

void Judgement::decide(Verdict& verdict) const
{
    const TypeModel& nearest = m_models.types[m_nearest];
    const bool forStranger = heldForStranger(verdict);
    if (!inside(m_nearest)) {
        verdict.kind = VerdictKind::Unknown;
        verdict.reasons = unknownReasons(m_models, nearest, m_log, verdict, m_options);
        return;
    }
    const SeparationOptions separation{m_options.wrongType, m_options.robust};
    const NamingTest naming = testNaming(m_predictions, m_nearest, m_log, separation);
    if (naming.rival)
        verdict.rival = m_models.types[*naming.rival].name;
    const auto isLess = [](const TypePrediction& a, const TypePrediction& b) {
        return a.logDensity < b.logDensity;
    };
    const auto best = std::max_element(m_predictions.begin(), m_predictions.end(), isLess);
    const bool mostProbable = best->logDensity <= m_predictions[m_nearest].logDensity;
    verdict.open = {nearest.name};
    for (const std::size_t other : naming.open)
        verdict.open << m_models.types[other].name;
    if (!mostProbable)
        verdict.open << m_models.types[std::size_t(best - m_predictions.begin())].name;
    verdict.open.removeDuplicates();
    if (naming.passed && mostProbable && !forStranger) {
        describeType(verdict);
    } else if (naming.passed && mostProbable) {
        verdict.heldForStranger = true;
        verdict.reasons = strangerReasons(m_models.space, verdict, m_options.strangerAccept);
    } else {
        if (m_noise && naming.rival)
            verdict.timesLonger = timesLonger(m_models, m_nearest, *naming.rival, *m_noise, separation);
        verdict.reasons = betweenTypesReasons(verdict, m_noise.has_value());
    }
}

Verdict Judgement::verdict() const
{
    Verdict verdict;
    verdict.kind = VerdictKind::Inconclusive;
    const TypeModel& nearest = m_models.types[m_nearest];
    verdict.nearest = nearest.name;
    std::vector<double> logDensities;
    for (const TypePrediction& prediction : m_predictions)
        logDensities.push_back(prediction.logDensity);
    const std::vector<double> posterior = normalised(logDensities);
    for (std::size_t i = 0; i < posterior.size(); ++i) // by name, so that each goes to the end
        verdict.posterior.insert(verdict.posterior.cend(), m_models.types[i].name, posterior[i]);
    verdict.distance = spread(nearest) * m_predictions[m_nearest].squaredDistance;
    if (m_gates.empty()) {
        verdict.reasons = noGateReasons(m_models);
        return verdict;
    }
    verdict.gate = spread(nearest) * m_gates[m_nearest];
    decide(verdict);
    return verdict;
}

} // namespace gripscope
