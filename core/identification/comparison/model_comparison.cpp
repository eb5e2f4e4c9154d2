// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/comparison/model_comparison.h"

#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/uncertainty/effect_regression.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A change of m, b or k that counts, in standard errors.
constexpr double noticeable = 2;

/// The residuals of the samples that were measured and used: those that every model has.
std::vector<double> usedResiduals(const Estimate& e, const OutputErrorOptions& options)
{
    std::vector<double> out;
    for (std::size_t i = 0; i < e.residual.size(); ++i) {
        if (!std::binary_search(options.lost.begin(), options.lost.end(), i))
            out.push_back(e.residual[i]);
    }
    return out;
}

/// Twice what the likelihood loses because the model's friction is not the one that is known: all of it where
/// the model has none. A motion that was told of it and gave it up has friction of the part's own.
double againstKnownFriction(const Estimate& e, const std::optional<GripperFriction>& known)
{
    if (!known || !(known->standardError > 0))
        return 0;
    if (e.motion && e.motion->terms.friction)
        return std::pow(e.motion->offKnownFriction.value_or(0), 2);
    return std::pow(known->value / known->standardError, 2);
}

/// Fills in likelihood and criterion; false when there is nothing to judge.
bool judge(ComparedModel& model, const OutputErrorOptions& options,
           const std::optional<GripperFriction>& knownFriction)
{
    const Estimate& e = model.estimate;
    if (e.status != EstimateStatus::Converged || !e.parameters)
        return false;
    const std::vector<double> residuals = usedResiduals(e, options);
    const std::optional<SeriesModel> series = autoregressiveModel(residuals);
    if (!series)
        return false;
    model.noiseOrder = static_cast<int>(series->coefficients.size());
    model.parameters += 3 + model.noiseOrder + 1 + (e.nuisance.x0 ? 2 : 0) + (e.nuisance.offset ? 1 : 0);
    model.logLikelihood = series->logLikelihood - againstKnownFriction(e, knownFriction) / 2;
    model.criterion =
        -2 * model.logLikelihood + model.parameters * std::log(static_cast<double>(residuals.size()));
    return std::isfinite(model.criterion);
}

ComparedModel modelOf(const QString& id, const Finding& words, Estimate estimate, int extra = 0)
{
    ComparedModel model;
    model.id = id;
    model.words = words;
    model.estimate = std::move(estimate);
    model.parameters = extra;
    return model;
}

/// What is left of the residual.
double lastOf(const Eigen::MatrixXd& triangle)
{
    return std::abs(triangle(triangle.rows() - 1, triangle.cols() - 1));
}

/// The delay that explains the residuals of `e` best, to first order, in seconds.
double delayStep(const Estimate& e, const std::vector<double>& force, const OutputErrorOptions& options)
{
    const LinearizedRecord record = linearizedRecord(e, force, options);
    if (!record.usable())
        return 0;
    const std::vector<std::vector<double>> effects{record.velocity};
    const Eigen::MatrixXd triangle = effectTriangle(record, effects, e.residual, {}).triangle;
    const Eigen::Index at = record.nuisances.cols() + 3;
    const double step = triangle(at, at + 1) / triangle(at, at);
    return std::isfinite(step) ? step : 0;
}

/// Begun at the linear model's m, b and k, and no further than the comparison needs: a thousandth of a
/// standard error moves the criterion by a millionth, and a model that has nowhere to settle (one without the
/// offset that there is) would otherwise keep the verdict waiting for it.
OutputErrorOptions fromLinear(OutputErrorOptions options, const Estimate& linear)
{
    options.start = linear.parameters;
    options.arrived = 1e-3;
    options.maxIterations = 30;
    return options;
}

/// Of what is known already, what explains most: only a model that explains more is asked for its errors.
const Estimate& mostExplained(const Estimate& linear, const std::vector<Estimate>& motions)
{
    const Estimate* most = &linear;
    for (const Estimate& motion : motions)
        if (motion.motion && motion.parameters && explainsMore(motion, *most))
            most = &motion;
    return *most;
}

ComparedModel delayed(const std::vector<double>& force, const std::vector<double>& position,
                      const OutputErrorOptions& options, const Estimate& linear, const Estimate& known)
{
    constexpr int iterations = 4;
    OutputErrorOptions moved = fromLinear(options, linear);
    moved.residuals = ResidualDepth::Sums;
    ComparedModel best =
        modelOf(u"delay"_s, Words::say("a further delay between force and position"), linear, 1);
    best.delay_s = 0;
    Estimate at = linear;
    for (int i = 0; i < iterations; ++i) {
        // A sample at a time: the response is smooth only between samples.
        moved.lag_s += std::clamp(delayStep(at, force, moved), -options.sampleTime_s, options.sampleTime_s);
        moved.start = at.parameters;
        at = estimateOutputError(force, position, moved);
        if (at.status != EstimateStatus::Converged)
            break;
        if (explainsMore(at, best.estimate)) {
            best.estimate = at;
            best.delay_s = moved.lag_s - options.lag_s;
        }
    }
    if (*best.delay_s == 0)
        return best;
    moved.lag_s = options.lag_s + *best.delay_s;
    moved.start = best.estimate.parameters;
    best.estimate = estimateBeside(known, force, position, moved);
    return best;
}

/// By how much the sum of squares grows without the offset, as far as a first step from the linear model
/// says: N times the logarithm of the ratio, twice what the likelihood loses under white noise.
double lossWithoutOffset(const Estimate& linear, const std::vector<double>& force,
                         const OutputErrorOptions& options)
{
    if (!options.freeOffset || !linear.nuisance.offset)
        return 0;
    LinearizedRecord record = linearizedRecord(linear, force, options);
    if (!record.usable())
        return 0;
    record.nuisances.conservativeResize(Eigen::NoChange, record.nuisances.cols() - 1); // it is the last one
    std::vector<double> residual = linear.residual;
    const double with = lastOf(effectTriangle(record, {}, residual, {}).triangle);
    for (double& value : residual)
        value += *linear.nuisance.offset;
    const double without = lastOf(effectTriangle(record, {}, residual, {}).triangle);
    const double loss = 2 * static_cast<double>(record.rows.size()) * std::log(without / with);
    return std::isfinite(loss) ? loss : 0;
}

/// Without the offset where there is one, with one where there is none. Nothing where the offset is so plain
/// that the search without it, which has nowhere to settle then, would only keep the verdict waiting.
std::optional<ComparedModel> otherOffset(const std::vector<double>& force,
                                         const std::vector<double>& position,
                                         const OutputErrorOptions& options, const Estimate& linear,
                                         const Estimate& known)
{
    constexpr double hopeless = 100 * decisiveDelta;
    if (lossWithoutOffset(linear, force, options) > hopeless)
        return std::nullopt;
    OutputErrorOptions other = fromLinear(options, linear);
    other.freeOffset = !options.freeOffset;
    return modelOf(options.freeOffset ? u"without_offset"_s : u"with_offset"_s,
                   options.freeOffset ? Words::say("no offset of the position")
                                      : Words::say("an offset of the position"),
                   estimateBeside(known, force, position, other));
}

/// What a motion with further terms is called in the sentence that it explains a squeeze better.
Finding wordsOf(const MotionEstimate& motion)
{
    const MotionTerms& terms = motion.terms;
    if (terms == MotionTerms{.cubic = true})
        return motion.values[MotionParameter::Cubic] > 0 ? Words::say("a stiffening spring")
                                                         : Words::say("a softening spring");
    Findings parts;
    if (terms.friction)
        parts.push_back(Words::say("friction"));
    if (terms.relaxation)
        parts.push_back(Words::say("a part that goes on yielding"));
    if (terms.cubic)
        parts.push_back(Words::say("a spring that is not straight"));
    return parts.size() == 2 ? Words::say("%1 with %2").arg(parts[0], parts[1])
                             : Finding::joined(parts, u", "_s);
}

/// A cubic spring alone keeps the name that it has in documents.
QString idOf(Estimator estimator)
{
    return estimator == Estimator::Duffing ? u"cubic_spring"_s : toString(estimator);
}

/// The unknowns that it has beyond those of mass, spring and damper.
int extraUnknowns(const MotionEstimate& motion, bool freeInitialState)
{
    const auto own = static_cast<int>(motion.terms.parameters().size());
    return own - 3 + (motion.terms.relaxation && freeInitialState ? 1 : 0);
}

/// Side by side: somebody waits for the verdict that rests on them.
std::vector<ComparedModel> candidates(const std::vector<double>& force, const std::vector<double>& position,
                                      const OutputErrorOptions& options, const Estimate& linear,
                                      const Estimate& otherHold, const std::vector<Estimate>& motions,
                                      const Estimate& known)
{
    std::vector<ComparedModel> models;
    models.push_back(modelOf(u"linear"_s, Words::say("mass, spring and damper"), linear));
    for (const Estimate& motion : motions)
        if (motion.motion && motion.parameters)
            models.push_back(modelOf(idOf(motion.estimator), wordsOf(*motion.motion), motion,
                                     extraUnknowns(*motion.motion, options.freeInitialState)));
    const bool straight = options.hold == ForceHold::First;
    models.push_back(modelOf(u"other_hold"_s,
                             straight ? Words::say("a force that is held from sample to sample")
                                      : Words::say("a force that runs straight from sample to sample"),
                             otherHold));
    std::vector<std::function<std::optional<ComparedModel>()>> others;
    others.emplace_back([&] { return delayed(force, position, options, linear, known); }); // the longest
    others.emplace_back([&] { return otherOffset(force, position, options, linear, known); });
    if (straight)
        others.emplace_back([&, other = fromLinear(options, linear)] {
            return modelOf(u"smooth_force"_s, Words::say("a force that is smooth between its samples"),
                           estimateBeside(known, straightAsSpline(force), position, other));
        });
    std::vector<std::optional<ComparedModel>> found(others.size());
    shareAmongThreads(static_cast<std::int64_t>(others.size()), 0, [&](std::int64_t i) {
        found[static_cast<std::size_t>(i)] = others[static_cast<std::size_t>(i)]();
    });
    for (std::optional<ComparedModel>& model : found)
        if (model)
            models.push_back(std::move(*model));
    return models;
}

/// The smaller standard errors count: a poor model's own are large because it is poor. A motion's own are
/// known where it explains more than the linear one; another model's under its noise only where it explains
/// more than `known`, the best of all (estimateBeside).
double changeInErrors(const Estimate& linear, const Estimate& known, const Estimate& other)
{
    const std::optional<Eigen::Vector3d> errors = linear.standardErrors();
    const std::optional<Eigen::Vector3d> others = other.standardErrors();
    if (!errors || !others)
        return 0;
    const bool areKnown = explainsMore(other, other.motion ? linear : known);
    const Eigen::Vector3d smaller = areKnown ? errors->cwiseMin(*others) : *errors;
    const Eigen::Vector3d change = other.parameters->vector() - linear.parameters->vector();
    const double largest = smaller.minCoeff() > 0 ? change.cwiseAbs().cwiseQuotient(smaller).maxCoeff() : 0.0;
    return std::isfinite(largest) ? largest : 0;
}

void conclude(ModelComparison& comparison)
{
    const ComparedModel& best = comparison.ranked.front();
    const ComparedModel& linear = *comparison.find(u"linear"_s);
    const bool clear = linear.delta > decisiveDelta;
    if (!clear) {
        comparison.sentence = Words::say("The linear model is enough.");
        return;
    }
    if (best.change <= noticeable) {
        comparison.sentence =
            Words::say("%1 explains this squeeze better, but m, b and k stay within their errors: the "
                       "linear model is enough.")
                .arg(best.words.capitalized());
        return;
    }
    comparison.decisive = true;
    comparison.sentence = Words::say("%1 explains this squeeze better.").arg(best.words.capitalized());
}

} // namespace

const ComparedModel* ModelComparison::find(const QString& id) const
{
    const auto found = std::find_if(ranked.begin(), ranked.end(),
                                    [&](const ComparedModel& model) { return model.id == id; });
    return found != ranked.end() ? &*found : nullptr;
}

ModelComparison compareModels(const std::vector<double>& force, const std::vector<double>& position,
                              const OutputErrorOptions& options, const Estimate& linear,
                              const Estimate& otherHold, const std::vector<Estimate>& motions,
                              const std::optional<GripperFriction>& knownFriction)
{
    ModelComparison comparison;
    comparison.criterion = u"BIC"_s;
    if (linear.status != EstimateStatus::Converged || !linear.parameters ||
        linear.residual.size() != force.size() || force.size() != position.size())
        return comparison;
    const Estimate& known = mostExplained(linear, motions);
    for (ComparedModel& model : candidates(force, position, options, linear, otherHold, motions, known)) {
        if (!judge(model, options, knownFriction)) {
            if (model.id == u"linear"_s)
                return comparison;
            continue;
        }
        model.change = changeInErrors(linear, known, model.estimate);
        comparison.ranked.push_back(std::move(model));
    }
    std::stable_sort(
        comparison.ranked.begin(), comparison.ranked.end(),
        [](const ComparedModel& a, const ComparedModel& b) { return a.criterion < b.criterion; });
    double sum = 0;
    for (ComparedModel& model : comparison.ranked) {
        model.delta = model.criterion - comparison.ranked.front().criterion;
        model.weight = std::exp(-model.delta / 2);
        sum += model.weight;
    }
    for (ComparedModel& model : comparison.ranked)
        model.weight /= sum;
    conclude(comparison);
    return comparison;
}

} // namespace gripscope
