// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_record.h"

namespace gripscope {

/// The auxiliary model theta = (ln M, ln B, ln K) with the x0, v0 and offset that fit it best.
struct AuxiliaryModel {
    bool finite = false;
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();
    double x0 = 0, v0 = 0, offset = 0;
    int nuisanceRank = 0;
    double cost = 0; ///< sum of squared residuals of its simulation
    /// The factor on the forced response (the compliance) that would fit best.
    double gain = 1;
    /// The share of the forced response that x0, v0 and offset cannot imitate.
    double ownShare = 0;
};
[[nodiscard]] AuxiliaryModel auxiliaryModel(const ScaledRecord& record, const Eigen::Vector3d& theta);

/// The instrumental-variable equations at an auxiliary model, in coordinates that leave out what x0, v0 and
/// offset explain. Columns belong to ln M, ln B, ln K: M f(x''), B f(x'), K f(x) of the model, and of the
/// measurement.
struct InstrumentalEquations {
    bool finite = false;
    Eigen::MatrixXd instruments; ///< 3 columns
    Eigen::MatrixXd regressors;  ///< 3 columns
    Eigen::VectorXd residual;    ///< of the model's simulation
};
[[nodiscard]] InstrumentalEquations instrumentalEquations(const ScaledRecord& record,
                                                          const AuxiliaryModel& model);

/// All rows: free nuisance columns, then the instruments; and the residuals.
struct InstrumentRows {
    Eigen::MatrixXd columns;
    std::vector<double> residuals;
};
[[nodiscard]] InstrumentRows instrumentRows(const ScaledRecord& record, const AuxiliaryModel& model);

} // namespace gripscope
