// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/kmeans_assignment.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace gripscope {

namespace {

constexpr auto inBlock = std::size_t(blockItems);
static_assert(itemsInChunk % inBlock == 0);

constexpr double farthest = std::numeric_limits<double>::infinity();

#ifdef __x86_64__
/// Four items side by side, for processors with AVX2. The compiler does not find this by itself, and a wider
/// type than the processor's it takes apart into single numbers.
using FourItems = double __attribute__((vector_size(32)));
using FourLabels = int __attribute__((vector_size(16)));
constexpr Eigen::Index itemsAtOnce = 4;
static_assert(blockItems % itemsAtOnce == 0);

template <int Features>
[[gnu::target("avx2")]] int assignFourByFour(const double* columns, Eigen::Index count,
                                             const ItemRows& centroids, int* labels)
{
    const Eigen::Index features = Features > 0 ? Features : count;
    FourLabels minusChanged = FourLabels{}; // -1 for each
    for (Eigen::Index i = 0; i < blockItems; i += itemsAtOnce) {
        FourItems least = FourItems{} + farthest;
        FourItems number = FourItems{};
        const double* centroid = centroids.data();
        for (Eigen::Index c = 0; c < centroids.rows(); ++c, centroid += features) {
            FourItems squared = FourItems{};
            for (Eigen::Index j = 0; j < features; ++j) {
                FourItems off;
                std::memcpy(&off, columns + j * blockItems + i, sizeof off);
                off -= centroid[j];
                squared += off * off;
            }
            const auto closer = squared < least;
            number = closer ? FourItems{} + double(c) : number;
            least = closer ? squared : least;
        }
        const FourLabels now = __builtin_convertvector(number, FourLabels);
        FourLabels before;
        std::memcpy(&before, labels + i, sizeof before);
        minusChanged += now != before;
        std::memcpy(labels + i, &now, sizeof now);
    }
    return -(minusChanged[0] + minusChanged[1] + minusChanged[2] + minusChanged[3]);
}
#endif

} // namespace

int detail::assignOneByOne(const double* columns, Eigen::Index features, const ItemRows& centroids,
                           int* labels)
{
    int changed = 0;
    for (Eigen::Index i = 0; i < blockItems; ++i) {
        double least = farthest;
        int nearest = 0;
        for (Eigen::Index c = 0; c < centroids.rows(); ++c) {
            double squared = 0;
            for (Eigen::Index j = 0; j < features; ++j) {
                const double off = columns[j * blockItems + i] - centroids(c, j);
                squared += off * off;
            }
            if (squared < least) {
                least = squared;
                nearest = int(c);
            }
        }
        changed += nearest != labels[i];
        labels[i] = nearest;
    }
    return changed;
}

int assignBlock(const double* columns, Eigen::Index features, const ItemRows& centroids, int* labels)
{
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) {
        if (features == 3) // mass, damping, stiffness
            return assignFourByFour<3>(columns, features, centroids, labels);
        return assignFourByFour<0>(columns, features, centroids, labels);
    }
#endif
    return detail::assignOneByOne(columns, features, centroids, labels);
}

BlockAssignment::BlockAssignment(const ItemRows& items, int clusters)
    : m_features(items.cols()), m_clusters(clusters)
{
    const std::size_t blocks = (std::size_t(items.rows()) + inBlock - 1) / inBlock;
    m_columns = std::make_unique_for_overwrite<double[]>(blocks * inBlock * std::size_t(m_features));
    m_sums.assign(blocks * std::size_t(m_clusters * (m_features + 1)), 0);
    forEachChunk(std::size_t(items.rows()), [&](const Chunk& chunk) {
        for (std::size_t begin = chunk.begin; begin < chunk.end; begin += inBlock) {
            const auto rows = Eigen::Index(std::min(chunk.end - begin, inBlock));
            Eigen::Map<Eigen::MatrixXd> block(m_columns.get() + begin * std::size_t(m_features), blockItems,
                                              m_features);
            block.topRows(rows) = items.middleRows(Eigen::Index(begin), rows);
            block.bottomRows(blockItems - rows).setZero();
        }
    });
}

const double* BlockAssignment::columnsOf(std::size_t block) const
{
    return m_columns.get() + block * inBlock * std::size_t(m_features);
}

void BlockAssignment::addUp(std::size_t block, const int* labels, std::size_t count)
{
    const Eigen::Index width = m_features + 1;
    double* sums = m_sums.data() + block * std::size_t(m_clusters * width);
    std::fill_n(sums, m_clusters * width, 0.0);
    const double* columns = columnsOf(block);
    for (std::size_t i = 0; i < count; ++i) {
        double* sum = sums + labels[i] * width;
        for (Eigen::Index j = 0; j < m_features; ++j)
            sum[j] += columns[j * blockItems + Eigen::Index(i)];
        sum[m_features] += 1;
    }
}

std::size_t BlockAssignment::assign(const Chunk& chunk, const ItemRows& centroids, std::vector<int>& labels,
                                    ClusterSums& sums)
{
    using Map = Eigen::Map<const ItemRows>;
    ItemRows all = ItemRows::Zero(m_clusters, m_features + 1);
    std::size_t changed = 0;
    for (std::size_t begin = chunk.begin; begin < chunk.end; begin += inBlock) {
        const std::size_t block = begin / inBlock;
        const std::size_t count = std::min(chunk.end - begin, inBlock);
        int* own = labels.data() + begin;
        int moved = 0;
        if (count == inBlock) {
            moved = assignBlock(columnsOf(block), m_features, centroids, own);
        } else { // the last one, filled up with items that are none
            std::array<int, inBlock> filled{};
            assignBlock(columnsOf(block), m_features, centroids, filled.data());
            for (std::size_t i = 0; i < count; ++i)
                moved += own[i] != filled[i];
            std::copy_n(filled.begin(), count, own);
        }
        if (moved > 0)
            addUp(block, own, count);
        changed += std::size_t(moved);
        all += Map(m_sums.data() + block * std::size_t(all.size()), m_clusters, m_features + 1);
    }
    sums.sums = all.leftCols(m_features);
    sums.items = all.col(m_features);
    return changed;
}

} // namespace gripscope
