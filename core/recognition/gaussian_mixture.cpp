// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/gaussian_mixture.h"

#include "core/recognition/cluster_items.h"
#include "core/recognition/feature_scaling.h"
#include "core/recognition/gaussian_mixture_em.h"
#include "core/recognition/kmeans.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int shortRun = 25;             ///< iterations of each start before the best is continued
constexpr double leastGainAnItem = 1e-7; ///< of the objective

/// One start, as far as it has been run.
struct Run {
    std::unique_ptr<MixtureEm> em;
    std::vector<MixtureStep> steps;
    int iterations = 0;
    bool converged = false;
};

void record(Run& run, const GaussianMixtureOptions& options)
{
    if (options.recordSteps)
        run.steps.push_back(
            {run.em->parameters(), run.em->labels(), run.em->logLikelihood(), run.em->objective()});
}

/// EM up to that many iterations in all.
void proceed(Run& run, int iterations, Eigen::Index items, const GaussianMixtureOptions& options)
{
    while (!run.converged && run.iterations < std::min(iterations, options.maxIterations)) {
        const double before = run.em->objective();
        run.em->maximize();
        run.em->expect();
        ++run.iterations;
        record(run, options);
        run.converged = run.em->objective() - before < leastGainAnItem * double(items);
    }
}

/// The different ends of single K-means runs, the seeds counted up.
std::vector<std::vector<int>> kMeansStarts(const Eigen::MatrixXd& items,
                                           const GaussianMixtureOptions& options)
{
    KMeansOptions start;
    start.clusters = options.components;
    start.restarts = 1;
    start.recordSteps = false;
    std::vector<std::vector<int>> starts;
    for (int i = 0; i < options.restarts; ++i) {
        start.seed = options.seed + std::uint64_t(i);
        std::vector<int> labels = kMeans(items, start).value().labels; // the items are z-scores: no error
        if (std::find(starts.begin(), starts.end(), labels) == starts.end())
            starts.push_back(std::move(labels));
    }
    return starts;
}

Run bestRun(const Eigen::MatrixXd& items, const ItemRows& rows, const GaussianMixtureOptions& options)
{
    Run best;
    for (const std::vector<int>& start : kMeansStarts(items, options)) {
        Run run;
        run.em = std::make_unique<MixtureEm>(rows, start, options.components, options.covariance);
        run.em->expect();
        record(run, options);
        proceed(run, shortRun, items.rows(), options);
        if (!best.em || run.em->objective() > best.em->objective())
            best = std::move(run);
    }
    proceed(best, options.maxIterations, items.rows(), options);
    return best;
}

/// Numbers the components anew and turns z-scores back into the units of the items.
MixtureParameters inUnits(const MixtureParameters& found, const FeatureTransform& transform,
                          const std::vector<int>& numbers)
{
    const Eigen::MatrixXd means = transform.undo(found.means);
    MixtureParameters parameters = found;
    for (std::size_t c = 0; c < numbers.size(); ++c) {
        const auto to = std::size_t(numbers[c]);
        parameters.weights(Eigen::Index(to)) = found.weights(Eigen::Index(c));
        parameters.means.row(Eigen::Index(to)) = means.row(Eigen::Index(c));
        parameters.covariances[to] =
            transform.scale.asDiagonal() * found.covariances[c] * transform.scale.asDiagonal();
    }
    return parameters;
}

void renumber(std::vector<int>& labels, const std::vector<int>& numbers)
{
    for (int& label : labels)
        label = numbers[std::size_t(label)];
}

int freeParameters(const GaussianMixtureOptions& options, int features)
{
    const int covariances = options.covariance == MixtureCovariance::Full ? options.components : 1;
    return options.components - 1 + options.components * features +
           covariances * features * (features + 1) / 2;
}

} // namespace

std::optional<Error> GaussianMixtureOptions::validate() const
{
    for (auto problem : {countProblem(u"components"_s, components), countProblem(u"restarts"_s, restarts),
                         countProblem(u"maxIterations"_s, maxIterations)})
        if (problem)
            return problem;
    return {};
}

Expected<GaussianMixtureResult> gaussianMixture(const Eigen::MatrixXd& items,
                                                const GaussianMixtureOptions& options)
{
    if (const auto problem = options.validate())
        return tl::unexpected(*problem);
    if (const auto problem = clusterItemsProblem(items))
        return tl::unexpected(*problem);
    GaussianMixtureResult result;
    if (items.rows() < options.components || items.cols() == 0)
        return result;
    const double scale = powerOfTwoScale(items);
    auto transform = featureTransform(items * scale, FeatureScaling::ZScore);
    if (!transform)
        return tl::unexpected(transform.error());
    const Eigen::MatrixXd scores = transform->apply(items * scale);
    const ItemRows rows = scores;
    Run run = bestRun(scores, rows, options);

    transform->scale /= scale;
    transform->shift /= scale;
    // A density in units is that in z-scores over their scales.
    const double logUnits = double(items.rows()) * transform->scale.array().log().sum();
    const std::vector<int> numbers = numbersByAppearance(run.em->labels(), options.components);
    result.status = run.converged ? MixtureStatus::Converged : MixtureStatus::NotConverged;
    result.parameters = inUnits(run.em->parameters(), *transform, numbers);
    result.labels = run.em->labels();
    renumber(result.labels, numbers);
    const Eigen::MatrixXd probabilities = run.em->probabilities();
    result.probabilities.resizeLike(probabilities);
    for (std::size_t c = 0; c < numbers.size(); ++c)
        result.probabilities.col(numbers[c]) = probabilities.col(Eigen::Index(c));
    result.logLikelihood = run.em->logLikelihood() - logUnits;
    result.freeParameters = freeParameters(options, int(items.cols()));
    result.bic = -2 * result.logLikelihood + result.freeParameters * std::log(double(items.rows()));
    result.iterations = run.iterations;
    result.steps = std::move(run.steps);
    for (MixtureStep& step : result.steps) {
        step.parameters = inUnits(step.parameters, *transform, numbers);
        renumber(step.labels, numbers);
        step.logLikelihood -= logUnits;
        step.objective -= logUnits;
    }
    return result;
}

} // namespace gripscope
