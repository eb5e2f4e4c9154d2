// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_items.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gripscope {

using namespace Qt::StringLiterals;

std::optional<Error> clusterItemsProblem(const Eigen::MatrixXd& items)
{
    if (items.size() == 0)
        return {};
    const double reach = items.maxCoeff() - items.minCoeff();
    if (items.allFinite() && std::isfinite(reach * reach * double(items.size())) &&
        std::isfinite(items.cwiseAbs().maxCoeff() * double(items.rows())))
        return {};
    return Error{ErrorCode::BadInput,
                 {Words::say("The table to be clustered"),
                  Words::say("found numbers that are not finite or too large"),
                  Words::say("expected finite ones whose squares can be added")}};
}

Error clusteringCancelled()
{
    return {ErrorCode::Cancelled, {Words::say("The grouping")}};
}

std::optional<Error> countProblem(const QString& name, int value)
{
    if (value >= 1)
        return {};
    return Error{ErrorCode::Usage, {Words::say("%1 must be at least 1, not %2.").arg(name).arg(value)}};
}

double powerOfTwoScale(const Eigen::MatrixXd& items)
{
    if (items.size() == 0)
        return 1;
    const double reach = (items.colwise().maxCoeff() - items.colwise().minCoeff()).maxCoeff();
    if (!(reach > 0) || !std::isfinite(reach))
        return 1;
    // No number may overflow by it: neither those of a column without width, nor the factor itself.
    const int largest = std::ilogb(std::max(items.cwiseAbs().maxCoeff(), 1.0));
    return std::ldexp(1.0, std::min(-std::ilogb(reach), 500 - largest));
}

double roundingOfMeans(const ItemRows& items)
{
    return 1e-12 * items.cwiseAbs().maxCoeff();
}

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

double inertiaOf(const Eigen::MatrixXd& items, const std::vector<int>& labels,
                 const Eigen::MatrixXd& centroids)
{
    double inertia = 0;
    for (Eigen::Index i = 0; i < items.rows(); ++i)
        inertia += (items.row(i) - centroids.row(labels[std::size_t(i)])).squaredNorm();
    return inertia;
}

Eigen::MatrixXd sampleOfItems(const Eigen::MatrixXd& items, Eigen::Index most, std::uint64_t seed)
{
    if (items.rows() <= most)
        return items;
    std::mt19937_64 random(seed);
    Eigen::MatrixXd sample(most, items.cols());
    // Selection sampling (Knuth, TAOCP 3.4.2 S): each item with probability (still wanted) / (still to come).
    Eigen::Index taken = 0;
    for (Eigen::Index i = 0; i < items.rows() && taken < most; ++i)
        if (uniformNumber(random) * double(items.rows() - i) < double(most - taken))
            sample.row(taken++) = items.row(i);
    return sample;
}

} // namespace gripscope
