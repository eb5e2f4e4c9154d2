// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/nearest_in_block.h"

#include <cstring>
#include <limits>

namespace gripscope {

namespace {

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

} // namespace gripscope
