// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/duffing/duffing_model.h"

#include "core/math/decompositions.h"
#include "core/math/matrix_exponential.h"
#include "core/math/sequential_qr.h"

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace gripscope {

namespace {

/// Coefficients of one step of M x'' + B x' + K x = F + g, g = -K3 x^3 the force of the cubic spring, for a
/// force that runs straight from Fa to Fb within the step. The state is (x, v), v = x' / speed.
///
/// The linear spring is integrated exactly; g is taken for the parabola through its values at the beginning,
/// the middle and the end of the step, found by a constant g for the middle and by the middle's g for the
/// end:
///     xh = half . (x, v) + halfForce . (Fa, Fb) + halfSpring g(x)
///     xe = [phi (x, v) + forceStart Fa + forceEnd Fb]_x + predictSpring g(xh)
///     (x, v) <- phi (x, v) + forceStart Fa + forceEnd Fb + springStart g(x) + springHalf g(xh) + springEnd
///     g(xe)
/// With K = B = 0 that is Nystroem's method of order 4 (1925); with them it is its exponential form
/// (Hochbruck and Ostermann, Exponential integrators, 2010): order 4, exact for K3 = 0 at any step and any
/// damping.
struct DuffingStep {
    Eigen::RowVector2d half, halfForce;
    double halfSpring = 0, predictSpring = 0;
    Eigen::Matrix2d phi;
    Eigen::Vector2d forceStart, forceEnd, springStart, springHalf, springEnd;
};

/// A step and its exact derivatives by ln M, ln B and ln K.
struct DuffingStepFamily {
    DuffingStep value;
    std::array<DuffingStep, 3> derivatives;
};

/// What the linear spring answers to a start and to the forces 1, tau and tau^2 / 2, tau from 0 to 1.
struct Responses {
    Eigen::Matrix2d phi;
    Eigen::Vector2d constant, ramp, parabola;
};
struct ResponseFamily {
    Responses value;
    std::array<Responses, 3> derivatives;
};

using Generator = Eigen::Matrix<double, 5, 5>;

Responses responsesIn(const Eigen::MatrixXd& flow, double compliance)
{
    return {flow.topLeftCorner<2, 2>(), compliance * flow.block<2, 1>(0, 2),
            compliance * flow.block<2, 1>(0, 3), compliance * flow.block<2, 1>(0, 4)};
}

/// exp(generator) in the upper left, its derivative in the direction given in the upper right.
Eigen::MatrixXd flowAndDerivative(const Generator& generator, const Generator& direction)
{
    Eigen::MatrixXd pair = Eigen::MatrixXd::Zero(10, 10);
    pair.topLeftCorner<5, 5>() = generator;
    pair.bottomRightCorner<5, 5>() = generator;
    pair.topRightCorner<5, 5>() = direction;
    return matrixExponential(pair);
}

/// By ln M: the matrix depends on B / M and K / M alone, the size of the force on 1 / M.
Responses byMass(const Responses& value, const Responses& byDamping, const Responses& byStiffness)
{
    return {-byDamping.phi - byStiffness.phi, -value.constant - byDamping.constant - byStiffness.constant,
            -value.ramp - byDamping.ramp - byStiffness.ramp,
            -value.parabola - byDamping.parabola - byStiffness.parabola};
}

ResponseFamily responsesOver(const Eigen::Vector3d& theta, double speed, double length)
{
    const double stiffness = std::exp(theta(2) - theta(0));
    const double damping = std::exp(theta(1) - theta(0));
    const double compliance = std::exp(-theta(0));
    Generator byDamping = Generator::Zero();
    byDamping(1, 1) = -damping * length;
    Generator byStiffness = Generator::Zero();
    byStiffness(1, 0) = -stiffness * length / speed;
    Generator generator = byDamping + byStiffness;
    generator(0, 1) = speed * length;
    generator(1, 2) = length / speed;
    generator(2, 3) = 1;
    generator(3, 4) = 1;
    const Eigen::MatrixXd damped = flowAndDerivative(generator, byDamping);
    const Eigen::MatrixXd stiff = flowAndDerivative(generator, byStiffness);
    ResponseFamily family;
    family.value = responsesIn(damped.topLeftCorner<5, 5>(), compliance);
    family.derivatives[1] = responsesIn(damped.topRightCorner<5, 5>(), compliance);
    family.derivatives[2] = responsesIn(stiff.topRightCorner<5, 5>(), compliance);
    family.derivatives[0] = byMass(family.value, family.derivatives[1], family.derivatives[2]);
    return family;
}

/// Linear in the responses, so that it serves the derivatives as well.
DuffingStep compose(const Responses& half, const Responses& whole)
{
    DuffingStep step;
    step.half = half.phi.row(0);
    step.halfForce = {half.constant(0) - half.ramp(0) / 2, half.ramp(0) / 2};
    step.halfSpring = half.constant(0);
    step.predictSpring = whole.constant(0);
    step.phi = whole.phi;
    step.forceStart = whole.constant - whole.ramp;
    step.forceEnd = whole.ramp;
    step.springStart = whole.constant - 3 * whole.ramp + 4 * whole.parabola;
    step.springHalf = 4 * whole.ramp - 8 * whole.parabola;
    step.springEnd = 4 * whole.parabola - whole.ramp;
    return step;
}

/// Over `length` units of time, theta = (ln M, ln B, ln K); from matrix exponentials (Van Loan 1978), their
/// derivatives from those of block triangular matrices (Najfeld and Havel 1995). K / M and B / M times the
/// unit of time must be finite.
DuffingStepFamily duffingStep(const Eigen::Vector3d& theta, double speed, double length)
{
    const ResponseFamily half = responsesOver(theta, speed, length / 2);
    const ResponseFamily whole = responsesOver(theta, speed, length);
    DuffingStepFamily family;
    family.value = compose(half.value, whole.value);
    for (std::size_t i = 0; i < 3; ++i)
        family.derivatives[i] = compose(half.derivatives[i], whole.derivatives[i]);
    return family;
}

/// Positions are about 1; a motion that goes this far has left the well of a softening spring.
constexpr double outOfBounds = 1e6;
/// Rates in samples above which the matrix exponential has no digits left.
constexpr double fastestDuffingRate = 1e12;
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
        m_finite = point.finite() && stiffness < fastestDuffingRate && damping < fastestDuffingRate &&
                   compliance > 0 && std::isfinite(compliance);
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

/// Calls use(index, motion) for every measured position whose time the force covers; false when the motion
/// left all bounds.
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
        if (n >= begin && !problem.isLost(n - problem.lag.samples))
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
    SequentialQr qr(unknowns + 1);
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
    const ColumnElimination elimination =
        eliminateColumns(out.triangle, problem.nuisanceCount(), dependentNuisance);
    out.projected = elimination.rest;
    out.nuisanceRank = static_cast<int>(elimination.rank);
    out.finite = true;
    return out;
}

DuffingRows duffingRows(const DuffingProblem& problem, const DuffingPoint& point)
{
    DuffingRows rows;
    rows.sensitivities.resize(problem.measuredRows(), problem.unknowns());
    rows.residuals.reserve(static_cast<std::size_t>(problem.measuredRows()));
    forEachRow<true>(problem, point, [&](std::ptrdiff_t index, const Motion& motion) {
        fillRow(problem, motion, rows.sensitivities.row(static_cast<Eigen::Index>(rows.residuals.size())));
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
