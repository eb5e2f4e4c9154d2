// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// An enrolled squeeze: which type, and the m, b, k found (all squeezes in the same units).
struct TypeSqueeze {
    QString type;
    MassDampingStiffness parameters;
};

/// One type in the space of natural logarithms of m, b, k, where the scatter is relative and alike for all
/// types.
struct TypeModel {
    QString name;
    int squeezes = 0;
    Eigen::Vector3d meanLog = Eigen::Vector3d::Zero();
};

/// All types with the covariance they share: pooled over types with v = sum (n_i - 1) degrees of freedom,
/// then shrunk towards its own diagonal, S = (1 - w) S_pooled + w diag(S_pooled), so that few squeezes do not
/// make it flat (with v < 3 it would be singular).
///     w = `shrinkage` = 1 / (1 + v^2):   0.5 at v = 1, 0.1 at 3, 0.015 at 8, 0.0008 at 36.
/// It falls faster than the sampling error of S (about sqrt(2/v)), so that from v of about 8 the gate below
/// keeps its stated rate, also when m, b and k go strongly together.
struct TypeModels {
    std::vector<TypeModel> types; ///< sorted by name
    Eigen::Matrix3d covarianceLog = Eigen::Matrix3d::Zero();
    int degreesOfFreedom = 0;
    double shrinkage = 0;

    [[nodiscard]] const TypeModel* find(const QString& name) const;
};

/// Squeezes whose parameters are not all positive and finite are left out. The scatter of each parameter is
/// taken for at least 1e-4 (relative), so that copies of one squeeze do not make it zero.
[[nodiscard]] TypeModels fitTypeModels(const std::vector<TypeSqueeze>& squeezes);

/// Squared distance at which a new squeeze of a type with n squeezes is refused at the stated rate:
///     D^2 <= (1 + 1/n) 3 v/(v-2) F(1 - rate; 3, v-2).
/// Nothing while v < 3: too few squeezes for a gate. Holds on average over enrolments, for Gaussian logs with
/// equal covariances; Hotelling's T^2 for a new observation (Anderson, Introduction to Multivariate
/// Statistical Analysis).
[[nodiscard]] std::optional<double> falseRejectGate(int squeezesOfType, int degreesOfFreedom, double rate);

/// Mahalanobis distance squared of log(m, b, k) from a type, with the shared covariance. Nothing while there
/// is no covariance (v = 0), or when m, b, k are not all positive and finite.
[[nodiscard]] std::optional<double> squaredDistance(const TypeModels& models, const TypeModel& type,
                                                    const MassDampingStiffness& p);

/// An ellipsoid x = centre + axes * diag(radii) * (unit vector), axes orthonormal columns, in log(m, b, k)
/// or, to first order, in m, b, k themselves (centre then the geometric mean).
struct Ellipsoid {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d radii = Eigen::Vector3d::Zero();
};

/// Where a share (0.95) of the type's squeezes lies, chi-square with 3 degrees of freedom, in m, b, k
/// themselves: the log ellipsoid taken through the derivative at the centre. Empty when there is no
/// covariance yet.
[[nodiscard]] std::optional<Ellipsoid> typeEllipsoid(const TypeModels& models, const TypeModel& type,
                                                     double share);
/// The same for one estimate and its covariance.
[[nodiscard]] std::optional<Ellipsoid> estimateEllipsoid(const MassDampingStiffness& p,
                                                         const Eigen::Matrix3d& covariance, double share);

} // namespace gripscope
