// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/scaled_record.h"
#include "core/signal/preparation.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// What m, b, k (and k3) say of a record they were not found from: x0, v0 and the offset, which belong to the
/// record, are fitted anew by least squares, the parameters stay. Matrices have a row a regressor and a
/// column a position for which the force is known, in the scaled record's units.
struct GivenModel {
    ScaledRecord record;
    Eigen::MatrixXd nuisances;  ///< derivatives to x0, v0 and the offset
    Eigen::MatrixXd parameters; ///< to ln m, ln b, ln k, and to k3 in channel units where there is one
    Eigen::RowVectorXd residual;
    Nuisance nuisance;
    std::vector<double> simulated; ///< at every sample, channel units
};

/// `record` must have no lost samples. Nothing when the motion leaves all bounds or the numbers their range.
[[nodiscard]] std::optional<GivenModel> applyGivenModel(const MassDampingStiffness& parameters, double k3,
                                                        const PreparedRecord& record, ForceHold hold);

} // namespace gripscope
