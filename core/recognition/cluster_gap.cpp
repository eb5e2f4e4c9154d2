// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/cluster_gap.h"

#include "core/recognition/cluster_items.h"
#include "core/recognition/principal_axes.h"

#include <cmath>
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

} // namespace gripscope
