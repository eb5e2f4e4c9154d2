// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_items.h"
#include "core/clustering/map_training.h"

#include <limits>
#include <numeric>

namespace gripscope {

namespace {

/// The groups so far, and for each the later one that it costs least to merge with.
class Merging {
public:
    Merging(const Eigen::MatrixXd& points, const Eigen::VectorXd& items)
        : m_means(points), m_items(items), m_partner(std::size_t(points.rows()), -1),
          m_cost(m_partner.size(), std::numeric_limits<double>::infinity())
    {
        for (int one = 0; one < int(points.rows()); ++one)
            findPartner(one);
    }

    /// The cheapest pair becomes one group, in the place of its first; both places are returned.
    std::pair<int, int> mergeCheapest()
    {
        std::size_t cheapest = 0;
        for (std::size_t i = 1; i < m_cost.size(); ++i)
            if (m_cost[i] < m_cost[cheapest])
                cheapest = i;
        const int kept = int(cheapest);
        const int gone = m_partner[cheapest];
        const double together = m_items(kept) + m_items(gone);
        m_means.row(kept) =
            (m_items(kept) * m_means.row(kept) + m_items(gone) * m_means.row(gone)) / together;
        m_items(kept) = together;
        m_items(gone) = 0;
        m_cost[std::size_t(gone)] = std::numeric_limits<double>::infinity();
        for (int i = 0; i < int(m_cost.size()); ++i) {
            const int partner = m_partner[std::size_t(i)];
            if (m_items(i) > 0 && (i == kept || partner == kept || partner == gone))
                findPartner(i);
            else if (m_items(i) > 0 && i < kept)
                offer(i, kept);
        }
        return {kept, gone};
    }

private:
    void offer(int one, int other)
    {
        const double cost = m_items(one) * m_items(other) / (m_items(one) + m_items(other)) *
                            (m_means.row(one) - m_means.row(other)).squaredNorm();
        if (cost < m_cost[std::size_t(one)]) {
            m_cost[std::size_t(one)] = cost;
            m_partner[std::size_t(one)] = other;
        }
    }
    void findPartner(int one)
    {
        m_cost[std::size_t(one)] = std::numeric_limits<double>::infinity();
        m_partner[std::size_t(one)] = -1;
        for (int other = one + 1; other < int(m_items.size()); ++other)
            if (m_items(other) > 0)
                offer(one, other);
    }

    ItemRows m_means;
    Eigen::VectorXd m_items; ///< 0: merged away
    std::vector<int> m_partner;
    std::vector<double> m_cost;
};

} // namespace

std::vector<int> wardGroups(const Eigen::MatrixXd& points, const Eigen::VectorXd& items, int groups)
{
    std::vector<int> place(std::size_t(points.rows()));
    std::iota(place.begin(), place.end(), 0);
    Merging merging(points, items);
    for (int left = int(points.rows()); left > groups; --left) {
        const auto merged = merging.mergeCheapest();
        for (int& own : place)
            if (own == merged.second)
                own = merged.first;
    }
    const std::vector<int> numbers = numbersByAppearance(place, int(points.rows()));
    for (int& own : place)
        own = numbers[std::size_t(own)];
    return place;
}

} // namespace gripscope
