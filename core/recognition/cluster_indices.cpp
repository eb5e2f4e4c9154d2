// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/cluster_indices.h"

#include "core/recognition/cluster_items.h"
#include "core/recognition/parallel_chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

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
