// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/gaussian_mixture.h"

#include "core/recognition/cluster_items.h"
#include "core/recognition/feature_scaling.h"
#include "core/recognition/gaussian_mixture_em.h"
#include "core/recognition/kmeans.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int shortRun = 25;             ///< iterations by which the starts are compared
constexpr double leastGainAnItem = 1e-7; ///< of the objective
/// On longer tables the starts are compared on so many items, drawn by the seed.
constexpr Eigen::Index mostCompared = 10'000;

struct Run {
    std::vector<MixtureStep> steps;
    int iterations = 0;
    bool converged = false;
};

/// EM up to that many iterations.
Run proceed(MixtureEm& em, int mostIterations, Eigen::Index items, const GaussianMixtureOptions& options)
{
    Run run;
    const auto record = [&] {
        if (options.recordSteps)
            run.steps.push_back({em.parameters(), em.labels(), em.logLikelihood(), em.objective()});
    };
    em.expect();
    record();
    while (!run.converged && run.iterations < mostIterations && !isStopped(options.watch)) {
        const double before = em.objective();
        em.maximize();
        em.expect();
        ++run.iterations;
        record();
        run.converged = em.objective() - before < leastGainAnItem * double(items);
    }
    return run;
}

/// The different ends of single K-means runs, the seeds counted up.
std::vector<std::vector<int>> kMeansLabels(const Eigen::MatrixXd& items,
                                           const GaussianMixtureOptions& options)
{
    KMeansOptions start;
    start.clusters = options.components;
    start.restarts = 1;
    start.recordSteps = false;
    std::vector<std::vector<int>> found;
    for (int i = 0; i < options.restarts; ++i) {
        start.seed = options.seed + std::uint64_t(i);
        std::vector<int> labels = kMeans(items, start).value().labels; // the items are z-scores: no error
        if (std::find(found.begin(), found.end(), labels) == found.end())
            found.push_back(std::move(labels));
    }
    return found;
}

/// The start that a short run gets farthest from.
MixtureStart bestStart(const Eigen::MatrixXd& items, const GaussianMixtureOptions& options)
{
    GaussianMixtureOptions trial = options;
    trial.recordSteps = false;
    const ItemRows rows = items;
    const std::vector<std::vector<int>> labels = kMeansLabels(items, options);
    MixtureStart best = mixtureStart(rows, labels.front(), options.components);
    if (labels.size() == 1)
        return best;
    std::optional<double> highest;
    for (const std::vector<int>& own : labels) {
        MixtureStart start = mixtureStart(rows, own, options.components);
        MixtureEm em(rows, start, options.covariance);
        (void)proceed(em, std::min(shortRun, options.maxIterations), items.rows(), trial);
        if (!highest || em.objective() > *highest) {
            highest = em.objective();
            best = std::move(start);
        }
    }
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
    const Eigen::Index compared = std::max<Eigen::Index>(mostCompared, options.components);
    MixtureEm em(rows, bestStart(sampleOfItems(scores, compared, options.seed), options), options.covariance);
    Run run = proceed(em, options.maxIterations, rows.rows(), options);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());

    transform->scale /= scale;
    transform->shift /= scale;
    // A density in units is that in z-scores over their scales.
    const double logUnits = double(items.rows()) * transform->scale.array().log().sum();
    const std::vector<int> numbers = numbersByAppearance(em.labels(), options.components);
    result.status = run.converged ? MixtureStatus::Converged : MixtureStatus::NotConverged;
    result.parameters = inUnits(em.parameters(), *transform, numbers);
    result.labels = em.labels();
    renumber(result.labels, numbers);
    const Eigen::MatrixXd probabilities = em.probabilities();
    result.probabilities.resizeLike(probabilities);
    for (std::size_t c = 0; c < numbers.size(); ++c)
        result.probabilities.col(numbers[c]) = probabilities.col(Eigen::Index(c));
    result.logLikelihood = em.logLikelihood() - logUnits;
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
