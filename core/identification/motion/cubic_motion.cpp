// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/cubic_motion.h"

#include "core/math/gauss_legendre.h"

#include <array>
#include <cmath>

namespace gripscope {

namespace {

constexpr int nodes = CollocationStep::nodes;
using AtNodes = CollocationStep::AtNodes;

/// Between 0 and 1.
const QuadratureRule& nodesOfStep()
{
    static const QuadratureRule rule = gaussLegendre(nodes).between(0, 1);
    return rule;
}

AtNodes lagrangePolynomials(double place)
{
    const Eigen::VectorXd& at = nodesOfStep().places;
    AtNodes values = AtNodes::Ones();
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i)
            if (i != j)
                values(j) *= (place - at(i)) / (at(j) - at(i));
    return values;
}

/// For times between 0 and 1, a row a node's time and one for 1: the places of a quadrature up to there, and
/// there the weighted polynomials.
struct WeightedPolynomials {
    static constexpr int points = 8;
    std::array<double, points> place{};
    std::array<AtNodes, points> weights{};
};
std::array<WeightedPolynomials, nodes + 1> weightedPolynomials()
{
    const QuadratureRule rule = gaussLegendre(WeightedPolynomials::points).between(0, 1);
    std::array<WeightedPolynomials, nodes + 1> all;
    for (int i = 0; i <= nodes; ++i) {
        const double until = i < nodes ? nodesOfStep().places(i) : 1;
        for (int p = 0; p < WeightedPolynomials::points; ++p) {
            const double at = until * rule.places(p);
            all[std::size_t(i)].place[std::size_t(p)] = at;
            all[std::size_t(i)].weights[std::size_t(p)] = until * rule.weights(p) * lagrangePolynomials(at);
        }
    }
    return all;
}

/// h, the position after an impulse of 1, as a Taylor series: m h'' + b h' + k h = 0, h(0) = 0, h'(0) = 1/m.
/// All other answers are its derivatives and integrals.
class ImpulseResponse {
public:
    ImpulseResponse(double mass, double damping, double stiffness)
        : m_mass(mass), m_damping(damping), m_stiffness(stiffness)
    {
        m_series[1] = 1 / mass;
        for (std::size_t n = 0; n + 2 < terms; ++n) {
            const auto next = static_cast<double>(n + 1);
            m_series[n + 2] =
                -(damping * next * m_series[n + 1] + stiffness * m_series[n]) / (mass * next * (next + 1));
        }
    }
    /// Position and speed.
    [[nodiscard]] Eigen::Vector2d at(double t) const
    {
        double position = 0;
        double speed = 0;
        for (std::size_t n = terms; n-- > 0;) {
            speed = speed * t + position;
            position = position * t + m_series[n];
        }
        return {position, speed};
    }
    /// To x(0), v(0), F(0) and F'.
    [[nodiscard]] Eigen::Matrix<double, 2, 4> toGiven(double t) const
    {
        double once = 0; // integrated from 0 on
        double twice = 0;
        for (std::size_t n = terms; n-- > 0;) {
            const auto power = static_cast<double>(n);
            once = once * t + m_series[n] / (power + 1);
            twice = twice * t + m_series[n] / ((power + 1) * (power + 2));
        }
        once *= t;
        twice *= t * t;
        const Eigen::Vector2d h = at(t);
        Eigen::Matrix<double, 2, 4> answers;
        answers << m_mass * h(1) + m_damping * h(0), m_mass * h(0), once, twice, //
            -m_stiffness * h(0), m_mass * h(1), h(0), once;
        return answers;
    }

private:
    static constexpr std::size_t terms = 24;
    double m_mass, m_damping, m_stiffness;
    std::array<double, terms> m_series{};
};

} // namespace

CollocationStep collocationStep(double mass, double damping, double stiffness, double duration)
{
    static const std::array<WeightedPolynomials, nodes + 1> polynomials = weightedPolynomials();
    const ImpulseResponse response(mass, damping, stiffness);
    CollocationStep step;
    step.duration = duration;
    const QuadratureRule& rule = nodesOfStep();
    for (int i = 0; i <= nodes; ++i) {
        const double place = i < nodes ? rule.places(i) : 1;
        const Eigen::Matrix<double, 2, 4> given = response.toGiven(place * duration);
        Eigen::Matrix<double, 2, nodes> byNode = Eigen::Matrix<double, 2, nodes>::Zero();
        const WeightedPolynomials& weighted = polynomials[std::size_t(i)];
        for (std::size_t p = 0; p < weighted.place.size(); ++p)
            byNode += response.at((place - weighted.place[p]) * duration) *
                      (duration * weighted.weights[p]).transpose();
        if (i == nodes) {
            step.end = given;
            step.endByNode = byNode;
            break;
        }
        step.positions.row(i) = given.row(0);
        step.speeds.row(i) = given.row(1);
        step.positionsByNode.row(i) = byNode.row(0);
        step.speedsByNode.row(i) = byNode.row(1);
        step.times(i) = place * duration;
        step.lastDegree(i) = (2 * nodes - 1) * rule.weights(i) * std::legendre(nodes - 1, 2 * place - 1);
    }
    return step;
}

bool CollocationStep::settle(double cubic, const AtNodes& linear, AtNodes& x) const
{
    constexpr int mostRounds = 12;
    constexpr double settled = 1e-13;
    double before = 0;
    for (int round = 0; round < mostRounds; ++round) {
        const AtNodes next = linear - positionsByNode * (cubic * x.array().cube()).matrix();
        const double change = (next - x).cwiseAbs().maxCoeff();
        x = next;
        const double enough = settled * x.cwiseAbs().maxCoeff();
        if (change <= enough || (change < 0.1 * before && change * change <= enough * before))
            return true;
        before = change;
    }
    return false;
}

/// Transposed by Gauss's elimination; no pivots, since the matrix is close to the identity where the step
/// settles.
CollocationStep::EndByNode CollocationStep::bentBack(const AtNodes& bend) const
{
    Eigen::Matrix<double, nodes, nodes + 2, Eigen::RowMajor> system;
    system.leftCols<nodes>() = bend.asDiagonal() * positionsByNode.transpose();
    system.leftCols<nodes>().diagonal().array() += 1;
    system.rightCols<2>() = bend.asDiagonal() * endByNode.transpose();
    for (int k = 0; k < nodes; ++k) {
        const double inverse = 1 / system(k, k);
        system.row(k) *= inverse;
        for (int i = k + 1; i < nodes; ++i)
            system.row(i) -= system(i, k) * system.row(k);
    }
    for (int k = nodes - 1; k > 0; --k)
        for (int i = 0; i < k; ++i)
            system.rightCols<2>().row(i) -= system(i, k) * system.rightCols<2>().row(k);
    return system.rightCols<2>().transpose();
}

} // namespace gripscope
