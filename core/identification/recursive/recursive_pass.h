// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/lag_alignment.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

/// Least squares of the output-error problem linearised at one point, sample by sample. Time is in samples:
/// theta = (ln M, ln B, ln K) of M x'' + B x' + K x = F with M = m / T^2, B = b / T, K = k. The nuisances are
/// x0, v0 (a sample) and the position's offset.
class RecursivePass {
public:
    struct Point {
        Eigen::Vector3d theta = Eigen::Vector3d::Zero();
        Eigen::Vector3d nuisance = Eigen::Vector3d::Zero(); ///< x0, v0, offset
    };
    /// What the rows so far say about the way from the point to the optimum.
    struct Solution {
        bool determined = false;                        ///< to rounding: all three parameters have pivots
        Eigen::Vector3d step = Eigen::Vector3d::Zero(); ///< in theta
        Eigen::Vector3d nuisanceStep = Eigen::Vector3d::Zero(); ///< with `step` taken
        Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero(); ///< of the information on theta, noise variance 1
        double cost = 0;       ///< squared residuals at the point with the best nuisances
        double costAtStep = 0; ///< and with the step taken, were the problem linear
    };

    RecursivePass() = default;
    /// `rest`: positions are sampled this share of a sample later than forces, from 0 to below 1.
    RecursivePass(const Point& point, ForceHold hold, double rest);

    /// False: the point is outside the range of numbers, and nothing may be added.
    [[nodiscard]] bool usable() const { return m_usable; }
    [[nodiscard]] const Point& point() const { return m_point; }
    [[nodiscard]] std::size_t samples() const { return m_samples; }
    [[nodiscard]] std::size_t rows() const { return m_rows; }

    /// The forces at a sample and the ones around it.
    struct Forces {
        double before, now, next; ///< `next` counts with a lag and a first-order hold only
    };
    /// The next sample. A position that is not a number was not measured and adds no row.
    void add(const Forces& forces, double position)
    {
        if (m_samples > 0)
            advance(forces);
        ++m_samples;
        if (position == position)
            addRow(position);
    }

    /// Least squares with `damping` times the diagonal added to the information on theta (Levenberg and
    /// Marquardt).
    [[nodiscard]] Solution solve(double damping) const;

private:
    /// Offset, theta, residual.
    static constexpr std::size_t columns = 5, products = columns * (columns + 1) / 2;

    void advance(const Forces& forces)
    {
        // phi is [[a, 0], [c, a]]: x does not hear of its sensitivities. Written out in scalars: a state that
        // is stored in halves and loaded whole makes the processor wait.
        const double x = m_state(0), v = m_state(1), w = m_state(2), u = m_state(3);
        const auto& p = m_phi;
        const auto pushed = [&](Eigen::Index i) {
            return m_byForce(i, 0) * forces.before + m_byForce(i, 1) * forces.now +
                   m_byForce(i, 2) * forces.next;
        };
        m_state(0) = p(0, 0) * x + p(0, 1) * v + pushed(0);
        m_state(1) = p(1, 0) * x + p(1, 1) * v + pushed(1);
        m_state(2) = (p(2, 0) * x + p(2, 1) * v) + (p(2, 2) * w + p(2, 3) * u) + pushed(2);
        m_state(3) = (p(3, 0) * x + p(3, 1) * v) + (p(3, 2) * w + p(3, 3) * u) + pushed(3);
        // Zero is faster than the denormal numbers these end in.
        constexpr double vanishing = 1e-150;
        if (!(std::abs(m_state(0)) + std::abs(m_state(2)) > vanishing))
            m_state.setZero();
        if (m_freeOver)
            return;
        const double f = m_free(0), g = m_free(1);
        m_free(0) = f * p(0, 0) + g * p(1, 0);
        m_free(1) = f * p(0, 1) + g * p(1, 1);
        m_freeOver = !(std::abs(m_free(0)) + std::abs(m_free(1)) > vanishing);
    }
    void addRow(double position)
    {
        ++m_rows;
        const double byStiffness = m_stiffnessFactor * m_state(2);
        const double byDamping = m_dampingFactor * m_state(3);
        const std::array<double, columns> row{1, -m_state(0) - byDamping - byStiffness, byDamping,
                                              byStiffness, position - m_state(0) - m_point.nuisance(2)};
        addProducts(row, std::make_index_sequence<products>());
        if (m_freeOver) // most of the time: the start is forgotten
            return;
        const std::array<double, 2> free{m_free(0), m_free(1) * m_velocityFactor};
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j)
                m_freeProducts[i][j] += free[i] * free[j];
            for (std::size_t j = 0; j < columns; ++j)
                m_crossProducts[i][j] += free[i] * row[j];
        }
    }
    /// The lower triangle row by row; one term for each, since a loop costs as much again.
    template <std::size_t... Index>
    void addProducts(const std::array<double, columns>& row, std::index_sequence<Index...>)
    {
        ((m_products[Index] += row[rowOf(Index)] * row[Index - firstOf(rowOf(Index))]), ...);
    }
    static constexpr std::size_t firstOf(std::size_t row) { return row * (row + 1) / 2; }
    static constexpr std::size_t rowOf(std::size_t index)
    {
        std::size_t row = 0;
        while (firstOf(row + 1) <= index)
            ++row;
        return row;
    }

    Point m_point;
    bool m_usable = false;
    Eigen::Matrix4d m_phi = Eigen::Matrix4d::Identity();
    Eigen::Matrix<double, 4, 3> m_byForce = Eigen::Matrix<double, 4, 3>::Zero(); ///< a column each of Forces
    double m_stiffnessFactor = 0, m_dampingFactor = 0, m_velocityFactor = 1;
    Eigen::Vector4d m_state =
        Eigen::Vector4d::Zero();     ///< x, x'/speed, w speed^2, w' speed; m w'' + b w' + k w = x
    Eigen::RowVector2d m_free{1, 0}; ///< what a unit of x0 and of v0 adds to x
    std::size_t m_samples = 0, m_rows = 0;
    bool m_freeOver = false; ///< m_free has decayed to nothing
    /// Sums of the products of the columns among each other, of x0 and v0, and across.
    std::array<double, products> m_products{};
    std::array<std::array<double, 2>, 2> m_freeProducts{};
    std::array<std::array<double, columns>, 2> m_crossProducts{};
};

/// Takes the whole samples of a lag between two channels out as they come: each position with the force at
/// its time, or the rest of a sample before it, and the forces beside that. It waits for as many samples as
/// that needs.
class LagDelay {
public:
    struct Sample {
        RecursivePass::Forces forces;
        double position;
    };

    LagDelay() : LagDelay({}, ForceHold::Zero) {}
    LagDelay(const LagAlignment& lag, ForceHold hold)
    {
        // Longer than any squeeze: nothing ever comes out.
        constexpr std::ptrdiff_t longest = 1'000'000;
        m_lag = std::clamp(lag.samples, -longest, longest);
        const std::ptrdiff_t forceAhead = hold == ForceHold::First && lag.rest > 0 ? 1 : 0;
        m_delay = std::max({forceAhead, -m_lag, std::ptrdiff_t(0)});
        const std::ptrdiff_t reach = m_delay + std::max(m_lag, std::ptrdiff_t(1)) + 1;
        const std::size_t size =
            std::bit_ceil(static_cast<std::size_t>(reach)); // a mask is faster than a division
        m_forces.resize(size);
        m_positions.resize(size);
    }

    /// What is complete now that this sample is known.
    std::optional<Sample> push(double force, double position)
    {
        at(m_forces, m_count) = force;
        at(m_positions, m_count) = position;
        const std::ptrdiff_t forceIndex = m_count - m_delay, positionIndex = forceIndex - m_lag;
        ++m_count;
        if (forceIndex < 0 || positionIndex < 0)
            return std::nullopt;
        const double now = at(m_forces, forceIndex);
        return Sample{{forceIndex > 0 ? at(m_forces, forceIndex - 1) : now, now,
                       at(m_forces, std::min(forceIndex + 1, m_count - 1))},
                      at(m_positions, positionIndex)};
    }

private:
    [[nodiscard]] static double& at(std::vector<double>& ring, std::ptrdiff_t index)
    {
        return ring[static_cast<std::size_t>(index) & (ring.size() - 1)];
    }

    std::ptrdiff_t m_lag = 0, m_delay = 0, m_count = 0;
    std::vector<double> m_forces, m_positions;
};

} // namespace gripscope
