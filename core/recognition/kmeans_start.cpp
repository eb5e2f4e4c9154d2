// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/kmeans_start.h"

#include "core/recognition/cluster_items.h"

#include <algorithm>
#include <limits>

namespace gripscope {

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

} // namespace

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

} // namespace gripscope
