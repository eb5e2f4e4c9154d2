// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/effect_regression.h"

#include "core/identification/model/discretization.h"
#include "core/identification/model/lag_alignment.h"
#include "core/math/fit.h"
#include "core/math/least_squares.h"
#include "core/math/sequential_qr.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gripscope {

namespace {

/// Relative step of the differences: their error is its square times (1 / 2 damping ratio)^2, and rounding
/// leaves eleven digits.
constexpr double step = 1e-5;
/// Steps in the lag, in samples; the response is smooth between two samples.
constexpr double lagStep = 1e-3;

SimulationOptions simulationAt(const Estimate& estimate, const OutputErrorOptions& options)
{
    return {options.sampleTime_s,
            options.hold,
            options.lag_s,
            estimate.nuisance.x0.value_or(0),
            estimate.nuisance.v0.value_or(0),
            0};
}

/// Samples whose position lies within the time the force is known, without the lost ones.
std::vector<std::size_t> measuredRows(std::size_t samples, const OutputErrorOptions& options)
{
    const LagAlignment lag(options.lag_s, options.sampleTime_s);
    const auto count = static_cast<std::ptrdiff_t>(samples);
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(-lag.samples, 0);
    const std::ptrdiff_t unknown = lag.rest > 0 && options.hold == ForceHold::First ? 1 : 0;
    const std::ptrdiff_t end = std::min(count - lag.samples - unknown, count);
    std::vector<std::size_t> rows;
    for (std::ptrdiff_t n = first; n < end; ++n)
        rows.push_back(static_cast<std::size_t>(n));
    return rows;
}

MassDampingStiffness scaled(const MassDampingStiffness& p, Eigen::Index which, double factor)
{
    MassDampingStiffness out = p;
    (which == 0 ? out.m : which == 1 ? out.b : out.k) *= factor;
    return out;
}

/// Central difference over one of ln m, ln b, ln k.
std::vector<double> sensitivity(const MassDampingStiffness& p, Eigen::Index which,
                                const std::vector<double>& force, const SimulationOptions& simulation)
{
    std::vector<double> up = simulate(scaled(p, which, 1 + step), force, simulation);
    const std::vector<double> down = simulate(scaled(p, which, 1 - step), force, simulation);
    for (std::size_t i = 0; i < up.size(); ++i)
        up[i] = (up[i] - down[i]) / (2 * step);
    return up;
}

/// One-sided difference of second order, which stays between two samples: the acceleration jumps at each.
std::vector<double> velocityOf(const MassDampingStiffness& p, const std::vector<double>& force,
                               const SimulationOptions& simulation)
{
    const double rest = LagAlignment(simulation.lag_s, simulation.sampleTime_s).rest;
    const double h = (rest < 0.5 ? lagStep : -lagStep) * simulation.sampleTime_s;
    SimulationOptions later = simulation;
    later.lag_s = simulation.lag_s + h;
    const std::vector<double> at = simulate(p, force, simulation);
    const std::vector<double> near = simulate(p, force, later);
    later.lag_s = simulation.lag_s + 2 * h;
    std::vector<double> velocity = simulate(p, force, later);
    for (std::size_t i = 0; i < velocity.size(); ++i)
        velocity[i] = (4 * near[i] - 3 * at[i] - velocity[i]) / (2 * h);
    return velocity;
}

std::vector<double> heldForce(const std::vector<double>& force, const OutputErrorOptions& options)
{
    const LagAlignment lag(options.lag_s, options.sampleTime_s);
    const auto last = static_cast<std::ptrdiff_t>(force.size()) - 1;
    const auto at = [&](std::ptrdiff_t n) {
        return force[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(n, 0, last))];
    };
    std::vector<double> held(force.size());
    const double rest = options.hold == ForceHold::First ? lag.rest : 0;
    for (std::ptrdiff_t n = 0; n <= last; ++n)
        held[static_cast<std::size_t>(n)] = (1 - rest) * at(n + lag.samples) + rest * at(n + lag.samples + 1);
    return held;
}

/// Takes the rows of `values` that count, over `scale`.
void fill(Eigen::MatrixXd& matrix, Eigen::Index column, const std::vector<double>& values,
          const std::vector<std::size_t>& rows, double scale)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        matrix(static_cast<Eigen::Index>(i), column) = values[rows[i]] / scale;
}

/// Runs every row through e[t] - sum_i a_i e[t - i]; false while a stretch has fewer rows behind it than
/// that needs.
class RowFilter {
public:
    RowFilter(const std::vector<double>& coefficients, Eigen::Index columns)
        : m_coefficients(coefficients),
          m_past(static_cast<Eigen::Index>(std::max<std::size_t>(coefficients.size(), 1)), columns)
    {
    }
    void restart() { m_seen = 0; }
    bool filter(const Eigen::RowVectorXd& row, Eigen::RowVectorXd& out)
    {
        const auto order = static_cast<Eigen::Index>(m_coefficients.size());
        out = row;
        if (order == 0)
            return true;
        const bool ready = m_seen >= order;
        for (Eigen::Index i = 1; ready && i <= order; ++i)
            out -= m_coefficients[static_cast<std::size_t>(i - 1)] * m_past.row((m_seen - i) % order);
        m_past.row(m_seen % order) = row;
        ++m_seen;
        return ready;
    }

private:
    const std::vector<double>& m_coefficients;
    Eigen::MatrixXd m_past;
    Eigen::Index m_seen = 0;
};

/// (M[n-1] + 4 M[n] + M[n+1]) / 6 = u[n-1] - 2 u[n] + u[n+1], M = 0 at both ends; Thomas' algorithm.
std::vector<double> splineCurvature(const std::vector<double>& u)
{
    const std::size_t count = u.size();
    std::vector<double> m(count, 0.0);
    if (count < 3)
        return m;
    std::vector<double> ratio(count, 0.0);
    for (std::size_t n = 1; n + 1 < count; ++n) {
        const double pivot = 4 - ratio[n - 1];
        ratio[n] = 1 / pivot;
        const double bend = (u[n - 1] - u[n]) + (u[n + 1] - u[n]);
        m[n] = (6 * bend - m[n - 1]) / pivot;
    }
    for (std::size_t n = count - 1; n-- > 1;)
        m[n] -= ratio[n] * m[n + 1];
    return m;
}

} // namespace

LinearizedRecord linearizedRecord(const Estimate& estimate, const std::vector<double>& force,
                                  const OutputErrorOptions& options)
{
    LinearizedRecord record;
    if (!estimate.parameters || force.empty() || !(options.sampleTime_s > 0))
        return record;
    const MassDampingStiffness& p = *estimate.parameters;
    if (!(p.vector().minCoeff() > 0) || !p.vector().allFinite())
        return record;
    std::vector<std::size_t> rows = measuredRows(force.size(), options);
    std::erase_if(rows, [&](std::size_t row) {
        return std::binary_search(options.lost.begin(), options.lost.end(), row);
    });
    const int nuisances = (options.freeInitialState ? 2 : 0) + (options.freeOffset ? 1 : 0);
    if (static_cast<int>(std::min<std::size_t>(rows.size(), 100)) <= nuisances + 3)
        return record;

    const SimulationOptions simulation = simulationAt(estimate, options);
    const std::vector<double> position = simulate(p, force, simulation);
    record.positionScale = powerOfTwoScale(position);
    record.velocity = velocityOf(p, force, simulation);
    record.forceAtSample = heldForce(force, options);
    const auto count = static_cast<Eigen::Index>(rows.size());
    record.sensitivities.resize(count, 3);
    for (Eigen::Index i = 0; i < 3; ++i)
        fill(record.sensitivities, i, sensitivity(p, i, force, simulation), rows, record.positionScale);
    record.nuisances.resize(count, nuisances);
    if (options.freeInitialState) {
        const std::vector<double> none(force.size(), 0.0);
        SimulationOptions free = simulation;
        free.x0 = 1;
        free.v0 = 0;
        fill(record.nuisances, 0, simulate(p, none, free), rows, 1);
        free.x0 = 0;
        free.v0 = 1 / options.sampleTime_s;
        fill(record.nuisances, 1, simulate(p, none, free), rows, 1);
    }
    if (options.freeOffset)
        record.nuisances.col(nuisances - 1).setOnes();
    if (record.sensitivities.allFinite() && record.nuisances.allFinite() && allFinite(record.velocity))
        record.rows = std::move(rows);
    return record;
}

EffectTriangle effectTriangle(const LinearizedRecord& record, std::span<const std::vector<double>> effects,
                              const std::vector<double>& residual, const std::vector<double>& noise)
{
    EffectTriangle out;
    const Eigen::Index nuisances = record.nuisances.cols();
    const auto count = static_cast<Eigen::Index>(effects.size());
    const Eigen::Index columns = nuisances + 3 + count + 1;
    std::vector<double> scales;
    for (const std::vector<double>& effect : effects)
        scales.push_back(powerOfTwoScale(effect));
    SequentialQr qr(columns);
    RowFilter filter(noise, columns);
    Eigen::RowVectorXd row(columns);
    Eigen::RowVectorXd filtered(columns);
    for (std::size_t i = 0; i < record.rows.size(); ++i) {
        const std::size_t t = record.rows[i];
        const auto at = static_cast<Eigen::Index>(i);
        row.head(nuisances) = record.nuisances.row(at);
        row.segment<3>(nuisances) = record.sensitivities.row(at);
        for (Eigen::Index j = 0; j < count; ++j) {
            const auto effect = static_cast<std::size_t>(j);
            row(nuisances + 3 + j) = effects[effect][t] / scales[effect];
        }
        row(columns - 1) = residual[t] / record.positionScale;
        if (i > 0 && t != record.rows[i - 1] + 1)
            filter.restart();
        if (!filter.filter(row, filtered))
            continue;
        qr.nextRow() = filtered;
        ++out.rows;
    }
    out.triangle = qr.triangle();
    for (Eigen::Index j = 0; j < count; ++j)
        out.triangle.col(nuisances + 3 + j) *= scales[static_cast<std::size_t>(j)] / record.positionScale;
    return out;
}

Eigen::Matrix3Xd shiftsBy(const LinearizedRecord& record, std::span<const std::vector<double>> effects)
{
    if (!record.usable())
        return {};
    const std::vector<double> none(record.velocity.size(), 0.0);
    const Eigen::MatrixXd triangle = effectTriangle(record, effects, none, {}).triangle;
    const Eigen::Index nuisances = record.nuisances.cols();
    const auto count = static_cast<Eigen::Index>(effects.size());
    // Below the rows of the nuisances stand the columns with the nuisances projected out.
    const Eigen::Matrix3d own = triangle.block<3, 3>(nuisances, nuisances);
    if (!triangle.allFinite())
        return {};
    const PivotedSolution solved = solvePivoted(own, triangle.block(nuisances, nuisances + 3, 3, count));
    const Eigen::Matrix3Xd shifts = solved.solution;
    return solved.rank == 3 && shifts.allFinite() ? shifts : Eigen::Matrix3Xd();
}

Eigen::MatrixXd influences(const LinearizedRecord& record)
{
    // The nuisances are projected out row by row of the record, from its Gram matrices.
    const Eigen::MatrixXd& n = record.nuisances;
    Eigen::MatrixXd own = record.sensitivities;
    if (n.cols() > 0) {
        const Eigen::MatrixXd gram = n.transpose() * n;
        own -= n * solvePivoted(gram, n.transpose() * own).solution;
    }
    const Eigen::Matrix3d information = own.transpose() * own;
    return own * information.inverse() / record.positionScale;
}

std::vector<double> straightAsSpline(const std::vector<double>& force)
{
    std::vector<double> out = splineCurvature(force);
    for (std::size_t n = 0; n < out.size(); ++n)
        out[n] = force[n] - out[n] / 12;
    return out;
}

} // namespace gripscope
