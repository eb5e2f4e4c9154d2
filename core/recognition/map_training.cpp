// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/map_training.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace gripscope {

bool MapGrid::neighbours(int one, int other) const
{
    const int rowsApart = std::abs(one / columns - other / columns);
    const int columnsApart = std::abs(one % columns - other % columns);
    return std::max(rowsApart, columnsApart) == 1;
}

MapTraining::MapTraining(const Eigen::MatrixXd& items, const MapGrid& grid)
    : m_items(items), m_grid(grid), m_best(std::size_t(items.rows()), -1), m_chunks(chunkCount(m_best.size()))
{
    for (ChunkSums& chunk : m_chunks) {
        chunk.sums.resize(grid.units(), items.cols());
        chunk.items.resize(std::size_t(grid.units()));
    }
}

void MapTraining::assignChunk(const Chunk& chunk)
{
    ChunkSums& found = m_chunks[chunk.number];
    found.sums.setZero();
    std::fill(found.items.begin(), found.items.end(), 0.0);
    found.distance = 0;
    found.changed = found.torn = 0;
    const Eigen::Index features = m_items.cols();
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const double* item = m_items.data() + Eigen::Index(i) * features;
        const double* weight = m_weights.data();
        double nearest = std::numeric_limits<double>::infinity();
        double next = nearest;
        int best = 0;
        int second = -1;
        for (int unit = 0; unit < m_grid.units(); ++unit, weight += features) {
            double squared = 0;
            for (Eigen::Index j = 0; j < features; ++j)
                squared += (item[j] - weight[j]) * (item[j] - weight[j]);
            if (squared < nearest) {
                next = nearest;
                second = nearest < std::numeric_limits<double>::infinity() ? best : -1;
                nearest = squared;
                best = unit;
            } else if (squared < next) {
                next = squared;
                second = unit;
            }
        }
        found.distance += std::sqrt(nearest);
        found.changed += best != m_best[i];
        found.torn += second >= 0 && !m_grid.neighbours(best, second);
        m_best[i] = best;
        found.sums.row(best) += m_items.row(Eigen::Index(i));
        found.items[std::size_t(best)] += 1;
    }
}

std::size_t MapTraining::assign()
{
    forEachChunk(m_best.size(), [this](const Chunk& chunk) { assignChunk(chunk); });
    std::size_t changed = 0;
    for (const ChunkSums& chunk : m_chunks)
        changed += chunk.changed;
    return changed;
}

/// h of every pair of units.
Eigen::MatrixXd MapTraining::neighbourhood(double radius) const
{
    Eigen::MatrixXd h(m_grid.units(), m_grid.units());
    for (int one = 0; one < m_grid.units(); ++one)
        for (int other = 0; other < m_grid.units(); ++other) {
            const double down = one / m_grid.columns - other / m_grid.columns;
            const double across = one % m_grid.columns - other % m_grid.columns;
            h(one, other) = std::exp(-(down * down + across * across) / (2 * radius * radius));
        }
    return h;
}

void MapTraining::move(double radius)
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(m_weights.rows(), m_weights.cols());
    Eigen::VectorXd items = Eigen::VectorXd::Zero(m_weights.rows());
    for (const ChunkSums& chunk : m_chunks) {
        sums += chunk.sums;
        items += Eigen::Map<const Eigen::VectorXd>(chunk.items.data(), items.size());
    }
    const Eigen::MatrixXd h = neighbourhood(radius);
    const Eigen::MatrixXd smoothed = h * sums;
    const Eigen::VectorXd mass = h * items;
    for (Eigen::Index unit = 0; unit < m_weights.rows(); ++unit)
        if (mass(unit) > 1e-200) // a mean of numbers that have almost vanished has no digits
            m_weights.row(unit) = smoothed.row(unit) / mass(unit);
}

double MapTraining::quantizationError() const
{
    double distance = 0;
    for (const ChunkSums& chunk : m_chunks)
        distance += chunk.distance;
    return distance / double(m_best.size());
}

double MapTraining::topographicError() const
{
    std::size_t torn = 0;
    for (const ChunkSums& chunk : m_chunks)
        torn += chunk.torn;
    return double(torn) / double(m_best.size());
}

double MapTraining::distortion(double radius) const
{
    // |x - w_j|^2 averaged over j by h is the squared distance from the weights' mean plus their scatter
    // about it; both depend on the best unit alone.
    Eigen::MatrixXd h = neighbourhood(radius);
    h.array().colwise() /= h.rowwise().sum().array().eval();
    const ItemRows means = h * m_weights;
    Eigen::VectorXd scatter(m_weights.rows());
    for (Eigen::Index unit = 0; unit < m_weights.rows(); ++unit)
        scatter(unit) = h.row(unit).dot((m_weights.rowwise() - means.row(unit)).rowwise().squaredNorm());
    double sum = 0;
    for (std::size_t i = 0; i < m_best.size(); ++i)
        sum += scatter(m_best[i]) + (m_items.row(Eigen::Index(i)) - means.row(m_best[i])).squaredNorm();
    return sum / double(m_best.size());
}

} // namespace gripscope
