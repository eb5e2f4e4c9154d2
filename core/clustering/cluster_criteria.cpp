// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"
#include "core/clustering/cluster_advice.h"
#include "core/clustering/cluster_items.h"
#include "core/math/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace gripscope {

namespace {

/// The box along the principal axes that holds the items.
struct ReferenceBox {
    PrincipalAxes axes;
    Eigen::RowVectorXd low, width;

    explicit ReferenceBox(const Eigen::MatrixXd& items) : axes(principalAxes(items))
    {
        const Eigen::MatrixXd along = (items.rowwise() - axes.mean) * axes.directions;
        low = along.colwise().minCoeff();
        width = along.colwise().maxCoeff() - low;
    }
    [[nodiscard]] Eigen::MatrixXd draw(Eigen::Index items, std::mt19937_64& random) const
    {
        Eigen::MatrixXd along(items, width.size());
        for (Eigen::Index i = 0; i < items; ++i)
            for (Eigen::Index j = 0; j < width.size(); ++j)
                along(i, j) = low(j) + uniformNumber(random) * width(j);
        return (along * axes.directions.transpose()).rowwise() + axes.mean;
    }
};

/// ln W* of one reference for each number of clusters.
Eigen::VectorXd referenceLogs(const Eigen::MatrixXd& reference, Eigen::Index most, const GapOptions& options)
{
    KMeansOptions clusters;
    clusters.restarts = options.restarts;
    clusters.seed = options.seed;
    clusters.recordSteps = false;
    Eigen::VectorXd logs(most);
    for (Eigen::Index k = 0; k < most; ++k) {
        clusters.clusters = int(k) + 1;
        const auto found = kMeans(reference, clusters);
        logs(k) = found && found->inertia > 0 ? std::log(found->inertia) : std::nan("");
    }
    return logs;
}

} // namespace

std::vector<std::optional<GapStatistic>>
gapStatistics(const Eigen::MatrixXd& items, const std::vector<double>& inertias, const GapOptions& options)
{
    std::vector<std::optional<GapStatistic>> gaps(inertias.size());
    if (items.rows() == 0 || options.references < 1)
        return gaps;
    const double scale = powerOfTwoScale(items);
    const Eigen::MatrixXd scaled = items * scale;
    const ReferenceBox box(scaled);
    std::mt19937_64 random(options.seed);
    Eigen::MatrixXd logs(Eigen::Index(inertias.size()), options.references);
    for (Eigen::Index reference = 0; reference < options.references; ++reference) {
        if (isStopped(options.watch))
            return gaps;
        logs.col(reference) = referenceLogs(box.draw(items.rows(), random), logs.rows(), options);
        if (options.watch)
            options.watch->setShare(options.shareBefore +
                                    (1 - options.shareBefore) * double(reference + 1) / options.references);
    }
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        const Eigen::VectorXd own = logs.row(Eigen::Index(k));
        if (!(inertias[k] > 0) || !own.allFinite())
            continue;
        const double deviation = std::sqrt((own.array() - own.mean()).square().mean());
        gaps[k] = GapStatistic{own.mean() - std::log(inertias[k]) - 2 * std::log(scale),
                               deviation * std::sqrt(1 + 1.0 / options.references)};
    }
    return gaps;
}

std::optional<int> clustersByGap(const std::vector<std::optional<GapStatistic>>& gaps)
{
    for (std::size_t top = 0; top + 1 < gaps.size() && gaps[top] && gaps[top + 1]; ++top) {
        if (gaps[top]->value < gaps[top + 1]->value)
            continue;
        std::size_t smallest = 0;
        while (gaps[smallest]->value < gaps[top]->value - gaps[top]->error)
            ++smallest;
        return int(smallest) + 1;
    }
    return {};
}

namespace {

/// The clusters that have items, numbered anew without gaps.
struct Partition {
    std::vector<int> labels;
    Eigen::VectorXd counts;
    Eigen::MatrixXd means; ///< clusters x features
};

Partition partition(const Eigen::MatrixXd& items, const std::vector<int>& labels)
{
    Partition found;
    if (labels.empty())
        return found;
    const int most = 1 + *std::max_element(labels.begin(), labels.end());
    const std::vector<int> numbers = numbersByAppearance(labels, most);
    int clusters = 0;
    for (const int label : labels) {
        found.labels.push_back(numbers[std::size_t(label)]);
        clusters = std::max(clusters, found.labels.back() + 1);
    }
    found.counts = Eigen::VectorXd::Zero(clusters);
    found.means = Eigen::MatrixXd::Zero(clusters, items.cols());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        found.counts(found.labels[i]) += 1;
        found.means.row(found.labels[i]) += items.row(Eigen::Index(i));
    }
    found.means.array().colwise() /= found.counts.array();
    return found;
}

/// (b - a) / max(a, b) of one item. `distances` has room for a number a cluster.
double itemSilhouette(const ItemRows& items, const Partition& groups, Eigen::Index item,
                      Eigen::VectorXd& distances)
{
    const int own = groups.labels[std::size_t(item)];
    if (groups.counts(own) < 2)
        return 0;
    distances.setZero();
    for (Eigen::Index other = 0; other < items.rows(); ++other)
        distances(groups.labels[std::size_t(other)]) += (items.row(item) - items.row(other)).norm();
    const double a = distances(own) / (groups.counts(own) - 1);
    double b = std::numeric_limits<double>::infinity();
    for (Eigen::Index c = 0; c < distances.size(); ++c)
        if (c != own)
            b = std::min(b, distances(c) / groups.counts(c));
    const double larger = std::max(a, b);
    return larger > 0 ? (b - a) / larger : 0;
}

} // namespace

std::optional<double> silhouette(const Eigen::MatrixXd& items, const std::vector<int>& labels)
{
    const Partition groups = partition(items, labels);
    if (groups.counts.size() < 2 || groups.counts.size() >= items.rows())
        return {};
    const ItemRows rows = items;
    Eigen::VectorXd all(rows.rows());
    forEachChunk(std::size_t(rows.rows()), [&](const Chunk& chunk) {
        Eigen::VectorXd distances(groups.counts.size());
        for (auto i = Eigen::Index(chunk.begin); i < Eigen::Index(chunk.end); ++i)
            all(i) = itemSilhouette(rows, groups, i, distances);
    });
    return all.mean();
}

std::optional<double> calinskiHarabasz(const Eigen::MatrixXd& items, const std::vector<int>& labels)
{
    const Partition groups = partition(items, labels);
    const auto clusters = double(groups.counts.size());
    const auto count = double(items.rows());
    if (clusters < 2 || clusters >= count)
        return {};
    const double within = inertiaOf(items, groups.labels, groups.means);
    const Eigen::RowVectorXd mean = items.colwise().mean();
    const double between = groups.counts.dot((groups.means.rowwise() - mean).rowwise().squaredNorm());
    if (!(within > 0))
        return {};
    return (between / (clusters - 1)) / (within / (count - clusters));
}

std::optional<double> daviesBouldin(const Eigen::MatrixXd& items, const std::vector<int>& labels)
{
    const Partition groups = partition(items, labels);
    const Eigen::Index clusters = groups.counts.size();
    if (clusters < 2 || clusters >= items.rows())
        return {};
    Eigen::VectorXd width = Eigen::VectorXd::Zero(clusters);
    for (Eigen::Index i = 0; i < items.rows(); ++i) {
        const int label = groups.labels[std::size_t(i)];
        width(label) += (items.row(i) - groups.means.row(label)).norm() / groups.counts(label);
    }
    double sum = 0;
    for (Eigen::Index one = 0; one < clusters; ++one) {
        double worst = 0;
        for (Eigen::Index other = 0; other < clusters; ++other) {
            const double apart = (groups.means.row(one) - groups.means.row(other)).norm();
            if (other == one)
                continue;
            if (!(apart > 0))
                return {};
            worst = std::max(worst, (width(one) + width(other)) / apart);
        }
        sum += worst;
    }
    return sum / double(clusters);
}

} // namespace gripscope
