// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

/// The answers of m x'' + b x' + k x = F over a step, as products: to its start, to a force F(0) + F' t and
/// to a force that is a polynomial through the nodes of Gauss's quadrature,
///     x_i = P_i (x(0), v(0), F(0), F') + sum_j K_ij g_j,   K_ij = integral_0^ti h(ti - t) l_j(t) dt,
/// h the answer to an impulse, l_j Lagrange's polynomial of node j (the variation of constants, collocated:
/// Hochbruck and Ostermann 2010, 2.4). Exact to rounding but for the polynomial.
struct CollocationStep {
    static constexpr int nodes = 6;
    using AtNodes = Eigen::Matrix<double, nodes, 1>;
    /// Of x(0), v(0), F(0) and F'.
    using Given = Eigen::Matrix<double, 4, 1>;

    double duration = 0;
    Eigen::Matrix<double, nodes, 4> positions, speeds;                 ///< at the nodes, from what is given
    Eigen::Matrix<double, nodes, nodes> positionsByNode, speedsByNode; ///< from the force at each
    Eigen::Matrix<double, 2, 4> end;                                   ///< position and speed after the step
    Eigen::Matrix<double, 2, nodes> endByNode;
    AtNodes times; ///< of the nodes
    AtNodes
        lastDegree; ///< of the values at the nodes: Legendre's coefficient of the polynomial's last degree
};

/// The duration: at most about the shortest of the part's own times, 1 / (b/m + sqrt(k/m)).
[[nodiscard]] CollocationStep collocationStep(double mass, double damping, double stiffness, double duration);

} // namespace gripscope
