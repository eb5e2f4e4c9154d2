// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/identification_steps.h"
#include "core/identification/output_error/output_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

/// A search takes some microseconds a sample and iteration: a second for this many.
constexpr std::size_t longestTried = 100'000;

bool hasLinear(const Identification& identification)
{
    const Estimate* const linear = identification.find(Estimator::OutputError);
    return linear != nullptr && linear->status == EstimateStatus::Converged;
}

int furtherUnknowns(const MotionTerms& terms)
{
    return (terms.friction ? 1 : 0) + (terms.relaxation ? 3 : 0) + (terms.cubic ? 1 : 0);
}

/// First-order gain (twice the logarithm of the likelihood) from which on so many further unknowns are
/// searched for: a third of what makes a model decisively better, since a first step sees no more of a large
/// effect. Noise alone gains as much once in thirty squeezes.
double worthSearching(int unknowns, std::size_t samples)
{
    return (unknowns * std::log(static_cast<double>(samples)) + decisiveDelta) / 3;
}

/// No sample is lost, and a first look says that a motion with these terms explains more than one with those
/// of `base`, where the options start.
bool isWorthSearching(const PreparedRecord& record, const MotionOptions& options,
                      const MotionTerms& base = {})
{
    return record.lost.empty() &&
           expectedGain(record.force, record.position, options, base) >=
               worthSearching(furtherUnknowns(options.terms) - furtherUnknowns(base), record.force.size());
}

/// The gripper is known to have friction: a squeeze is not explained without it.
bool isKnownToRub(const MotionOptions& options)
{
    constexpr double beyondDoubt = 2; // standard errors
    return options.terms.friction && options.knownFriction &&
           options.knownFriction->value > beyondDoubt * options.knownFriction->standardError;
}

/// motionOptions(), from the linear motion on where that was found.
MotionOptions fromLinear(Estimator estimator, const Identification& identification,
                         const PreparedRecord& record, const EstimatorTask& task)
{
    MotionOptions options = motionOptions(estimator, record, task);
    options.arrived = nearEnough;
    if (const Estimate* const linear = identification.find(Estimator::OutputError)) {
        options.start = linear->parameters;
        options.startNuisance = linear->nuisance;
    }
    return options;
}

/// There is something to compare with, and the record is short enough for a search to be quick.
bool canSearch(const Identification& identification, const PreparedRecord& record)
{
    return hasLinear(identification) && record.force.size() <= longestTried;
}

/// A motion with further terms: the one that was asked for; else it is tried where that is worth it. With
/// parameters, settled or not.
std::optional<Estimate> motionWith(Estimator estimator, const Identification& identification,
                                   const PreparedRecord& record, const EstimatorTask& task)
{
    std::optional<Estimate> motion;
    const MotionOptions options = fromLinear(estimator, identification, record, task);
    if (const Estimate* const found = identification.find(estimator))
        motion = *found;
    else if (canSearch(identification, record) &&
             (isKnownToRub(options) || isWorthSearching(record, options)))
        motion = estimateMotion(record.force, record.position, options);
    if (motion && !motion->parameters)
        motion.reset();
    return motion;
}

std::optional<Estimate> settled(std::optional<Estimate> motion)
{
    if (motion && motion->status != EstimateStatus::Converged)
        motion.reset();
    return motion;
}

/// Twice the gain in the logarithm of the likelihood under white noise, as a first look.
double gainOver(const Estimate& linear, const std::optional<Estimate>& other)
{
    if (!other || !(other->residuals.sse > 0) || !(linear.residuals.sse > 0))
        return 0;
    return static_cast<double>(linear.residual.size()) *
           std::log(linear.residuals.sse / other->residuals.sse);
}

/// A term alone, as far as it was found, and what it gains over the linear motion.
struct TermAlone {
    const std::optional<Estimate>* found;
    double gain;
};

/// The two terms that gain most, the better first, where both gain much. Friction that is known to be there
/// belongs to every motion.
std::optional<std::array<const std::optional<Estimate>*, 2>> bestTwo(const Estimate& linear,
                                                                     const FurtherTerms& further, bool rubs)
{
    constexpr double much = 2 * decisiveDelta;
    std::array<TermAlone, 3> terms{{{&further.friction, rubs ? std::numeric_limits<double>::infinity()
                                                             : gainOver(linear, further.friction)},
                                    {&further.relaxing, gainOver(linear, further.relaxing)},
                                    {&further.cubic, gainOver(linear, further.cubic)}}};
    std::ranges::stable_sort(terms, std::greater(), &TermAlone::gain);
    if (!(terms[1].gain > much))
        return std::nullopt;
    return std::array{terms[0].found, terms[1].found};
}

/// Both terms, from the one that explains more alone and what the other found; where that is worth it beyond
/// the one alone.
std::optional<Estimate> motionBeyond(const Estimate& alone, const Estimate& other, Estimator estimator,
                                     const PreparedRecord& record, const EstimatorTask& task)
{
    MotionOptions options = motionOptions(estimator, record, task);
    options.start = alone.parameters;
    options.startNuisance = alone.nuisance;
    options.startTerms = alone.motion->values;
    options.arrived = nearEnough;
    for (const MotionParameter parameter : options.terms.parameters())
        if (options.startTerms[parameter] == 0)
            options.startTerms[parameter] = other.motion->values[parameter];
    if (!isWorthSearching(record, options, alone.motion->terms))
        return std::nullopt;
    options.startIsNear = true;
    Estimate near = estimateMotion(record.force, record.position, options);
    if (near.status == EstimateStatus::Converged)
        return near;
    options.startIsNear = false;
    return estimateMotion(record.force, record.position, options);
}

std::vector<Estimate> motionsOf(const FurtherTerms& further)
{
    std::vector<Estimate> all;
    for (const auto& one : {further.cubic, further.friction, further.relaxing, further.together})
        if (one)
            all.push_back(*one);
    return all;
}

} // namespace

void FurtherTerms::findPart(std::int64_t part, const Identification& identification,
                            const PreparedRecord& record, const EstimatorTask& task)
{
    if (part == 0)
        cubic = settled(motionWith(Estimator::Duffing, identification, record, task));
    else if (part == 1)
        friction = settled(motionWith(Estimator::Friction, identification, record, task));
    else
        findYielding(identification, record, task);
}

void FurtherTerms::findYielding(const Identification& identification, const PreparedRecord& record,
                                const EstimatorTask& task)
{
    std::optional<Estimate> found = motionWith(Estimator::Zener, identification, record, task);
    if (found && found->status == EstimateStatus::NotConverged && hasLinear(identification))
        unsettledYielding = gainOver(*identification.find(Estimator::OutputError), found);
    relaxing = settled(std::move(found));
}

void FurtherTerms::findTogether(const Identification& identification, const PreparedRecord& record,
                                const EstimatorTask& task)
{
    const Estimate* const linear = identification.find(Estimator::OutputError);
    if (linear == nullptr)
        return;
    const auto terms =
        bestTwo(*linear, *this, isKnownToRub(motionOptions(Estimator::Friction, record, task)));
    if (!terms)
        return;
    const std::optional<Estimate>& first = *terms->front();
    const std::optional<Estimate>& second = *terms->back();
    const auto has = [&](const std::optional<Estimate>& term) { return &first == &term || &second == &term; };
    const Estimator both = !has(cubic)      ? Estimator::FrictionZener
                           : !has(relaxing) ? Estimator::FrictionDuffing
                                            : Estimator::ZenerDuffing;
    const bool isAlone = first && second && identification.find(both) == nullptr;
    together = settled(isAlone ? motionBeyond(*first, *second, both, record, task)
                               : motionWith(both, identification, record, task));
}

ModelComparison comparisonOf(const Identification& identification, const PreparedRecord& record,
                             const EstimatorTask& task, const Estimate& otherHold,
                             const FurtherTerms& further)
{
    if (!hasLinear(identification))
        return {};
    ModelComparison comparison = compareModels(
        record.force, record.position, outputErrorOptions(record, task),
        *identification.find(Estimator::OutputError), otherHold, motionsOf(further), record.chain.friction);
    comparison.unsettledYielding = further.unsettledYielding;
    return comparison;
}

const Estimate* betterMotion(const ModelComparison& comparison)
{
    if (!comparison.decisive || comparison.ranked.empty())
        return nullptr;
    const Estimate& best = comparison.ranked.front().estimate;
    return best.motion && best.estimator != Estimator::Duffing ? &best : nullptr;
}

void nameFurtherTerms(Identification& data, const QString& forceUnit)
{
    const Estimate* const motion = betterMotion(data.comparison);
    const Estimate* const linear = data.find(Estimator::OutputError);
    if (motion == nullptr || linear == nullptr || !linear->parameters)
        return;
    const double shift = 100 * (linear->parameters->k / motion->parameters->k - 1);
    const MotionValues& values = motion->motion->values;
    const MotionTerms& terms = motion->motion->terms;
    Findings parts;
    if (terms.friction)
        parts.push_back(Words::say("friction of %1 %2")
                            .arg(Finding::number(values[MotionParameter::Friction], 'g', 2))
                            .arg(forceUnit));
    if (terms.relaxation)
        parts.push_back(
            Words::say("a part that goes on yielding by %1 % over %2 s")
                .arg(Finding::number(
                    100 * values[MotionParameter::Relaxing] / values[MotionParameter::Stiffness], 'g', 2))
                .arg(Finding::number(values[MotionParameter::RelaxationTime], 'g', 2)));
    if (terms.cubic)
        parts.push_back(Words::say("a spring that is not straight"));
    const Finding what = parts.size() == 2 ? Words::say("%1 with %2").arg(parts[0], parts[1])
                                           : Finding::joined(parts, QString());
    data.comparison.sentence =
        (shift >= 0 ? Words::say("%1 explains this squeeze; without it k would read %2 % high.")
                    : Words::say("%1 explains this squeeze; without it k would read %2 % low."))
            .arg(what.capitalized())
            .arg(Finding::number(std::abs(shift), 'g', 2));
}

} // namespace gripscope
