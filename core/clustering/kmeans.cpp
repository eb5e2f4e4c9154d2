// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/kmeans.h"

#include "core/base/words.h"
#include "core/clustering/cluster_items.h"
#include "core/clustering/kmeans_assignment.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// An item drawn with probability proportional to its weight; where all weights are 0, any item alike.
Eigen::Index draw(const Eigen::VectorXd& weights, std::mt19937_64& random)
{
    const double total = weights.sum();
    const double u = uniformNumber(random);
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

/// Squared distance of every item from `centre`.
Eigen::VectorXd squaredDistances(const Eigen::MatrixXd& items, const Eigen::RowVectorXd& centre)
{
    Eigen::VectorXd distances = (items.col(0).array() - centre(0)).square();
    for (Eigen::Index j = 1; j < items.cols(); ++j)
        distances.array() += (items.col(j).array() - centre(j)).square();
    return distances;
}

/// The first centres of K-means by greedy k-means++: the first is any item; each further one is, of
/// `candidates` items drawn with probability proportional to the squared distance from the nearest centre so
/// far, the one that lowers the sum of these distances most.
/// Source: Arthur and Vassilvitskii, k-means++: the advantages of careful seeding (2007), section 2.2 and
/// their code's greedy variant.
Eigen::MatrixXd startingCentres(const Eigen::MatrixXd& items, int clusters, int candidates,
                                std::mt19937_64& random)
{
    Eigen::MatrixXd centres(clusters, items.cols());
    centres.row(0) = items.row(draw(Eigen::VectorXd::Ones(items.rows()), random));
    Eigen::VectorXd nearest = squaredDistances(items, centres.row(0));
    for (int c = 1; c < clusters; ++c) {
        double best = std::numeric_limits<double>::infinity();
        Eigen::VectorXd bestNearest;
        for (int candidate = 0; candidate < candidates; ++candidate) {
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

/// A gain smaller than this share is rounding.
constexpr double leastGain = 1e-9;
/// Each pass with a move lowers J; this only bounds the time.
constexpr int mostPasses = 100;

struct Clusters {
    const ItemRows& items;
    std::vector<int> labels;
    ItemRows means;
    Eigen::VectorXd counts;
    double rounding = 0; ///< what a mean of items in one place may be off it, squared

    void computeMeans()
    {
        means.setZero();
        counts.setZero();
        for (Eigen::Index i = 0; i < items.rows(); ++i) {
            means.row(labels[std::size_t(i)]) += items.row(i);
            counts(labels[std::size_t(i)]) += 1;
        }
        for (Eigen::Index c = 0; c < counts.size(); ++c)
            if (counts(c) > 0)
                means.row(c) /= counts(c);
    }

    /// The cluster where the item belongs, the others as they are.
    [[nodiscard]] int best(Eigen::Index item) const
    {
        int found = labels[std::size_t(item)];
        const double own = counts(found);
        if (own < 2)
            return found;
        const double squared = (items.row(item) - means.row(found)).squaredNorm();
        if (squared <= rounding)
            return found;
        double least = own / (own - 1) * squared * (1 - leastGain);
        for (Eigen::Index c = 0; c < counts.size(); ++c) {
            const double cost = counts(c) / (counts(c) + 1) * (items.row(item) - means.row(c)).squaredNorm();
            if (c != labels[std::size_t(item)] && cost < least) {
                least = cost;
                found = int(c);
            }
        }
        return found;
    }

    void move(Eigen::Index item, int to)
    {
        const int from = labels[std::size_t(item)];
        means.row(from) += (means.row(from) - items.row(item)) / (counts(from) - 1);
        means.row(to) += (items.row(item) - means.row(to)) / (counts(to) + 1);
        counts(from) -= 1;
        counts(to) += 1;
        labels[std::size_t(item)] = to;
    }
};

/// Where Lloyd's iteration stands still, J may still fall when a single item changes its cluster, because
/// both means move with it: from cluster a to b when
///     n_b / (n_b + 1) |x - c_b|^2 < n_a / (n_a - 1) |x - c_a|^2 .
/// Passes over the items make such moves until none is left. The means afterwards, or nothing when there was
/// no move. `items`: finite, of a size whose squares neither vanish nor overflow; `labels` from 0, below
/// `clusters`.
/// Source: Hartigan, Clustering Algorithms (1975); Telgarsky and Vattani, Hartigan's method (2010), who show
/// that where it stands still Lloyd's iteration does too.
std::optional<Eigen::MatrixXd> meansAfterSingleMoves(const ItemRows& items, std::vector<int> labels,
                                                     int clusters)
{
    Clusters state{items, std::move(labels), ItemRows(clusters, items.cols()), Eigen::VectorXd(clusters),
                   roundingOfMeans(items) * roundingOfMeans(items)};
    state.computeMeans();
    bool moved = false;
    bool again = true;
    for (int pass = 0; pass < mostPasses && again; ++pass) {
        again = false;
        for (Eigen::Index i = 0; i < items.rows(); ++i)
            if (const int to = state.best(i); to != state.labels[std::size_t(i)]) {
                state.move(i, to);
                again = moved = true;
            }
    }
    if (!moved)
        return {};
    state.computeMeans(); // without the rounding of the moves
    return state.means;
}

/// With more items than this a single one moves no mean to speak of.
constexpr Eigen::Index mostItemsForSingleMoves = 8192;

/// Widths of the table: farther off, distances have no digits left to tell items by.
constexpr double farthestStart = 1e150;

enum class Polish { No, Yes };

/// Lloyd's iteration from these centres, and single moves wherever it stands still.
KMeansResult runFrom(ItemRows items, const Eigen::MatrixXd& centres, const KMeansOptions& options,
                     Polish polish)
{
    const int clusters = int(centres.rows());
    KMeansAssignment assignment(std::move(items), clusters);
    KMeansResult result;
    const auto assign = [&](const Eigen::MatrixXd& centroids) {
        const std::size_t changed = assignment.assign(centroids);
        if (options.recordSteps)
            result.steps.push_back({assignment.centroids(), assignment.labels(), assignment.inertia()});
        return changed;
    };
    assign(centres);
    std::optional<Eigen::MatrixXd> next = assignment.means();
    while (next && result.iterations < options.maxIterations && !isStopped(options.watch)) {
        ++result.iterations;
        if (assign(*next) > 0)
            next = assignment.means();
        else if (polish == Polish::Yes && assignment.items().rows() <= mostItemsForSingleMoves)
            next = meansAfterSingleMoves(assignment.items(), assignment.labels(), clusters);
        else
            next.reset();
    }
    result.status = next ? KMeansStatus::NotConverged : KMeansStatus::Converged;
    result.centroids = assignment.centroids();
    result.inertia = assignment.inertia();
    result.labels = assignment.takeLabels();
    return result;
}

void renumber(Eigen::MatrixXd& centroids, std::vector<int>& labels, const std::vector<int>& numbers)
{
    const Eigen::MatrixXd before = centroids;
    for (std::size_t c = 0; c < numbers.size(); ++c)
        centroids.row(numbers[c]) = before.row(Eigen::Index(c));
    for (int& label : labels)
        label = numbers[std::size_t(label)];
}

/// Numbers the clusters by appearance and goes back from items that were multiplied by `scale`.
void finish(KMeansResult& result, double scale)
{
    const std::vector<int> numbers = numbersByAppearance(result.labels, int(result.centroids.rows()));
    renumber(result.centroids, result.labels, numbers);
    result.centroids /= scale;
    result.inertia = result.inertia / scale / scale;
    for (KMeansStep& step : result.steps) {
        renumber(step.centroids, step.labels, numbers);
        step.centroids /= scale;
        step.inertia = step.inertia / scale / scale;
    }
}

std::optional<Error> problemWith(const Eigen::MatrixXd& items, const KMeansOptions& options)
{
    if (auto problem = options.validate())
        return problem;
    return clusterItemsProblem(items);
}

} // namespace

std::optional<Error> KMeansOptions::validate() const
{
    for (auto problem :
         {countProblem(u"clusters"_s, clusters), countProblem(u"restarts"_s, restarts),
          countProblem(u"candidates"_s, candidates), countProblem(u"maxIterations"_s, maxIterations)})
        if (problem)
            return problem;
    return {};
}

Expected<KMeansResult> kMeans(const Eigen::MatrixXd& items, const KMeansOptions& options)
{
    RETURN_IF_ERROR(problemWith(items, options));
    KMeansResult best;
    if (items.rows() < options.clusters || items.cols() == 0)
        return best;
    const double scale = powerOfTwoScale(items);
    const Eigen::MatrixXd scaled = items * scale;
    std::mt19937_64 random(options.seed);
    for (int run = 0; run < options.restarts; ++run) {
        KMeansResult result =
            runFrom(scaled, startingCentres(scaled, options.clusters, options.candidates, random), options,
                    Polish::Yes);
        if (isStopped(options.watch))
            return tl::unexpected(clusteringCancelled());
        if (run == 0 || result.inertia < best.inertia)
            best = std::move(result);
    }
    finish(best, scale);
    return best;
}

Expected<KMeansResult> kMeansFrom(const Eigen::MatrixXd& items, const Eigen::MatrixXd& centres,
                                  const KMeansOptions& options)
{
    RETURN_IF_ERROR(problemWith(items, options));
    if (centres.rows() == 0 || centres.cols() != items.cols() || !centres.allFinite())
        return failure(ErrorCode::Usage, {Words::say("The centres to start from do not fit the table.")});
    if (items.rows() < centres.rows() || items.cols() == 0)
        return KMeansResult{};
    const double scale = powerOfTwoScale(items);
    const Eigen::MatrixXd start = centres * scale;
    if (!(start.cwiseAbs().maxCoeff() < farthestStart))
        return failure(ErrorCode::BadInput,
                       {Words::say("The centres to start from"), Words::say("found one too far away"),
                        Words::say("expected centres near the items")});
    KMeansResult result = runFrom(items * scale, start, options, Polish::No);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());
    finish(result, scale);
    return result;
}

} // namespace gripscope
