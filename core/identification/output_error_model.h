// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lost_force_columns.h"
#include "core/identification/output_error_problem.h"
#include "core/identification/tall_qr.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace gripscope {

/// The best x0, v0, offset and lost forces for given m, b, k: they enter linearly, so that they are one
/// linear least-squares solution away (variable projection, Golub and Pereyra 1973). Here the forces of lost
/// samples are those of the problem, and the lost rows do not count.
struct ResponseFit {
    bool finite = false;
    /// The factor on the forced response (the compliance) that would fit best, and the sum of squared
    /// residuals with it.
    double gain = 1, costWithGain = 0;
    /// The share of the forced response that x0, v0 and offset cannot imitate: at rounding level for a
    /// constant force.
    double ownShare = 0;
};
[[nodiscard]] ResponseFit fitResponse(const OutputErrorProblem& problem, const Eigen::Vector3d& theta);

/// The problem linearised at theta in everything that is unknown, with all that enters linearly (x0, v0,
/// offset, lost forces) solved for.
struct Linearization {
    bool finite = false;
    double cost = 0;         ///< sum of squared residuals with the best linear unknowns
    ScaledNuisance nuisance; ///< those
    int nuisanceRank = 0;    ///< how many of them the data determines
    Eigen::Matrix3d triangle =
        Eigen::Matrix3d::Zero();                     ///< R of d x / d theta, the linear unknowns' share out
    Eigen::Vector3d right = Eigen::Vector3d::Zero(); ///< min |triangle d theta - right| is the step to go
    /// The share of the response that the linear unknowns cannot imitate: at rounding level for a constant
    /// force.
    double ownShare = 0;
    /// The sensitivities are those at the linear unknowns that were assumed: how much the best ones differ in
    /// what they add to the response, as a share of the sensitivities.
    double stale = 0;
    /// d (x0, v0, offset, lost forces) / d theta.
    Eigen::MatrixX3d nuisanceSlope;

    /// The linear unknowns to be expected after a step in theta.
    [[nodiscard]] ScaledNuisance nuisanceAfter(const Eigen::Vector3d& step) const;
};

/// One pass over the record for each theta gives cost and sensitivities together; the memory for it is kept
/// between the passes.
class ResponseLinearizer {
public:
    explicit ResponseLinearizer(const OutputErrorProblem& problem);

    /// At theta, with sensitivities for the linear unknowns `assumed`.
    [[nodiscard]] Linearization at(const Eigen::Vector3d& theta, const ScaledNuisance& assumed);

private:
    [[nodiscard]] Linearization withoutLosses(const CascadeDynamics& dynamics, const ScaledNuisance& assumed);
    [[nodiscard]] Linearization withLosses(const CascadeDynamics& dynamics, const ScaledNuisance& assumed);
    void finish(double explained, double raw, Linearization& out) const;

    const OutputErrorProblem& m_problem;
    TallQr m_qr;
    LostForceColumns m_lost;
    std::vector<double> m_force;
};

/// What to assume of the linear unknowns where nothing is known: rest, no offset, the problem's own forces.
[[nodiscard]] ScaledNuisance unknownNuisance(const OutputErrorProblem& problem);

/// Calls `use(row, columns)` for every row of the linearised problem, columns being x0, v0, offset (those
/// that are free), ln M, ln B, ln K and the residual. Lost rows do not appear, and lost forces are no
/// columns: response_sensitivities.h takes their share out.
void forEachLinearizedRow(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                          const ScaledNuisance& nuisance,
                          const std::function<void(std::ptrdiff_t, const Eigen::RowVectorXd&)>& use);

} // namespace gripscope
