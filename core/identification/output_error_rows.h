// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/output_error_model.h"

#include <Eigen/Core>

namespace gripscope {

/// M, B, K of theta.
[[nodiscard]] MassDampingStiffness scaledParameters(const Eigen::Vector3d& theta);

/// The linearised problem for the tests of its residuals: regressors as rows, a column a measured sample.
/// Where samples were lost their forces are taken out (withoutLostForces), which leaves white noise when that
/// of the position is.
class OutputErrorRows {
public:
    OutputErrorRows(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                    const ScaledNuisance& nuisance);

    /// x0, v0 and offset (those that are free), then ln M, ln B, ln K.
    [[nodiscard]] const Eigen::MatrixXd& sensitivities() const { return m_sensitivities; }
    [[nodiscard]] const Eigen::RowVectorXd& residual() const { return m_residual; }
    /// The model's position at every sample from firstRow() to endRow(), measured or not.
    [[nodiscard]] const Eigen::RowVectorXd& modelled() const { return m_modelled; }
    /// Other regressors, given at every sample from firstRow() to endRow(), as they stand beside these.
    [[nodiscard]] Eigen::MatrixXd rowsOf(Eigen::MatrixXd series) const;
    /// The residuals are below 1e-9 of the position's size, or nothing is finite.
    [[nodiscard]] bool isRounding() const;

private:
    void takeOutLost(const ScaledNuisance& nuisance);

    const OutputErrorProblem& m_problem;
    Eigen::Vector3d m_theta;
    Eigen::MatrixXd m_sensitivities;
    Eigen::RowVectorXd m_residual, m_modelled;
    double m_size = 0;
};

} // namespace gripscope
