// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/further_terms.h"

#include "core/base/words.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/output_error/output_error.h"

#include <algorithm>
#include <cmath>
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

/// First-order gain (twice the logarithm of the likelihood) from which on further terms are searched for: a
/// third of what makes a model decisively better, since a first step sees no more of a large effect. Noise
/// alone gains as much once in thirty squeezes.
double worthSearching(const MotionTerms& terms, std::size_t samples)
{
    const int unknowns = (terms.friction ? 1 : 0) + (terms.relaxation ? 3 : 0) + (terms.cubic ? 1 : 0);
    return (unknowns * std::log(static_cast<double>(samples)) + decisiveDelta) / 3;
}

/// Where there is something to compare it with, no sample is lost, the record is short enough for it to be
/// quick, and a first look says that a motion with these terms explains more.
bool isWorthSearching(const Identification& identification, const PreparedRecord& record,
                      const MotionOptions& options)
{
    return hasLinear(identification) && record.lost.empty() && record.force.size() <= longestTried &&
           expectedGain(record.force, record.position, options) >=
               worthSearching(options.terms, record.force.size());
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
    if (const Estimate* const linear = identification.find(Estimator::OutputError)) {
        options.start = linear->parameters;
        options.startNuisance = linear->nuisance;
    }
    return options;
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
    else if (isWorthSearching(identification, record, options) ||
             (isKnownToRub(options) && hasLinear(identification) && record.force.size() <= longestTried))
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
    constexpr double much = 2 * decisiveDelta;
    const double byCubic = gainOver(*linear, cubic);
    const double byFriction = gainOver(*linear, friction);
    const double byRelaxing = gainOver(*linear, relaxing);
    // Friction that is known to be there belongs to every motion.
    const bool rubs = isKnownToRub(motionOptions(Estimator::Friction, record, task));
    const double least = rubs ? std::min(byCubic, byRelaxing) : std::min({byCubic, byFriction, byRelaxing});
    if ((byCubic > much) + (rubs || byFriction > much) + (byRelaxing > much) < 2)
        return;
    const Estimator both = least == byCubic      ? Estimator::FrictionZener
                           : least == byRelaxing ? Estimator::FrictionDuffing
                                                 : Estimator::ZenerDuffing;
    together = settled(motionWith(both, identification, record, task));
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
