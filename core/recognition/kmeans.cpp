// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/kmeans.h"

#include "core/recognition/cluster_items.h"
#include "core/recognition/kmeans_assignment.h"
#include "core/recognition/kmeans_single_moves.h"
#include "core/recognition/kmeans_start.h"
#include "core/words.h"

#include <random>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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
    result.labels = assignment.labels();
    result.centroids = assignment.centroids();
    result.inertia = assignment.inertia();
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
    if (const auto problem = problemWith(items, options))
        return tl::unexpected(*problem);
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
    if (const auto problem = problemWith(items, options))
        return tl::unexpected(*problem);
    if (centres.rows() == 0 || centres.cols() != items.cols() || !centres.allFinite())
        return failure(ErrorCode::Usage, {Words::tr("The centres to start from do not fit the table.")});
    if (items.rows() < centres.rows() || items.cols() == 0)
        return KMeansResult{};
    const double scale = powerOfTwoScale(items);
    const Eigen::MatrixXd start = centres * scale;
    if (!(start.cwiseAbs().maxCoeff() < farthestStart))
        return failure(ErrorCode::BadInput,
                       {Words::tr("The centres to start from"), Words::tr("found one too far away"),
                        Words::tr("expected centres near the items")});
    KMeansResult result = runFrom(items * scale, start, options, Polish::No);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());
    finish(result, scale);
    return result;
}

} // namespace gripscope
