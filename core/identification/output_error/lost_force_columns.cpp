// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_model.h"
#include "core/math/decompositions.h"

#include <cmath>

namespace gripscope {

namespace {

/// Of what a coordinate reaches: less is what the reflections round, which must not pass for an unknown.
constexpr double reachRounding = 1e-14;

/// The reflection that makes rows (first, end) of the column zero, on all columns.
template <typename Matrix>
void reflectRows(Matrix& matrix, Eigen::Index first, Eigen::Index end, Eigen::Index column)
{
    const Eigen::Index below = end - first - 1;
    const double square = matrix.col(column).segment(first + 1, below).squaredNorm();
    if (square == 0)
        return;
    Eigen::Vector4d mirror = Eigen::Vector4d::Zero();
    mirror.head(below + 1) = matrix.col(column).segment(first, below + 1);
    const double norm = std::sqrt(square + mirror(0) * mirror(0));
    mirror(0) += std::copysign(norm, mirror(0));
    const double scale = 1 / (norm * std::abs(mirror(0)));
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        auto part = matrix.col(j).segment(first, below + 1);
        const double share = scale * mirror.head(below + 1).dot(part);
        part -= share * mirror.head(below + 1);
    }
    matrix.col(column).segment(first + 1, below).setZero();
}

} // namespace

LostForceColumns::LostForceColumns(const OutputErrorProblem& problem, Eigen::Index fixed, Eigen::Index others)
    : m_problem(problem), m_fixed(fixed), m_others(others), m_qr(coordinates + fixed + others)
{
}

void LostForceColumns::start(const CascadeWalk& walk, double speed, const std::vector<double>& assumed,
                             bool freeStart)
{
    const CascadeStep& step = walk.step();
    const CascadeStep& part = walk.part();
    const double rest = m_problem.lag.rest;
    m_step << step.a00, step.a01, step.held.x, step.rising.x, step.a10, step.a11, step.held.v, step.rising.v;
    m_position << part.a00, part.a01, part.held.x + (1 - rest) * part.rising.x, rest * part.rising.x;
    m_moved = std::hypot(step.held.x + step.rising.x, step.held.v + step.rising.v);
    m_speed = speed;
    m_assumed = &assumed;
    m_reach.setZero();
    if (freeStart)
        m_reach(0, 0) = m_reach(1, 1) = 1;
    m_eliminated.clear();
    m_qr.clear();
    m_time = 0;
    m_next = 0;
    for (Eigen::Index i = 0; i < 2; ++i) {
        if (m_next < m_problem.lost.size() && m_problem.lost[m_next] == static_cast<std::size_t>(i)) {
            m_reach(2 + i, 2 + i) = unitOf(m_next);
            addPrior(m_next, 2 + i, unitOf(m_next));
            ++m_next;
        }
    }
}

/// The force of one unit of a coordinate: one that moves the state and the row of the prior by about one.
double LostForceColumns::unitOf(std::size_t lost) const
{
    const double unit =
        1 / std::hypot(m_moved, m_problem.noiseDeviation / m_problem.lostForceDeviation[lost]);
    return std::isfinite(unit) ? unit : 1;
}

void LostForceColumns::addPrior(std::size_t lost, Eigen::Index coordinate, double unit)
{
    const double weight = m_problem.noiseDeviation / m_problem.lostForceDeviation[lost];
    const double expected = m_problem.force[m_problem.lost[lost]];
    auto row = m_qr.nextRow();
    row.setZero();
    row(coordinate) = weight * unit;
    row(row.size() - 1) = weight * (expected - (*m_assumed)[lost]);
}

void LostForceColumns::advance()
{
    const Eigen::Matrix<double, 2, 4> state = m_step * m_reach;
    m_reach.topRows<2>() = state;
    m_reach.row(2) = m_reach.row(3).eval();
    m_reach.row(3).setZero();
    ++m_time;
    if (m_next < m_problem.lost.size() && m_problem.lost[m_next] == static_cast<std::size_t>(m_time) + 1)
        enter(m_next++);
}

void LostForceColumns::enter(std::size_t lost)
{
    Eliminated event;
    event.lost = lost;
    // Householder reflections turn three rows of Q into a lower triangle: its last column is zero.
    Eigen::Matrix<double, 4, 7> work;
    work.leftCols<3>() = m_reach.topRows<3>().transpose();
    work.rightCols<4>().setIdentity();
    const Eigen::RowVector3d sizes = work.leftCols<3>().colwise().norm();
    for (Eigen::Index i = 0; i < 3; ++i)
        reflectRows(work, i, 4, i);
    for (Eigen::Index i = 0; i < 3; ++i)
        work.col(i) = (work.col(i).array().abs() > reachRounding * sizes(i)).select(work.col(i), 0.0).eval();
    event.turn = work.rightCols<4>().transpose();
    m_reach.setZero();
    m_reach.topRows<3>() = work.leftCols<3>().transpose();
    m_reach.col(3).setZero();
    m_reach(3, 3) = unitOf(lost);
    eliminate(event);
    m_eliminated.push_back(event);
    addPrior(lost, 3, m_reach(3, 3));
}

/// The triangle in the new coordinates, with the direction that reaches nothing any more taken out.
void LostForceColumns::eliminate(Eliminated& event)
{
    Eigen::MatrixXd& triangle = m_qr.changeTriangle();
    SmallMatrix rows = triangle.topRows<coordinates>();
    const double size = rows.leftCols<coordinates>().colwise().squaredNorm().maxCoeff();
    const Eigen::Matrix4d turned = rows.leftCols<coordinates>() * event.turn;
    rows.leftCols<coordinates>() = turned;
    reflectRows(rows, 0, coordinates, 3);
    event.observed = std::abs(rows(0, 3)) > dependentNuisance * std::sqrt(size);
    event.row = rows.row(0);
    rows.col(3).setZero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        // Of a coordinate nothing is known of there are only rounding errors, which must not look like a row.
        if (rows.col(i).norm() <= dependentNuisance * std::sqrt(size))
            rows.col(i).setZero();
    }
    // Echelon form, each row at its own column: what a row says of the others then never hides behind a
    // diagonal that is zero.
    triangle.topRows<coordinates>().setZero();
    Eigen::Index next = event.observed ? 1 : 0;
    for (Eigen::Index i = 0; i < 3 && next < coordinates; ++i) {
        reflectRows(rows, next, coordinates, i);
        if (std::abs(rows(next, i)) > dependentNuisance * std::sqrt(size)) {
            triangle.row(i) = rows.row(next);
            ++next;
        }
        rows.col(i).setZero();
    }
}

LostForceColumns::Solution LostForceColumns::solve()
{
    Solution out;
    const SmallMatrix triangle = m_qr.triangle();
    if (!triangle.allFinite())
        return out;
    const Eigen::Index unknowns = coordinates + m_fixed;
    ColumnElimination elimination = eliminateColumns(triangle, unknowns, dependentNuisance);
    out.rank = elimination.rank;
    out.explainedPower = elimination.taken.colwise().squaredNorm().transpose();
    out.rest = elimination.rest;
    out.fixed = elimination.solution.bottomRows(m_fixed);
    for (const Eliminated& event : m_eliminated) {
        if (!event.observed)
            continue;
        ++out.rank;
        out.explainedPower += event.row.tail(m_others).cwiseAbs2().transpose();
    }
    out.lostForces = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m_problem.lost.size()), m_others);
    substituteBack(out, elimination.solution.topRows(coordinates));
    out.finite = out.lostForces.allFinite() && out.rest.allFinite();
    return out;
}

void LostForceColumns::substituteBack(Solution& solution, SmallMatrix c) const
{
    for (std::size_t i = m_eliminated.size(); i-- > 0;) {
        const Eliminated& event = m_eliminated[i];
        solution.lostForces.row(static_cast<Eigen::Index>(event.lost)) = unitOf(event.lost) * c.row(3);
        Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, largestSmallMatrix> z =
            event.row.tail(m_others);
        if (event.observed) {
            z -= event.row.head<3>() * c.topRows<3>();
            z -= event.row.segment(coordinates, m_fixed) * solution.fixed;
            z /= event.row(3);
        } else {
            z.setZero();
        }
        c.row(3) = z;
        c = (event.turn * c).eval();
    }
    // What is left are the coordinates at the first sample.
    solution.start = c.topRows<2>();
    solution.start.row(1) *= m_speed;
    std::size_t lost = 0;
    for (Eigen::Index i = 0; i < 2; ++i) {
        if (lost < m_problem.lost.size() && m_problem.lost[lost] == static_cast<std::size_t>(i)) {
            solution.lostForces.row(static_cast<Eigen::Index>(lost)) = unitOf(lost) * c.row(2 + i);
            ++lost;
        }
    }
}

Eigen::MatrixXd withoutLostForces(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                  const std::vector<double>& assumed, const Eigen::MatrixXd& series)
{
    const CascadeDynamics dynamics(theta);
    const CascadeWalk walk(problem, problem.force, dynamics);
    LostForceColumns columns(problem, 0, series.rows());
    columns.start(walk, dynamics.speed, assumed, false);
    Eigen::MatrixXd left(series.rows(), problem.measuredRows());
    Eigen::Index count = 0;
    auto lost = problem.lost.begin();
    for (std::ptrdiff_t t = -problem.lag.samples; t < problem.endRow(); ++t) {
        while (lost != problem.lost.end() && static_cast<std::ptrdiff_t>(*lost) < t)
            ++lost;
        const bool measured = lost == problem.lost.end() || static_cast<std::ptrdiff_t>(*lost) != t;
        if (measured && t >= problem.firstRow()) {
            columns.foldPriors();
            columns.nextRow().tail(series.rows()) = series.col(t - problem.firstRow()).transpose();
            left.col(count++) = columns.takeOut();
        }
        columns.advance();
    }
    return left;
}

} // namespace gripscope
