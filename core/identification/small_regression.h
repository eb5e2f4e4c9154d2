// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/effect_regression.h"

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// Regressions on chosen columns of an EffectTriangle, all from its few rows: the nuisances and the
/// sensitivities to ln m, ln b, ln k always, the last `known` effects always, the others as asked for.
class SmallRegression {
public:
    SmallRegression(const EffectTriangle& data, Eigen::Index nuisances, Eigen::Index known);

    struct Answer {
        double rest = 0; ///< residual sum of squares
        double degreesOfFreedom = 0;
        double rank = 0;
        Eigen::VectorXd solution; ///< of nuisances, ln m, ln b, ln k, extra, known
    };
    /// With the effects `extra`, counted from the first one.
    [[nodiscard]] Answer with(const std::vector<Eigen::Index>& extra) const;
    /// What leaving out one unit of an effect does to (ln m, ln b, ln k) of the model alone.
    [[nodiscard]] Eigen::Vector3d shiftBy(Eigen::Index effect) const;
    /// (S'S)^-1 with the nuisances projected out.
    [[nodiscard]] Eigen::Matrix3d unitCovariance() const;

private:
    [[nodiscard]] Eigen::Matrix3d own() const;
    const Eigen::MatrixXd& m_triangle;
    double m_rows;
    Eigen::Index m_nuisances, m_known;
    std::vector<double> m_norms;
};

/// The F test of two nested regressions.
struct FTest {
    double ratio = 0;   ///< F
    double p = 1;       ///< that the further columns explain nothing
    double columns = 0; ///< how many more, as far as they are independent
};
[[nodiscard]] FTest fTest(const SmallRegression::Answer& without, const SmallRegression::Answer& with);

} // namespace gripscope
