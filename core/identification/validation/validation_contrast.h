// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/noise/residual_tests.h"
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/decompositions.h"
#include "core/signal/preparation/preparation.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// What the parameters of a motion say of a record they were not found from: the start and the offset, which
/// belong to the record, are fitted anew by least squares, the parameters stay. Matrices have a row a
/// regressor and a column a position for which the force is known, in the scaled record's units.
struct GivenModel {
    OutputErrorProblem record;
    Eigen::MatrixXd nuisances; ///< derivatives to the start and the offset
    Eigen::MatrixXd
        parameters; ///< in their order: to the logarithms of those above zero, the others as they are
    Eigen::RowVectorXd residual;
    Nuisance nuisance;
    std::vector<double> simulated; ///< at every sample, channel units
};

/// `record` must have no lost samples. Nothing when the motion leaves all bounds or the numbers their range.
[[nodiscard]] std::optional<GivenModel> applyGivenModel(const MotionTerms& terms, const MotionValues& values,
                                                        const PreparedRecord& record, ForceHold hold);

/// The residual of a given model taken apart: what start and offset explain is gone, then come the
/// coordinates z in the directions in which the parameters move the response, and the rest, which only noise
/// is in. Rows are whitened by `noise` first. See validate() for the statistics.
class ValidationContrast {
public:
    /// `estimateCovariance`: of the parameters that the rows of model.parameters belong to.
    ValidationContrast(const GivenModel& model, const AutoregressiveNoise& noise,
                       const Eigen::MatrixXd& estimateCovariance);

    /// There are coordinates, and noise to compare them with.
    [[nodiscard]] bool usable() const;
    [[nodiscard]] Eigen::Index rank() const { return m_parameters.basis.rows(); }
    /// z'V^-1 z over the number of coordinates, corrected to be an F ratio, and its p-value.
    /// `estimateFreedom`: the degrees of freedom of the estimate's covariance.
    [[nodiscard]] ExplainedTest test(double estimateFreedom) const;
    /// The residual with the coordinates scaled to what noise alone would give them: white when all is well.
    [[nodiscard]] Eigen::RowVectorXd standardized() const;

    struct Change {
        Eigen::VectorXd step, errors;
    };
    /// The step of the parameters that explains the coordinates, and its expected standard errors; nothing
    /// when the record does not determine all of them.
    [[nodiscard]] std::optional<Change> change() const;

    [[nodiscard]] const Eigen::MatrixXd& nuisanceBasis() const { return m_nuisances.basis; }
    [[nodiscard]] const Eigen::MatrixXd& parameterBasis() const { return m_parameters.basis; }
    [[nodiscard]] const Eigen::RowVectorXd& rest() const { return m_rest; }
    /// Covariance of the coordinates from the estimate's errors, A'P A.
    [[nodiscard]] const Eigen::MatrixXd& fromEstimate() const { return m_fromEstimate; }
    [[nodiscard]] double variance() const { return m_variance; } ///< of the noise, a sample

private:
    OrthonormalRows m_nuisances, m_parameters;
    Eigen::MatrixXd m_estimateCovariance, m_fromEstimate;
    Eigen::VectorXd m_coordinates;
    Eigen::RowVectorXd m_rest;
    double m_variance = 0, m_degreesOfFreedom = 0;
    Eigen::LLT<Eigen::MatrixXd> m_root; ///< of V
};

} // namespace gripscope
