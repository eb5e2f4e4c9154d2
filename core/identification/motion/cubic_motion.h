// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion_integrator.h"

#include <Eigen/Core>

#include <cmath>
#include <deque>

namespace gripscope {

/// The answers of m x'' + b x' + k x = F over a step, as products: to its start, to a force F(0) + F' t and
/// to a force that is a polynomial through the nodes of Gauss's quadrature,
///     x_i = P_i (x(0), v(0), F(0), F') + sum_j K_ij g_j,   K_ij = integral_0^ti h(ti - t) l_j(t) dt,
/// h the answer to an impulse, l_j Lagrange's polynomial of node j (the variation of constants, collocated:
/// Hochbruck and Ostermann 2010, 2.4). Exact to rounding but for the polynomial.
struct CollocationStep {
    static constexpr int nodes = 6;
    using AtNodes = Eigen::Matrix<double, nodes, 1>;
    using EndByNode = Eigen::Matrix<double, 2, nodes>;
    /// Of x(0), v(0), F(0) and F'.
    using Given = Eigen::Matrix<double, 4, 1>;

    double duration = 0;
    Eigen::Matrix<double, nodes, 4> positions, speeds;                 ///< at the nodes, from what is given
    Eigen::Matrix<double, nodes, nodes> positionsByNode, speedsByNode; ///< from the force at each
    Eigen::Matrix<double, 2, 4> end;                                   ///< position and speed after the step
    EndByNode endByNode;
    AtNodes times; ///< of the nodes
    AtNodes
        lastDegree; ///< of the values at the nodes: Legendre's coefficient of the polynomial's last degree

    /// x = linear - K k3 x^3, K `positionsByNode`, k3 `cubic`; what is left moves the step's end by less than
    /// rounding: what a round changes, or, as each changes the same share of the one before, what the next
    /// would. False: it does not settle.
    [[nodiscard]] bool settle(double cubic, const AtNodes& linear, AtNodes& x) const;
    /// W of W (I + K diag(c)) = G diag(c), K `positionsByNode`, c `bend`, G `endByNode`.
    [[nodiscard]] EndByNode bentBack(const AtNodes& bend) const;
};

/// The duration: at most about the shortest of the part's own times, 1 / (b/m + sqrt(k/m)).
[[nodiscard]] CollocationStep collocationStep(double mass, double damping, double stiffness, double duration);

/// What MotionIntegrator does where a cubic spring is all that bends the motion: the linear part goes by the
/// products of CollocationStep, the cubic spring's force is its polynomial g_j = -k3 x_j^3, settled by
/// iterating. The derivatives are those of the same equations: each parameter's is the answer to the force
/// that it changes.
///
/// Where the polynomial's last degree is 1e-7 of the motion or less its remainder at the step's end is about
/// the square of that (Gauss's nodes, of twice the degree). Else the step is halved, and is the integrator's
/// where that does not help.
template <typename Number>
class CubicMotion {
public:
    using Coefficients = typename MotionIntegrator<Number>::Coefficients;

    [[nodiscard]] static bool describes(const MotionTerms& terms)
    {
        return terms.cubic && terms.mass && terms.damping && terms.spring && !terms.relaxation &&
               !terms.friction && !terms.eachWay;
    }

    CubicMotion(const MotionTerms& terms, const Coefficients& coefficients)
        : m_terms(terms), m_c(coefficients), m_exact(terms, coefficients), m_rate(m_exact.rate())
    {
    }

    void begin(const Number& x, const Number& v, const Number& /*strain*/)
    {
        m_x = x;
        m_v = v;
    }
    /// As MotionIntegrator::advance.
    [[nodiscard]] bool advance(double duration, double from, double to)
    {
        const int steps = MotionIntegrator<Number>::stepsOver(m_rate * duration);
        const double step = duration / steps;
        const double slope = (to - from) / duration;
        for (int i = 0; i < steps; ++i) {
            if (!advanceOver(step, from + slope * (i * step), slope, mostHalvings))
                return false;
        }
        return steps > 0 && std::isfinite(valuePart(m_x)) && std::isfinite(valuePart(m_v));
    }

    [[nodiscard]] const Number& position() const { return m_x; }
    [[nodiscard]] const Number& speed() const { return m_v; }
    [[nodiscard]] Number strain() const { return Number(0); }

private:
    using P = MotionParameter;
    static constexpr int nodes = CollocationStep::nodes;
    using AtNodes = CollocationStep::AtNodes;
    using EndByNode = CollocationStep::EndByNode;
    using Slopes = typename SlopesOf<Number>::Type;

    [[nodiscard]] const Number& of(P parameter) const { return m_c[static_cast<std::size_t>(parameter)]; }
    [[nodiscard]] double valueOf(P parameter) const { return valuePart(of(parameter)); }

    /// A record has two durations at most, before and after the position's time, and halves of them.
    const CollocationStep& stepOver(double duration)
    {
        for (const CollocationStep& known : m_steps)
            if (known.duration == duration)
                return known;
        m_steps.push_back(
            collocationStep(valueOf(P::Mass), valueOf(P::Damping), valueOf(P::Stiffness), duration));
        return m_steps.back();
    }

    [[nodiscard]] bool advanceExactly(double duration, double from, double to)
    {
        m_exact.begin(m_x, m_v, Number(0), from);
        if (!m_exact.advance(duration, from, to))
            return false;
        m_x = m_exact.position();
        m_v = m_exact.speed();
        return true;
    }

    /// In one step, else in two of half of it, else by the series.
    [[nodiscard]] bool advanceOver(double duration, double from, double slope, int halvings)
    {
        if (advanceStep(duration, from, slope))
            return true;
        if (halvings == 0)
            return advanceExactly(duration, from, from + slope * duration);
        const double half = duration / 2;
        return advanceOver(half, from, slope, halvings - 1) &&
               advanceOver(half, from + slope * half, slope, halvings - 1);
    }
    [[nodiscard]] bool advanceStep(double duration, double from, double slope)
    {
        const CollocationStep& step = stepOver(duration);
        const double force = from + (m_terms.forceOffset ? valueOf(P::ForceOffset) : 0);
        const CollocationStep::Given given{valuePart(m_x), valuePart(m_v), force, slope};
        const AtNodes linear = step.positions * given;
        // To begin with the spring's force runs straight.
        const double x0 = given(0);
        AtNodes x = linear - valueOf(P::Cubic) * x0 * x0 *
                                 (x0 * step.positions.col(2) + 3 * given(1) * step.positions.col(3));
        if (!step.settle(valueOf(P::Cubic), linear, x))
            return false;
        const AtNodes cubes = x.array().cube();
        const Eigen::Vector2d end = step.end * given - valueOf(P::Cubic) * (step.endByNode * cubes);
        const double last =
            std::abs(valueOf(P::Cubic) * step.lastDegree.dot(cubes)) * step.endByNode.row(0).cwiseAbs().sum();
        if (!(last <= smallest * (std::abs(end(0)) + std::abs(valuePart(m_x)))))
            return false;
        moveTo(step, given, end, x);
        return true;
    }

    void moveTo(const CollocationStep& step, const CollocationStep::Given& given, const Eigen::Vector2d& end,
                const AtNodes& x)
    {
        if constexpr (std::is_same_v<Number, double>) {
            m_x = end(0);
            m_v = end(1);
        } else {
            moveSlopes(step, given, x);
            m_x.value = end(0);
            m_v.value = end(1);
        }
    }

    /// The derivatives d of the positions at the nodes answer to the start's, s, and to the forces f that the
    /// parameters' changes are, and bend as the spring does; those of the end follow:
    ///     (I + K diag(c)) d = P s + K f,   end = E s + G (f - c d),   c = 3 k3 x^2
    ///         = (E - W P) s + (G - W K) f,   W (I + K diag(c)) = G diag(c),
    /// with two rows of W for position and speed, whatever the number of derivatives.
    void moveSlopes(const CollocationStep& step, const CollocationStep::Given& given, const AtNodes& x)
    {
        const AtNodes bend = 3 * valueOf(P::Cubic) * x.array().square();
        const EndByNode back = step.bentBack(bend);
        const EndByNode toForces = step.endByNode - back * step.positionsByNode;
        const Eigen::Matrix2d toStart =
            step.end.template leftCols<2>() - back * step.positions.template leftCols<2>();
        const Eigen::Matrix<double, 2, 5> toChanges = toForces * forcesOfChanges(step, given, x);
        const Number x0 = m_x;
        const Number v0 = m_v;
        const auto slopeOf = [&](Eigen::Index row) {
            Slopes slope = toStart(row, 0) * x0.slope + toStart(row, 1) * v0.slope +
                           toChanges(row, 0) * of(P::Mass).slope + toChanges(row, 1) * of(P::Damping).slope +
                           toChanges(row, 2) * of(P::Stiffness).slope +
                           toChanges(row, 3) * of(P::Cubic).slope;
            if (m_terms.forceOffset)
                slope += toChanges(row, 4) * of(P::ForceOffset).slope;
            return slope;
        };
        m_x.slope = slopeOf(0);
        m_v.slope = slopeOf(1);
    }
    /// At the nodes for changes of mass, damping, stiffness, cubic spring and offset of the force.
    [[nodiscard]] Eigen::Matrix<double, nodes, 5>
    forcesOfChanges(const CollocationStep& step, const CollocationStep::Given& given, const AtNodes& x) const
    {
        const AtNodes cubes = x.array().cube();
        const AtNodes v = step.speeds * given - valueOf(P::Cubic) * (step.speedsByNode * cubes);
        const AtNodes a = (given(2) + given(3) * step.times.array() - valueOf(P::Damping) * v.array() -
                           valueOf(P::Stiffness) * x.array() - valueOf(P::Cubic) * cubes.array()) /
                          valueOf(P::Mass);
        Eigen::Matrix<double, nodes, 5> forces;
        forces << -a, -v, -x, -cubes, AtNodes::Ones();
        return forces;
    }

    static constexpr double smallest = 1e-7;
    static constexpr int mostHalvings = 3;
    const MotionTerms m_terms;
    const Coefficients m_c;
    MotionIntegrator<Number> m_exact;
    const double m_rate; ///< of the linear part: at its zero the cubic spring has no stiffness
    Number m_x{}, m_v{};
    std::deque<CollocationStep> m_steps;
};

} // namespace gripscope
