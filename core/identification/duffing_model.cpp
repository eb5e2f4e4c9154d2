// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing_model.h"

#include "core/identification/column_elimination.h"
#include "core/identification/duffing_step.h"
#include "core/identification/tall_qr.h"

#include <cmath>

namespace gripscope {

namespace {

/// A nuisance column of which less than this is left beside the others does not count: rounding.
constexpr double dependent = 1e-12;
/// Positions are about 1; a motion that goes this far has left the well of a softening spring.
constexpr double outOfBounds = 1e6;
/// Rates in samples above which the matrix exponential has no digits left.
constexpr double fastestRate = 1e12;
constexpr double largestSubstepAngle = 1.0 / 3;
constexpr int mostSubsteps = 64;

/// x0, v0, M, B, K, K3.
constexpr std::size_t directions = 6;
constexpr std::size_t massDirection = 2, cubicDirection = 5;

struct Motion {
    double x = 0, v = 0;
    std::array<double, directions> dx{}, dv{}; ///< derivatives of x and v
};

/// A share [begin, end) of every sample, in equal steps.
struct Leg {
    double begin = 0, end = 1;
    int substeps = 1;
    DuffingStepFamily step;
};

class Integrator {
public:
    Integrator(const DuffingProblem& problem, const DuffingPoint& point)
        : m_problem(problem), m_cubic(point.cubic)
    {
        const double stiffness = std::exp(point.theta(2) - point.theta(0));
        const double damping = std::exp(point.theta(1) - point.theta(0));
        const double compliance = std::exp(-point.theta(0));
        m_speed = std::max(1.0, std::sqrt(stiffness));
        m_finite = point.finite() && stiffness < fastestRate && damping < fastestRate && compliance > 0 &&
                   std::isfinite(compliance);
        if (!m_finite)
            return;
        const double rest = problem.lag.rest;
        if (rest > 0)
            addLeg(point.theta, 0, rest);
        addLeg(point.theta, rest, 1);
    }
    [[nodiscard]] bool finite() const { return m_finite; }

    [[nodiscard]] Motion begin(const DuffingPoint& point) const
    {
        Motion motion;
        motion.x = point.x0;
        motion.v = point.v0 / m_speed;
        motion.dx[0] = 1;
        motion.dv[1] = 1 / m_speed;
        return motion;
    }
    /// Shows the motion at the time of the position within sample n, then goes on to sample n + 1; false when
    /// the motion has left all bounds.
    template <bool tangents, typename Use>
    bool advance(Motion& motion, std::ptrdiff_t n, const Use& use) const
    {
        const bool split = m_legs.size() > 1;
        if (!split)
            use(n, motion);
        for (const Leg& leg : m_legs) {
            run<tangents>(motion, leg, n);
            if (split && leg.begin == 0)
                use(n, motion);
        }
        return std::abs(motion.x) < outOfBounds;
    }

private:
    void addLeg(const Eigen::Vector3d& theta, double begin, double end)
    {
        Leg leg;
        leg.begin = begin;
        leg.end = end;
        leg.substeps = std::max(1, static_cast<int>(std::ceil(m_problem.substeps * (end - begin))));
        leg.step = duffingStep(theta, m_speed, (end - begin) / leg.substeps);
        m_legs.push_back(leg);
    }
    [[nodiscard]] double force(std::ptrdiff_t n) const
    {
        const auto last = static_cast<std::ptrdiff_t>(m_problem.force.size()) - 1;
        return m_problem.force[static_cast<std::size_t>(std::min(n, last))];
    }
    template <bool tangents>
    void run(Motion& motion, const Leg& leg, std::ptrdiff_t n) const
    {
        const double start = force(n);
        const double rise = m_problem.hold == ForceHold::First ? force(n + 1) - start : 0;
        const double length = (leg.end - leg.begin) / leg.substeps;
        for (int i = 0; i < leg.substeps; ++i) {
            const double from = start + rise * (leg.begin + i * length);
            step<tangents>(motion, leg.step, from, from + rise * length);
        }
    }
    template <bool tangents>
    void step(Motion& motion, const DuffingStepFamily& family, double fa, double fb) const;

    const DuffingProblem& m_problem;
    double m_cubic, m_speed = 1;
    bool m_finite = false;
    std::vector<Leg> m_legs;
};

/// The force of the cubic spring and its derivative by x.
struct SpringForce {
    double x3, g, slope;
    SpringForce(double x, double cubic) : x3(x * x * x), g(-cubic * x3), slope(-3 * cubic * x * x) {}
    /// In the direction of a tangent.
    [[nodiscard]] double along(double dx, bool isCubic) const { return slope * dx - (isCubic ? x3 : 0); }
};

template <bool tangents>
void Integrator::step(Motion& motion, const DuffingStepFamily& family, double fa, double fb) const
{
    const DuffingStep& c = family.value;
    const double x = motion.x;
    const double v = motion.v;
    const SpringForce start(x, m_cubic);
    const SpringForce half(c.half(0) * x + c.half(1) * v + c.halfForce(0) * fa + c.halfForce(1) * fb +
                               c.halfSpring * start.g,
                           m_cubic);
    const double linearX = c.phi(0, 0) * x + c.phi(0, 1) * v + c.forceStart(0) * fa + c.forceEnd(0) * fb;
    const double linearV = c.phi(1, 0) * x + c.phi(1, 1) * v + c.forceStart(1) * fa + c.forceEnd(1) * fb;
    const SpringForce end(linearX + c.predictSpring * half.g, m_cubic);
    motion.x = linearX + c.springStart(0) * start.g + c.springHalf(0) * half.g + c.springEnd(0) * end.g;
    motion.v = linearV + c.springStart(1) * start.g + c.springHalf(1) * half.g + c.springEnd(1) * end.g;
    if constexpr (tangents) {
        for (std::size_t i = 0; i < directions; ++i) {
            const bool isCubic = i == cubicDirection;
            const double dx = motion.dx[i];
            const double dv = motion.dv[i];
            double dHalf = c.half(0) * dx + c.half(1) * dv;
            double dx1 = c.phi(0, 0) * dx + c.phi(0, 1) * dv;
            double dv1 = c.phi(1, 0) * dx + c.phi(1, 1) * dv;
            double ownX = 0;
            double ownV = 0;
            double ownPredict = 0;
            if (i >= massDirection && i < cubicDirection) {
                // The coefficients themselves move.
                const DuffingStep& d = family.derivatives[i - massDirection];
                dHalf += d.half(0) * x + d.half(1) * v + d.halfForce(0) * fa + d.halfForce(1) * fb +
                         d.halfSpring * start.g;
                dx1 += d.phi(0, 0) * x + d.phi(0, 1) * v + d.forceStart(0) * fa + d.forceEnd(0) * fb;
                dv1 += d.phi(1, 0) * x + d.phi(1, 1) * v + d.forceStart(1) * fa + d.forceEnd(1) * fb;
                ownPredict = d.predictSpring * half.g;
                ownX = d.springStart(0) * start.g + d.springHalf(0) * half.g + d.springEnd(0) * end.g;
                ownV = d.springStart(1) * start.g + d.springHalf(1) * half.g + d.springEnd(1) * end.g;
            }
            const double startG = start.along(dx, isCubic);
            const double halfG = half.along(dHalf + c.halfSpring * startG, isCubic);
            const double endG = end.along(dx1 + ownPredict + c.predictSpring * halfG, isCubic);
            motion.dx[i] =
                dx1 + ownX + c.springStart(0) * startG + c.springHalf(0) * halfG + c.springEnd(0) * endG;
            motion.dv[i] =
                dv1 + ownV + c.springStart(1) * startG + c.springHalf(1) * halfG + c.springEnd(1) * endG;
        }
    }
}

/// Calls use(index, motion) for every position whose time the force covers; false when the motion left all
/// bounds.
template <bool tangents, typename Use>
bool forEachRow(const DuffingProblem& problem, const DuffingPoint& point, const Use& use)
{
    const Integrator integrator(problem, point);
    if (!integrator.finite())
        return false;
    Motion motion = integrator.begin(point);
    const std::ptrdiff_t begin = problem.firstRow() + problem.lag.samples;
    const std::ptrdiff_t end = problem.endRow() + problem.lag.samples;
    const auto show = [&](std::ptrdiff_t n, const Motion& at) {
        if (n >= begin)
            use(n - problem.lag.samples, at);
    };
    for (std::ptrdiff_t n = 0; n < end; ++n) {
        if (!integrator.advance<tangents>(motion, n, show))
            return false;
    }
    return true;
}

template <typename Row>
void fillRow(const DuffingProblem& problem, const Motion& motion, Row&& row)
{
    Eigen::Index at = 0;
    if (problem.freeInitialState) {
        row(at++) = motion.dx[0];
        row(at++) = motion.dx[1];
    }
    if (problem.freeOffset)
        row(at++) = 1;
    for (std::size_t i = massDirection; i < directions; ++i)
        row(at++) = motion.dx[i];
}

} // namespace

bool DuffingPoint::finite() const
{
    return theta.allFinite() && std::isfinite(x0) && std::isfinite(v0) && std::isfinite(offset) &&
           std::isfinite(cubic);
}

DuffingPoint DuffingPoint::moved(const DuffingProblem& problem, const Eigen::VectorXd& step) const
{
    DuffingPoint to = *this;
    Eigen::Index at = 0;
    if (problem.freeInitialState) {
        to.x0 += step(at++);
        to.v0 += step(at++);
    }
    if (problem.freeOffset)
        to.offset += step(at++);
    to.theta += step.segment<3>(at);
    to.cubic += step(at + 3);
    return to;
}

double cubicUnit(const DuffingProblem& problem)
{
    return problem.forceScale / problem.positionScale / problem.positionScale / problem.positionScale;
}

DuffingLinearization linearize(const DuffingProblem& problem, const DuffingPoint& point)
{
    DuffingLinearization out;
    const Eigen::Index unknowns = problem.unknowns();
    TallQr qr(unknowns + 1);
    const bool bounded = forEachRow<true>(problem, point, [&](std::ptrdiff_t index, const Motion& motion) {
        auto row = qr.nextRow();
        fillRow(problem, motion, row);
        const double e = problem.position[static_cast<std::size_t>(index)] - motion.x - point.offset;
        row(unknowns) = e;
        out.cost += e * e;
    });
    if (!bounded || !std::isfinite(out.cost))
        return out;
    const Eigen::MatrixXd triangle = qr.triangle();
    if (!triangle.allFinite())
        return out;
    out.triangle = triangle.topLeftCorner(unknowns, unknowns);
    out.residual = triangle.col(unknowns).head(unknowns);
    const ColumnElimination elimination = eliminateColumns(out.triangle, problem.nuisanceCount(), dependent);
    out.projected = elimination.rest;
    out.nuisanceRank = static_cast<int>(elimination.rank);
    out.finite = true;
    return out;
}

DuffingRows duffingRows(const DuffingProblem& problem, const DuffingPoint& point)
{
    DuffingRows rows;
    rows.sensitivities.resize(problem.rows(), problem.unknowns());
    rows.residuals.reserve(static_cast<std::size_t>(problem.rows()));
    forEachRow<true>(problem, point, [&](std::ptrdiff_t index, const Motion& motion) {
        fillRow(problem, motion, rows.sensitivities.row(index - problem.firstRow()));
        rows.residuals.push_back(problem.position[static_cast<std::size_t>(index)] - motion.x - point.offset);
    });
    return rows;
}

std::optional<double> costAt(const DuffingProblem& problem, const DuffingPoint& point)
{
    double cost = 0;
    const bool bounded = forEachRow<false>(problem, point, [&](std::ptrdiff_t index, const Motion& motion) {
        const double e = problem.position[static_cast<std::size_t>(index)] - motion.x - point.offset;
        cost += e * e;
    });
    return bounded && std::isfinite(cost) ? std::optional(cost) : std::nullopt;
}

std::vector<double> positionsAt(const DuffingProblem& problem, const DuffingPoint& point)
{
    const auto count = static_cast<std::ptrdiff_t>(problem.force.size());
    std::vector<double> positions(problem.force.size(), point.x0 + point.offset);
    const Integrator integrator(problem, point);
    if (!integrator.finite())
        return {};
    Motion motion = integrator.begin(point);
    const std::ptrdiff_t later = std::min(problem.lag.samples, count);
    const auto show = [&](std::ptrdiff_t n, const Motion& at) {
        if (n >= later)
            positions[static_cast<std::size_t>(n - later)] = at.x + point.offset;
    };
    for (std::ptrdiff_t n = 0; n - later < count; ++n) {
        if (!integrator.advance<false>(motion, n, show))
            return {};
    }
    return positions;
}

int suitableSubsteps(const DuffingPoint& point, double reach)
{
    const double stiffest = std::exp(point.theta(2)) + 3 * std::abs(point.cubic) * reach * reach;
    const double angle = std::sqrt(stiffest * std::exp(-point.theta(0)));
    const double steps = std::ceil(angle / largestSubstepAngle);
    return steps >= 1 ? static_cast<int>(std::min<double>(steps, mostSubsteps)) : 1;
}

} // namespace gripscope
