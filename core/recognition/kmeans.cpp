// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/kmeans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// 53 random bits as a number in [0, 1): std::uniform_real_distribution differs between standard libraries.
double uniform(std::mt19937_64& random)
{
    return double(random() >> 11) * 0x1p-53;
}

/// An item drawn with probability proportional to its weight; where all weights are 0, any item alike.
Eigen::Index draw(const Eigen::VectorXd& weights, std::mt19937_64& random)
{
    const double total = weights.sum();
    const double u = uniform(random);
    if (!(total > 0))
        return std::min(Eigen::Index(u * double(weights.size())), weights.size() - 1);
    double left = u * total;
    Eigen::Index last = 0;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
        if (weights(i) <= 0)
            continue;
        last = i;
        left -= weights(i);
        if (left < 0)
            break;
    }
    return last;
}

Eigen::VectorXd squaredDistances(const Eigen::MatrixXd& items, const Eigen::RowVectorXd& centre)
{
    return (items.rowwise() - centre).rowwise().squaredNorm();
}

/// Greedy k-means++: of some candidates drawn by squared distance, the one that lowers J most becomes a
/// centre.
Eigen::MatrixXd startingCentres(const Eigen::MatrixXd& items, const KMeansOptions& options,
                                std::mt19937_64& random)
{
    Eigen::MatrixXd centres(options.clusters, items.cols());
    centres.row(0) = items.row(draw(Eigen::VectorXd::Ones(items.rows()), random));
    Eigen::VectorXd nearest = squaredDistances(items, centres.row(0));
    for (int c = 1; c < options.clusters; ++c) {
        double best = std::numeric_limits<double>::infinity();
        Eigen::VectorXd bestNearest;
        for (int candidate = 0; candidate < options.candidates; ++candidate) {
            const Eigen::Index i = draw(nearest, random);
            Eigen::VectorXd distances = squaredDistances(items, items.row(i)).cwiseMin(nearest);
            if (const double potential = distances.sum(); potential < best) {
                best = potential;
                bestNearest = std::move(distances);
                centres.row(c) = items.row(i);
            }
        }
        nearest = std::move(bestNearest);
    }
    return centres;
}

/// Every item to its nearest centre; the lowest number of equals.
KMeansStep assign(const Eigen::MatrixXd& items, Eigen::MatrixXd centroids)
{
    KMeansStep step;
    step.labels.resize(std::size_t(items.rows()));
    for (Eigen::Index i = 0; i < items.rows(); ++i) {
        Eigen::Index nearest = 0;
        step.inertia += (centroids.rowwise() - items.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
        step.labels[std::size_t(i)] = int(nearest);
    }
    step.centroids = std::move(centroids);
    return step;
}

/// The means of the clusters. One that lost all its items moves to the item farthest from its own centre,
/// which lowers J most of all single moves.
Eigen::MatrixXd means(const Eigen::MatrixXd& items, const KMeansStep& step)
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(step.centroids.rows(), items.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(step.centroids.rows());
    Eigen::VectorXd distances(items.rows());
    for (Eigen::Index i = 0; i < items.rows(); ++i) {
        const int label = step.labels[std::size_t(i)];
        sums.row(label) += items.row(i);
        counts(label) += 1;
        distances(i) = (items.row(i) - step.centroids.row(label)).squaredNorm();
    }
    for (Eigen::Index c = 0; c < sums.rows(); ++c) {
        if (counts(c) > 0) {
            sums.row(c) /= counts(c);
            continue;
        }
        Eigen::Index farthest = 0;
        distances.maxCoeff(&farthest);
        distances(farthest) = 0; // the next empty cluster takes another one
        sums.row(c) = items.row(farthest);
    }
    return sums;
}

KMeansResult runOnce(const Eigen::MatrixXd& items, const KMeansOptions& options, std::mt19937_64& random)
{
    KMeansResult result;
    result.status = KMeansStatus::NotConverged;
    result.steps.push_back(assign(items, startingCentres(items, options, random)));
    while (result.iterations < options.maxIterations) {
        ++result.iterations;
        result.steps.push_back(assign(items, means(items, result.steps.back())));
        if (result.steps.back().labels == result.steps[result.steps.size() - 2].labels) {
            result.status = KMeansStatus::Converged;
            break;
        }
    }
    result.inertia = result.steps.back().inertia;
    return result;
}

/// New numbers for the clusters, by first appearance in the table; those without items come last.
std::vector<int> numbersByAppearance(const std::vector<int>& labels, int clusters)
{
    std::vector<int> numbers(std::size_t(clusters), -1);
    int next = 0;
    for (int label : labels)
        if (numbers[std::size_t(label)] < 0)
            numbers[std::size_t(label)] = next++;
    for (int& number : numbers)
        if (number < 0)
            number = next++;
    return numbers;
}

void renumber(KMeansResult& result, int clusters)
{
    const std::vector<int> numbers = numbersByAppearance(result.steps.back().labels, clusters);
    for (KMeansStep& step : result.steps) {
        const Eigen::MatrixXd centroids = step.centroids;
        for (int c = 0; c < clusters; ++c)
            step.centroids.row(numbers[std::size_t(c)]) = centroids.row(c);
        for (int& label : step.labels)
            label = numbers[std::size_t(label)];
    }
    result.labels = result.steps.back().labels;
    result.centroids = result.steps.back().centroids;
}

/// Whether all sums and squared distances of these items stay below the largest number.
bool computable(const Eigen::MatrixXd& items)
{
    if (items.size() == 0)
        return true;
    const double reach = items.maxCoeff() - items.minCoeff();
    return items.allFinite() && std::isfinite(reach * reach * double(items.size())) &&
           std::isfinite(items.cwiseAbs().maxCoeff() * double(items.rows()));
}

} // namespace

std::optional<Error> KMeansOptions::validate() const
{
    const auto atLeastOne = [](const QString& name, int value) -> std::optional<Error> {
        if (value >= 1)
            return {};
        return Error{ErrorCode::Usage, {u"%1 must be at least 1, not %2."_s.arg(name).arg(value)}};
    };
    for (auto problem :
         {atLeastOne(u"clusters"_s, clusters), atLeastOne(u"restarts"_s, restarts),
          atLeastOne(u"candidates"_s, candidates), atLeastOne(u"maxIterations"_s, maxIterations)})
        if (problem)
            return problem;
    return {};
}

Expected<KMeansResult> kMeans(const Eigen::MatrixXd& items, const KMeansOptions& options)
{
    if (const auto problem = options.validate())
        return tl::unexpected(*problem);
    if (!computable(items))
        return failure(ErrorCode::BadInput,
                       {u"The table to be clustered"_s, u"found numbers that are not finite or too large"_s,
                        u"expected finite ones whose squares can be added"_s});
    KMeansResult best;
    if (items.rows() < options.clusters || items.cols() == 0)
        return best;
    std::mt19937_64 random(options.seed);
    for (int run = 0; run < options.restarts; ++run) {
        KMeansResult result = runOnce(items, options, random);
        if (run == 0 || result.inertia < best.inertia)
            best = std::move(result);
    }
    renumber(best, options.clusters);
    return best;
}

} // namespace gripscope
