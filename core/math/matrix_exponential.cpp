// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/matrix_exponential.h"

#include <unsupported/Eigen/MatrixFunctions>

namespace gripscope {

Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& matrix)
{
    return matrix.exp();
}

} // namespace gripscope
