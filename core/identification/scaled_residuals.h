// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_record.h"

namespace gripscope {

/// Fills in residuals, fits and the tests of the residuals from `estimate.simulated` (channel units, as long
/// as `position`). `columns` are the derivatives of the positions in the record's units, nuisances first, a
/// row from firstRow() to endRow(); `residuals` belong to them. Fitted parameters are accounted for by the
/// columns (score test).
void describeResiduals(const ScaledRecord& record, const std::vector<double>& position,
                       const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                       Estimate& estimate);

} // namespace gripscope
