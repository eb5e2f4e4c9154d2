// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/kmeans_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gripscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Up to so many all distances are measured.
constexpr int fewCentroids = 8;
/// |a - b|^2, added in the order of the features; `Features` 0: as many as `count`.
template <int Features>
double squaredDistance(const double* a, const double* b, Eigen::Index count)
{
    const Eigen::Index features = Features > 0 ? Features : count;
    double sum = 0;
    for (Eigen::Index j = 0; j < features; ++j)
        sum += (a[j] - b[j]) * (a[j] - b[j]);
    return sum;
}

} // namespace

KMeansAssignment::KMeansAssignment(ItemRows items, int clusters)
    : m_items(std::move(items)), m_labels(std::size_t(m_items.rows()), -1),
      m_chunks(chunkCount(m_labels.size()))
{
    if (clusters <= fewCentroids)
        m_blocks.emplace(m_items, clusters);
    m_upper.assign(m_blocks ? 0 : m_labels.size(), infinity);
    m_lower.assign(m_upper.size(), 0);
    for (ChunkSums& chunk : m_chunks) {
        chunk.sums.resize(clusters, m_items.cols());
        chunk.items.resize(clusters);
    }
    // A computed distance is wrong by some (features + 2)/2 units in the last place; four times (features +
    // 8) also holds what moving the bound adds.
    const double room = 4 * double(m_items.cols() + 8) * std::numeric_limits<double>::epsilon();
    m_rounding = roundingOfMeans(m_items);
    m_grow = 1 + room;
    m_shrink = 1 - room;
}

KMeansAssignment::Moves KMeansAssignment::movesTo(const ItemRows& centroids) const
{
    const auto clusters = std::size_t(centroids.rows());
    Moves moves;
    moves.moved.assign(clusters, 0);
    moves.halfToNext.assign(clusters, infinity);
    for (std::size_t c = 0; c < clusters; ++c) {
        const auto row = Eigen::Index(c);
        if (m_centroids.rows() > 0)
            moves.moved[c] = (centroids.row(row) - m_centroids.row(row)).norm() * m_grow;
        if (moves.moved[c] > moves.most) {
            moves.secondMost = moves.most;
            moves.most = moves.moved[c];
            moves.farthest = c;
        } else {
            moves.secondMost = std::max(moves.secondMost, moves.moved[c]);
        }
        for (std::size_t other = 0; other < c; ++other) {
            const double half =
                std::sqrt(squaredDistance<0>(centroids.row(row).data(),
                                             centroids.row(Eigen::Index(other)).data(), centroids.cols())) /
                2 * m_shrink;
            moves.halfToNext[c] = std::min(moves.halfToNext[c], half);
            moves.halfToNext[other] = std::min(moves.halfToNext[other], half);
        }
    }
    return moves;
}

void KMeansAssignment::findNeighbours()
{
    const auto clusters = std::size_t(m_centroids.rows());
    m_neighbours.clear();
    if (clusters * clusters >
        m_labels.size()) // sorting them would not be little beside a pass over the items
        return;
    m_neighbours.resize(clusters);
    for (std::size_t c = 0; c < clusters; ++c) {
        std::vector<Neighbour>& around = m_neighbours[c];
        around.reserve(clusters - 1);
        for (std::size_t other = 0; other < clusters; ++other)
            if (other != c)
                around.push_back(
                    {(m_centroids.row(Eigen::Index(c)) - m_centroids.row(Eigen::Index(other))).norm() *
                         m_shrink,
                     int(other)});
        std::sort(around.begin(), around.end(),
                  [](const Neighbour& a, const Neighbour& b) { return a.distance < b.distance; });
    }
}

void KMeansAssignment::keepBounds(std::size_t item, double nearestSquared, double secondSquared)
{
    m_upper[item] = std::sqrt(nearestSquared) * m_grow;
    m_lower[item] = std::sqrt(secondSquared) * m_shrink;
}

template <int Features>
int KMeansAssignment::nearestInBall(std::size_t item, double squared)
{
    const Eigen::Index features = Features > 0 ? Features : m_items.cols();
    const double* x = m_items.data() + Eigen::Index(item) * features;
    const std::vector<Neighbour>& around = m_neighbours[std::size_t(m_labels[item])];
    // Its own centroid is within `upper` of the item, the next one to that within upper + |next - own|: so
    // are its two nearest, and those are within 2 upper + |next - own| of its own.
    const double reach = (2 * m_upper[item] + around.front().distance * m_grow * m_grow) * m_grow;
    double best = squared;
    double second = infinity;
    int nearest = m_labels[item];
    for (const Neighbour& neighbour : around) {
        if (neighbour.distance > reach)
            break;
        const double other = squaredDistance<Features>(
            x, m_centroids.data() + Eigen::Index(neighbour.centroid) * features, features);
        if (other < best || (other == best && neighbour.centroid < nearest)) {
            second = best;
            best = other;
            nearest = neighbour.centroid;
        } else if (other < second) {
            second = other;
        }
    }
    keepBounds(item, best, second);
    return nearest;
}

template <int Features>
int KMeansAssignment::nearestCentroid(std::size_t item, Eigen::ArrayXd& distances)
{
    const double* x = m_items.data() + Eigen::Index(item) * m_items.cols();
    if constexpr (Features == 3) {
        distances = (m_columns.col(0) - x[0]).square() + (m_columns.col(1) - x[1]).square() +
                    (m_columns.col(2) - x[2]).square();
    } else {
        distances = (m_columns.col(0) - x[0]).square();
        for (Eigen::Index j = 1; j < m_items.cols(); ++j)
            distances += (m_columns.col(j) - x[j]).square();
    }
    double best = infinity;
    double second = infinity;
    int nearest = 0;
    for (Eigen::Index c = 0; c < distances.size(); ++c) {
        const double squared = distances(c);
        if (squared < best) {
            second = best;
            best = squared;
            nearest = int(c);
        } else if (squared < second) {
            second = squared;
        }
    }
    keepBounds(item, best, second);
    return nearest;
}

template <int Features>
void KMeansAssignment::assignChunk(const Chunk& chunk, const Moves& moves)
{
    ChunkSums& found = m_chunks[chunk.number];
    found.sums.setZero();
    found.items.setZero();
    found.changed = 0;
    Eigen::ArrayXd distances(m_columns.rows());
    const Eigen::Index features = Features > 0 ? Features : m_items.cols();
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const double* x = m_items.data() + Eigen::Index(i) * features;
        int label = m_labels[i];
        bool certain = false;
        double squared = 0;
        if (label >= 0) {
            const auto own = std::size_t(label);
            m_upper[i] = (m_upper[i] + moves.moved[own]) * m_grow;
            m_lower[i] =
                m_lower[i] * m_shrink - (own == moves.farthest ? moves.secondMost : moves.most) * m_grow;
            const double bound = std::max(m_lower[i], moves.halfToNext[own]);
            certain = m_upper[i] < bound;
            if (!certain) {
                squared = squaredDistance<Features>(x, m_centroids.data() + Eigen::Index(label) * features,
                                                    features);
                m_upper[i] = std::sqrt(squared) * m_grow;
                certain = m_upper[i] < bound;
            }
        }
        if (!certain) {
            label = label >= 0 && !m_neighbours.empty() ? nearestInBall<Features>(i, squared)
                                                        : nearestCentroid<Features>(i, distances);
            found.changed += label != m_labels[i];
            m_labels[i] = label;
        }
        double* sum = found.sums.data() + Eigen::Index(label) * features;
        for (Eigen::Index j = 0; j < features; ++j)
            sum[j] += x[j];
        found.items(label) += 1;
    }
}

std::size_t KMeansAssignment::assign(const Eigen::MatrixXd& centroids)
{
    const ItemRows next = centroids;
    Moves moves;
    if (!m_blocks)
        moves = movesTo(next);
    m_centroids = next;
    m_columns = centroids;
    if (!m_blocks)
        findNeighbours();
    forEachChunk(m_labels.size(), [&](const Chunk& chunk) {
        ChunkSums& found = m_chunks[chunk.number];
        if (m_blocks)
            found.changed = m_blocks->assign(chunk, m_centroids, m_labels, found);
        else if (m_items.cols() == 3) // mass, damping, stiffness
            assignChunk<3>(chunk, moves);
        else
            assignChunk<0>(chunk, moves);
    });
    return std::accumulate(m_chunks.begin(), m_chunks.end(), std::size_t(0),
                           [](std::size_t sum, const ChunkSums& chunk) { return sum + chunk.changed; });
}

double KMeansAssignment::squaredDistanceOf(Eigen::Index item) const
{
    return squaredDistance<0>(m_items.row(item).data(), m_centroids.row(m_labels[std::size_t(item)]).data(),
                              m_items.cols());
}

Eigen::VectorXd KMeansAssignment::squaredDistances() const
{
    Eigen::VectorXd distances(m_items.rows());
    for (Eigen::Index i = 0; i < distances.size(); ++i)
        distances(i) = squaredDistanceOf(i);
    return distances;
}

double KMeansAssignment::inertia() const
{
    std::vector<double> sums(m_chunks.size(), 0.0);
    forEachChunk(m_labels.size(), [&](const Chunk& chunk) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i)
            sums[chunk.number] += squaredDistanceOf(Eigen::Index(i));
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

ClusterSums KMeansAssignment::sums() const
{
    ClusterSums all = m_chunks.front();
    for (std::size_t chunk = 1; chunk < m_chunks.size(); ++chunk) {
        all.sums += m_chunks[chunk].sums;
        all.items += m_chunks[chunk].items;
    }
    return all;
}

Eigen::MatrixXd KMeansAssignment::means() const
{
    const ClusterSums all = sums();
    Eigen::MatrixXd means = all.sums;
    Eigen::VectorXd distances;
    for (Eigen::Index c = 0; c < means.rows(); ++c) {
        if (all.items(c) > 0) {
            means.row(c) /= all.items(c);
            continue;
        }
        means.row(c) = m_centroids.row(c);
        if (distances.size() == 0)
            distances = squaredDistances();
        Eigen::Index farthest = 0;
        if (distances.maxCoeff(&farthest) <= m_rounding * m_rounding)
            continue;
        distances(farthest) = 0; // the next empty cluster takes another one
        means.row(c) = m_items.row(farthest);
    }
    return means;
}

} // namespace gripscope
