// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion_model.h"

#include "core/identification/motion/cubic_motion.h"
#include "core/identification/motion/friction_motion.h"
#include "core/identification/motion/linear_motion.h"
#include "core/identification/motion/motion_integrator.h"
#include "core/math/dual.h"
#include "core/math/sequential_qr.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

namespace gripscope {

namespace {

using P = MotionParameter;

/// A spring without mass and damping: it is where the force holds it, at once.
template <typename Number>
class SpringAlone {
public:
    SpringAlone() = default;
    SpringAlone(const Number& x, const Number& stiffness) : m_position(x), m_stiffness(stiffness) {}
    [[nodiscard]] bool advance(double /*duration*/, double /*from*/, double to)
    {
        m_position = Number(to) / m_stiffness;
        return std::isfinite(valuePart(m_position));
    }
    [[nodiscard]] const Number& position() const { return m_position; }

private:
    Number m_position, m_stiffness;
};

template <typename Number>
using CubicWithFriction = FrictionMotion<Number, CubicMotion<Number>>;

/// A motion from a point, by the cheapest way that its terms allow; a Dual has a direction for each unknown
/// but the offset.
template <typename Number>
class Motion {
public:
    Motion(const MotionProblem& problem, const MotionPoint& point) : m_problem(problem)
    {
        int direction = 0;
        const auto start = [&](double value, bool sought) {
            return sought ? seeded(value, direction++, 1) : Number(value);
        };
        const Number x = start(point.x0, problem.seeksPosition());
        const Number v = start(point.v0, problem.seeksSpeed());
        const Number strain = start(point.strain0, problem.seeksStrain());
        const MotionTerms& terms = problem.terms;
        const auto c = coefficients(problem, point);
        if (!terms.damping)
            m_way.template emplace<SpringAlone<Number>>(x, c[static_cast<std::size_t>(P::Stiffness)]);
        else if (LinearMotion<Number>::describes(terms))
            m_way.template emplace<LinearMotion<Number>>(terms, c).begin(x, v, strain);
        else if (CubicMotion<Number>::describes(terms))
            m_way.template emplace<CubicMotion<Number>>(terms, c).begin(x, v, strain);
        else if (FrictionMotion<Number>::describes(terms))
            m_way.template emplace<FrictionMotion<Number>>(terms, c).begin(x, v, strain);
        else if (CubicWithFriction<Number>::describes(terms))
            m_way.template emplace<CubicWithFriction<Number>>(terms, c).begin(x, v, strain);
        else
            m_way.template emplace<MotionIntegrator<Number>>(terms, c).begin(x, v, strain,
                                                                             problem.force.front());
    }

    /// From the first force's time on, `count` times to the next; show(n, x) at the position's time in
    /// between. False: out of bounds.
    template <typename Show>
    bool run(std::ptrdiff_t count, const Show& show)
    {
        return std::visit(
            [&](auto& way) {
                for (std::ptrdiff_t n = 0; n < count; ++n)
                    if (!advance(way, n, show))
                        return false;
                return true;
            },
            m_way);
    }

private:
    template <typename Way, typename Show>
    bool advance(Way& way, std::ptrdiff_t n, const Show& show) const
    {
        const auto last = static_cast<std::ptrdiff_t>(m_problem.force.size()) - 1;
        const double from = m_problem.force[static_cast<std::size_t>(std::min(n, last))];
        const double next = m_problem.hold == ForceHold::First
                                ? m_problem.force[static_cast<std::size_t>(std::min(n + 1, last))]
                                : from;
        const double rest = m_problem.lag.rest;
        const double between = from + rest * (next - from);
        if (rest > 0 && !way.advance(rest, from, between))
            return false;
        show(n, way.position());
        return way.advance(1 - rest, between, next);
    }
    static Number seeded(double value, int direction, double rate)
    {
        if constexpr (std::is_same_v<Number, double>)
            return value;
        else
            return Number(value, direction, rate);
    }
    static typename MotionIntegrator<Number>::Coefficients coefficients(const MotionProblem& problem,
                                                                        const MotionPoint& point)
    {
        typename MotionIntegrator<Number>::Coefficients all{};
        int direction = problem.startUnknowns() - (problem.seeksOffset() ? 1 : 0);
        for (const P parameter : problem.terms.parameters()) {
            const double value = point.values[parameter];
            all[static_cast<std::size_t>(parameter)] =
                seeded(value, direction++, isPositive(parameter) ? value : 1);
        }
        return all;
    }

    const MotionProblem& m_problem;
    std::variant<SpringAlone<Number>, LinearMotion<Number>, CubicMotion<Number>, FrictionMotion<Number>,
                 CubicWithFriction<Number>, MotionIntegrator<Number>>
        m_way;
};

/// Calls use(index, x) for every measured position whose time the force covers.
template <typename Number, typename Use>
bool forEachRow(const MotionProblem& problem, const MotionPoint& point, const Use& use)
{
    if (!point.isPhysical(problem.terms))
        return false;
    Motion<Number> motion(problem, point);
    const std::ptrdiff_t begin = problem.firstRow() + problem.lag.samples;
    const std::ptrdiff_t end = problem.endRow() + problem.lag.samples;
    const auto show = [&](std::ptrdiff_t n, const Number& x) {
        if (n >= begin && !problem.isLost(n - problem.lag.samples))
            use(n - problem.lag.samples, x);
    };
    return motion.run(end, show);
}

/// use(index, residual, fill): fill(row) writes the sensitivities.
template <int N, typename Use>
bool forEachLinearizedRow(const MotionProblem& problem, const MotionPoint& point, const Use& use)
{
    const int offset = problem.seeksOffset() ? problem.startUnknowns() - 1 : -1;
    const int unknowns = problem.unknowns();
    return forEachRow<Dual<N>>(problem, point, [&](std::ptrdiff_t index, const Dual<N>& x) {
        const double e = problem.position[static_cast<std::size_t>(index)] - x.value - point.offset;
        use(e, [&](auto&& row) {
            for (int i = 0, direction = 0; i < unknowns; ++i)
                row(i) = i == offset ? 1 : x.slope(direction++);
        });
    });
}

/// The fewest directions that hold all unknowns: each costs.
template <typename Use>
bool forEachLinearizedRow(const MotionProblem& problem, const MotionPoint& point, const Use& use)
{
    const int directions = problem.unknowns() - (problem.seeksOffset() ? 1 : 0);
    if (directions <= 6)
        return forEachLinearizedRow<6>(problem, point, use);
    if (directions <= 8)
        return forEachLinearizedRow<8>(problem, point, use);
    return directions <= 10 ? forEachLinearizedRow<10>(problem, point, use)
                            : forEachLinearizedRow<14>(problem, point, use);
}

} // namespace

int MotionProblem::startUnknowns() const
{
    return int(seeksPosition()) + int(seeksSpeed()) + int(seeksStrain()) + int(seeksOffset());
}

int MotionProblem::unknowns() const
{
    return startUnknowns() + static_cast<int>(terms.parameters().size());
}

Eigen::Index MotionProblem::columnOf(P parameter) const
{
    const std::vector<P> all = terms.parameters();
    return startUnknowns() + (std::ranges::find(all, parameter) - all.begin());
}

double MotionProblem::priorResidual(double friction) const
{
    return frictionPrior ? frictionPrior->weight * (frictionPrior->value - friction) : 0;
}

double MotionProblem::unitOf(P parameter) const
{
    const double stiffness = forceScale / positionScale;
    switch (parameter) {
    case P::Mass:
        return stiffness * sampleTime_s * sampleTime_s;
    case P::Damping:
    case P::DampingBack:
        return stiffness * sampleTime_s;
    case P::Stiffness:
    case P::Relaxing:
        return stiffness;
    case P::RelaxationTime:
        return sampleTime_s;
    case P::Cubic:
        return stiffness / positionScale / positionScale;
    case P::Friction:
    case P::FrictionBack:
    case P::ForceOffset:
        break;
    }
    return forceScale;
}

bool MotionPoint::isPhysical(const MotionTerms& terms) const
{
    if (!std::isfinite(x0) || !std::isfinite(v0) || !std::isfinite(strain0) || !std::isfinite(offset))
        return false;
    return std::ranges::all_of(terms.parameters(), [this](P parameter) {
        const double value = values[parameter];
        return std::isfinite(value) && (!isPositive(parameter) || value > 0) &&
               (!isFriction(parameter) || value >= 0);
    });
}

MotionPoint MotionPoint::moved(const MotionProblem& problem, const Eigen::VectorXd& step) const
{
    MotionPoint to = *this;
    Eigen::Index at = 0;
    if (problem.seeksPosition())
        to.x0 += step(at++);
    if (problem.seeksSpeed())
        to.v0 += step(at++);
    if (problem.seeksStrain())
        to.strain0 += step(at++);
    if (problem.seeksOffset())
        to.offset += step(at++);
    for (const P parameter : problem.terms.parameters()) {
        const double by = step(at++);
        double& value = to.values[parameter];
        if (isPositive(parameter))
            value *= std::exp(by);
        else
            value = isFriction(parameter) ? std::max(0.0, value + by) : value + by;
    }
    return to;
}

MotionValues inChannelUnits(const MotionProblem& problem, const MotionValues& values)
{
    MotionValues out;
    for (const P parameter : problem.terms.parameters())
        out[parameter] = values[parameter] * problem.unitOf(parameter);
    return out;
}

MotionValues inProblemUnits(const MotionProblem& problem, const MotionValues& values)
{
    MotionValues out;
    for (const P parameter : problem.terms.parameters())
        out[parameter] = values[parameter] / problem.unitOf(parameter);
    return out;
}

std::vector<Eigen::Index> MotionLinearization::moving() const
{
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < triangle.cols(); ++i)
        if (triangle.col(i).norm() > 0)
            columns.push_back(i);
    return columns;
}

bool MotionLinearization::movesEveryParameter() const
{
    const std::vector<Eigen::Index> columns = moving();
    const auto parameters =
        std::ranges::count_if(columns, [this](Eigen::Index i) { return i >= startUnknowns; });
    return parameters == triangle.cols() - startUnknowns;
}

MotionLinearization linearize(const MotionProblem& problem, const MotionPoint& point)
{
    MotionLinearization out;
    out.startUnknowns = problem.startUnknowns();
    const Eigen::Index unknowns = problem.unknowns();
    SequentialQr qr(unknowns + 1);
    const bool bounded = forEachLinearizedRow(problem, point, [&](double e, const auto& fill) {
        auto row = qr.nextRow();
        fill(row);
        row(unknowns) = e;
        out.cost += e * e;
    });
    if (problem.frictionPrior) {
        const double e = problem.priorResidual(point.values[P::Friction]);
        auto row = qr.nextRow();
        row.setZero();
        row(problem.columnOf(P::Friction)) = problem.frictionPrior->weight;
        row(unknowns) = e;
        out.cost += e * e;
    }
    if (!bounded || !std::isfinite(out.cost))
        return out;
    const Eigen::MatrixXd& triangle = qr.triangle();
    if (!triangle.allFinite())
        return out;
    out.triangle = triangle.topLeftCorner(unknowns, unknowns);
    out.residual = triangle.col(unknowns).head(unknowns);
    out.finite = true;
    return out;
}

std::optional<MotionRows> motionRows(const MotionProblem& problem, const MotionPoint& point)
{
    MotionRows rows;
    rows.sensitivities.resize(problem.measuredRows(), problem.unknowns());
    rows.residuals.reserve(static_cast<std::size_t>(problem.measuredRows()));
    const bool bounded = forEachLinearizedRow(problem, point, [&](double e, const auto& fill) {
        fill(rows.sensitivities.row(static_cast<Eigen::Index>(rows.residuals.size())));
        rows.residuals.push_back(e);
    });
    if (!bounded || !rows.sensitivities.allFinite())
        return std::nullopt;
    return rows;
}

std::optional<MotionCost> costAt(const MotionProblem& problem, const MotionPoint& point)
{
    MotionCost found;
    found.cost = std::pow(problem.priorResidual(point.values[P::Friction]), 2);
    const bool bounded = forEachRow<double>(problem, point, [&](std::ptrdiff_t index, double x) {
        const double e = problem.position[static_cast<std::size_t>(index)] - x - point.offset;
        found.cost += e * e;
        found.mean += e;
    });
    found.mean /= static_cast<double>(std::max<std::ptrdiff_t>(problem.measuredRows(), 1));
    return bounded && std::isfinite(found.cost) ? std::optional(found) : std::nullopt;
}

std::vector<double> positionsAt(const MotionProblem& problem, const MotionPoint& point)
{
    if (!point.isPhysical(problem.terms))
        return {};
    const auto count = static_cast<std::ptrdiff_t>(problem.force.size());
    std::vector<double> positions(problem.force.size(), point.x0 + point.offset);
    Motion<double> motion(problem, point);
    const std::ptrdiff_t later = std::min(problem.lag.samples, count);
    const auto show = [&](std::ptrdiff_t n, double x) {
        if (n >= later)
            positions[static_cast<std::size_t>(n - later)] = x + point.offset;
    };
    if (!motion.run(count + later, show))
        return {};
    return positions;
}

} // namespace gripscope
