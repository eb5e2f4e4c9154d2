// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/decompositions.h"

#include <unsupported/Eigen/MatrixFunctions>

namespace gripscope {

// Apart from the decompositions, which whoever only steps motions (tests/fuzz) need not build.
Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& matrix)
{
    return matrix.exp();
}

} // namespace gripscope
