// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_value.h"

#include <Eigen/Core>

namespace gripscope {

/// An array a row; what is not finite is null.
template <typename Derived>
[[nodiscard]] QJsonArray matrixJson(const Eigen::MatrixBase<Derived>& matrix)
{
    QJsonArray rows;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        QJsonArray row;
        for (Eigen::Index j = 0; j < matrix.cols(); ++j)
            row.append(jsonNumber(matrix(i, j)));
        rows.append(row);
    }
    return rows;
}

} // namespace gripscope
