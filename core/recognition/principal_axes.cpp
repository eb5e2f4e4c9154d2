// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace gripscope {

PrincipalAxes principalAxes(const Eigen::MatrixXd& items)
{
    PrincipalAxes axes;
    axes.mean = items.colwise().mean();
    const Eigen::MatrixXd away = items.rowwise() - axes.mean;
    const Eigen::MatrixXd covariance = away.transpose() * away / double(items.rows());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    axes.directions = solver.eigenvectors().rowwise().reverse();
    axes.deviations = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    for (Eigen::Index j = 0; j < axes.directions.cols(); ++j) {
        Eigen::Index largest = 0;
        axes.directions.col(j).cwiseAbs().maxCoeff(&largest);
        if (axes.directions(largest, j) < 0)
            axes.directions.col(j) *= -1;
    }
    return axes;
}

} // namespace gripscope
