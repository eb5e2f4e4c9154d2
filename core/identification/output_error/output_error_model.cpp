// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_model.h"

#include "core/identification/output_error/output_error_cascade.h"
#include "core/math/decompositions.h"

#include <cmath>

namespace gripscope {

namespace {

/// Walks through the measured rows: `use(index)` at each, `advance()` between them.
template <typename Use, typename Advance>
void forEachMeasuredRow(const OutputErrorProblem& problem, CascadeWalk& walk, const Use& use,
                        const Advance& advance)
{
    const std::ptrdiff_t shift = problem.lag.samples;
    const std::ptrdiff_t begin = problem.firstRow() + shift;
    const std::ptrdiff_t end = problem.endRow() + shift;
    auto lost = problem.lost.begin();
    while (walk.time() < end) {
        if (walk.time() >= begin) {
            const auto index = static_cast<std::size_t>(walk.time() - shift);
            while (lost != problem.lost.end() && *lost < index)
                ++lost;
            if (lost == problem.lost.end() || *lost != index)
                use(index);
        }
        walk.advance();
        advance();
    }
}

Eigen::Index offsetColumns(const OutputErrorProblem& problem)
{
    return problem.freeOffset ? 1 : 0;
}

/// What is left of the four columns d theta and residual without the linear unknowns, brought into the
/// linearisation.
void readRest(const SmallMatrix& rest, Linearization& out)
{
    const SmallMatrix own = eliminateOrdered(rest, 3);
    const Eigen::Index rows = std::min<Eigen::Index>(own.rows(), 3);
    out.triangle.topRows(rows) = own.topLeftCorner(rows, 3);
    out.right.head(rows) = own.col(3).head(rows);
    out.cost = rest.col(3).squaredNorm();
}

/// The response is the sum of its derivatives by ln M, ln B, ln K, with a minus (Euler's theorem).
double responsePower(const Eigen::Matrix3d& triangle)
{
    return triangle.rowwise().sum().squaredNorm();
}

} // namespace

ResponseFit fitResponse(const OutputErrorProblem& problem, const Eigen::Vector3d& theta)
{
    ResponseFit fit;
    const CascadeDynamics dynamics(theta);
    if (!dynamics.finite())
        return fit;
    CascadeWalk walk(problem, problem.force, dynamics);
    FreeResponses free(walk, dynamics.speed);
    const Eigen::Index nuisances = problem.nuisanceCount();
    SequentialQr qr(nuisances + 2);
    const auto use = [&](std::size_t index) {
        auto row = qr.nextRow();
        if (problem.freeInitialState) {
            row(0) = free.byPosition();
            row(1) = free.bySpeed();
        }
        if (problem.freeOffset)
            row(nuisances - 1) = 1;
        row(nuisances) = walk.row().response;
        row(nuisances + 1) = problem.position[index];
    };
    forEachMeasuredRow(problem, walk, use, [&] { free.advance(); });
    const SmallMatrix triangle = qr.triangle();
    if (!triangle.allFinite())
        return fit;
    const SmallMatrix rest = eliminateColumns(triangle, nuisances, dependentNuisance).rest;
    const double power = rest.col(0).squaredNorm();
    const double rawPower = triangle.col(nuisances).squaredNorm();
    fit.gain = power > 0 ? rest.col(0).dot(rest.col(1)) / power : 0;
    fit.ownShare = rawPower > 0 ? std::sqrt(power / rawPower) : 0;
    fit.costWithGain = (rest.col(1) - fit.gain * rest.col(0)).squaredNorm();
    fit.finite = std::isfinite(fit.costWithGain);
    return fit;
}

ScaledNuisance Linearization::nuisanceAfter(const Eigen::Vector3d& step) const
{
    ScaledNuisance after = nuisance;
    const Eigen::VectorXd change = nuisanceSlope * step;
    after.x0 += change(0);
    after.v0 += change(1);
    after.offset += change(2);
    for (std::size_t i = 0; i < after.lostForces.size(); ++i)
        after.lostForces[i] += change(3 + static_cast<Eigen::Index>(i));
    return after;
}

ScaledNuisance unknownNuisance(const OutputErrorProblem& problem)
{
    ScaledNuisance nuisance;
    for (const std::size_t lost : problem.lost)
        nuisance.lostForces.push_back(problem.force[lost]);
    return nuisance;
}

ResponseLinearizer::ResponseLinearizer(const OutputErrorProblem& problem)
    : m_problem(problem), m_qr(problem.nuisanceCount() + 4), m_lost(problem, offsetColumns(problem), 4),
      m_force(problem.lost.empty() ? std::vector<double>() : problem.force)
{
}

Linearization ResponseLinearizer::at(const Eigen::Vector3d& theta, const ScaledNuisance& assumed)
{
    const CascadeDynamics dynamics(theta);
    if (!dynamics.finite())
        return {};
    return m_problem.lost.empty() ? withoutLosses(dynamics, assumed) : withLosses(dynamics, assumed);
}

Linearization ResponseLinearizer::withoutLosses(const CascadeDynamics& dynamics,
                                                const ScaledNuisance& assumed)
{
    CascadeWalk walk(m_problem, m_problem.force, dynamics);
    walk.startAt(assumed.x0, assumed.v0);
    FreeResponses free(walk, dynamics.speed);
    const Eigen::Index nuisances = m_problem.nuisanceCount();
    m_qr.clear();
    double raw = 0;
    const auto use = [&](std::size_t index) {
        auto row = m_qr.nextRow();
        if (m_problem.freeInitialState) {
            row(0) = free.byPosition();
            row(1) = free.bySpeed();
        }
        if (m_problem.freeOffset)
            row(nuisances - 1) = 1;
        const CascadeRow at = walk.row();
        raw += at.response * at.response;
        row(nuisances) = at.byMass;
        row(nuisances + 1) = at.byDamping;
        row(nuisances + 2) = at.byStiffness;
        row(nuisances + 3) = m_problem.position[index] - at.response - assumed.offset;
    };
    forEachMeasuredRow(m_problem, walk, use, [&] { free.advance(); });

    const SmallMatrix triangle = m_qr.triangle();
    if (!triangle.allFinite())
        return {};
    const ColumnElimination elimination = eliminateColumns(triangle, nuisances, dependentNuisance);
    Linearization out;
    readRest(elimination.rest, out);
    out.nuisanceRank = static_cast<int>(elimination.rank);
    Eigen::Matrix<double, 3, 4> change = Eigen::Matrix<double, 3, 4>::Zero();
    if (m_problem.freeInitialState)
        change.topRows<2>() = elimination.solution.topRows<2>();
    if (m_problem.freeOffset)
        change.row(2) = elimination.solution.bottomRows<1>();
    out.nuisance = {assumed.x0 + change(0, 3), assumed.v0 + change(1, 3), assumed.offset + change(2, 3), {}};
    out.nuisanceSlope = -change.leftCols<3>();
    finish(elimination.taken.col(3).squaredNorm(), raw, out);
    return out;
}

Linearization ResponseLinearizer::withLosses(const CascadeDynamics& dynamics, const ScaledNuisance& assumed)
{
    for (std::size_t i = 0; i < m_problem.lost.size(); ++i)
        m_force[m_problem.lost[i]] = assumed.lostForces[i];
    CascadeWalk walk(m_problem, m_force, dynamics);
    walk.startAt(assumed.x0, assumed.v0);
    m_lost.start(walk, dynamics.speed, assumed.lostForces, m_problem.freeInitialState);
    double raw = 0;
    const auto use = [&](std::size_t index) {
        auto row = m_lost.nextRow();
        const CascadeRow at = walk.row();
        raw += at.response * at.response;
        if (m_problem.freeOffset)
            row(LostForceColumns::coordinates) = 1;
        row.tail<4>() << at.byMass, at.byDamping, at.byStiffness,
            m_problem.position[index] - at.response - assumed.offset;
    };
    forEachMeasuredRow(m_problem, walk, use, [&] { m_lost.advance(); });

    const LostForceColumns::Solution solution = m_lost.solve();
    if (!solution.finite)
        return {};
    Linearization out;
    readRest(solution.rest, out);
    out.nuisanceRank = static_cast<int>(solution.rank);
    const double offset = m_problem.freeOffset ? solution.fixed(0, 3) : 0;
    out.nuisance = {assumed.x0 + solution.start(0, 3), assumed.v0 + solution.start(1, 3),
                    assumed.offset + offset, assumed.lostForces};
    for (std::size_t i = 0; i < m_problem.lost.size(); ++i)
        out.nuisance.lostForces[i] += solution.lostForces(static_cast<Eigen::Index>(i), 3);
    out.nuisanceSlope.setZero(3 + solution.lostForces.rows(), 3);
    out.nuisanceSlope.topRows<2>() = -solution.start.leftCols<3>();
    if (m_problem.freeOffset)
        out.nuisanceSlope.row(2) = -solution.fixed.leftCols(3);
    out.nuisanceSlope.bottomRows(solution.lostForces.rows()) = -solution.lostForces.leftCols<3>();
    finish(solution.explainedPower(3), raw, out);
    return out;
}

void ResponseLinearizer::finish(double explained, double raw, Linearization& out) const
{
    const double power = out.triangle.squaredNorm();
    out.ownShare = raw > 0 ? std::sqrt(responsePower(out.triangle) / raw) : 0;
    out.stale = explained > 0 ? std::sqrt(explained / power) : 0;
    out.finite = std::isfinite(out.cost) && out.triangle.allFinite() && out.right.allFinite() &&
                 out.nuisanceSlope.allFinite() && std::isfinite(out.ownShare) && std::isfinite(out.stale) &&
                 std::isfinite(out.nuisance.x0 + out.nuisance.v0 + out.nuisance.offset);
}

void forEachLinearizedRow(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                          const ScaledNuisance& nuisance,
                          const std::function<void(std::ptrdiff_t, const Eigen::RowVectorXd&)>& use)
{
    const CascadeDynamics dynamics(theta);
    std::vector<double> force = problem.force;
    for (std::size_t i = 0; i < nuisance.lostForces.size(); ++i)
        force[problem.lost[i]] = nuisance.lostForces[i];
    CascadeWalk walk(problem, force, dynamics);
    walk.startAt(nuisance.x0, nuisance.v0);
    FreeResponses free(walk, dynamics.speed);
    const Eigen::Index nuisances = problem.nuisanceCount();
    Eigen::RowVectorXd row(nuisances + 4);
    const auto fill = [&](std::size_t index) {
        if (problem.freeInitialState) {
            row(0) = free.byPosition();
            row(1) = free.bySpeed();
        }
        if (problem.freeOffset)
            row(nuisances - 1) = 1;
        const CascadeRow at = walk.row();
        row.tail<4>() << at.byMass, at.byDamping, at.byStiffness,
            problem.position[index] - at.response - nuisance.offset;
        use(static_cast<std::ptrdiff_t>(index), row);
    };
    forEachMeasuredRow(problem, walk, fill, [&] { free.advance(); });
}

} // namespace gripscope
