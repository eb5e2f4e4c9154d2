// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/kmeans_single_moves.h"

namespace gripscope {

namespace {

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

} // namespace

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

} // namespace gripscope
