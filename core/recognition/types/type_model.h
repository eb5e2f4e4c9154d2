// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/recognition/types/own_spread.h"
#include "core/recognition/types/quantity_space.h"
#include "core/recognition/types/scatter.h"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// What a squeeze determines besides or instead of m, b and k.
struct DeterminedQuantities {
    QuantitySpace space;
    LogVector log; ///< natural logarithms, in order of the space; squeezes in the same units, tau in seconds
    std::optional<LogMatrix> covariance = {}; ///< of `log`; absent: not known
};

/// An enrolled squeeze: which type, and the m, b, k found (all squeezes in the same units).
struct TypeSqueeze {
    QString type;
    MassDampingStiffness parameters;
    /// Of (m, b, k), from the identification. Absent: not known (a table, the paper).
    std::optional<Eigen::Matrix3d> covariance = {};
    QString part = {}; ///< which part of the type it was; empty: a part that was squeezed once
    int place = -1;    ///< of its type among all that ever were, by when they came; -1: not known
    /// For spaces within its own it counts in place of m, b and k, which need then not be there.
    std::optional<DeterminedQuantities> determined = {};
};

/// One type in a space of natural logarithms (of m, b, k), where the scatter is relative and alike for all
/// types.
struct TypeModel {
    QString name;
    int squeezes = 0;
    LogVector meanLog = Eigen::Vector3d::Zero();
    LogMatrix meanCovarianceLog = Eigen::Matrix3d::Zero(); ///< how well the mean is known
    int place =
        0; ///< its squeezes' (by name where they have none): goes with it for life, as its name may not
    OwnScatter own = {}; ///< its squeezes, where the covariance shared by all types is the identity
};

/// All types with the scatter they share (see Scatter): with v = sum (n_i - 1) degrees of freedom where no
/// part was squeezed twice.
struct TypeModels {
    std::vector<TypeModel> types;                      ///< sorted by name
    LogMatrix covarianceLog = Eigen::Matrix3d::Zero(); ///< of a squeeze like those enrolled
    int degreesOfFreedom = 0;                          ///< behind it, rounded down
    double shrinkage = 0;                              ///< see estimateScatter()
    Scatter scatter = {};
    /// Degrees of freedom about the shared covariance that each type's own is a draw with; absent: no type
    /// is seen to spread otherwise than the others.
    std::optional<double> likeness = {};
    QuantitySpace space = {}; ///< what the coordinates of all of these are
    /// Whole: what all types determine. Part: of it, for a squeeze that does not determine the whole. Group:
    /// what these types determine, of more than are among them.
    enum class Reach { Whole, Part, Group };
    Reach reach = Reach::Whole;

    [[nodiscard]] const TypeModel* find(const QString& name) const;
    /// Whether a gate keeps anything out: with fewer degrees of freedom than p + 2 the F behind it
    /// (falseRejectGate()) has no mean, and the gate is tens to hundreds of standard deviations wide.
    [[nodiscard]] bool gateRefuses() const { return degreesOfFreedom >= space.dimensions() + 2; }
};

/// In coordinates of `space`. Squeezes that lack one of its quantities, or have one that is not positive and
/// finite, are left out; so is a covariance that is not one. The scatter of each quantity is taken for at
/// least 1e-4 (relative), so that copies of one squeeze do not make it zero. No types in a space of none, or
/// of more than mostDimensions.
[[nodiscard]] TypeModels fitTypeModels(const std::vector<TypeSqueeze>& squeezes,
                                       const QuantitySpace& space = {});

/// The largest space that each of the types determines (DeterminedByType); squeezes that lack it are then
/// left out of the fit. m, b, k where no squeeze has a usable quantity; empty where types have nothing in
/// common.
[[nodiscard]] QuantitySpace spaceOf(const std::vector<TypeSqueeze>& squeezes);

/// Covariance of log(m, b, k) to first order, c_ij / (p_i p_j), errors beyond exp(10) times taken for that.
/// Nothing when p is not positive and finite or the matrix is no covariance.
[[nodiscard]] std::optional<Eigen::Matrix3d> logCovariance(const MassDampingStiffness& p,
                                                           const Eigen::Matrix3d& covariance);
/// The same of logarithms already.
[[nodiscard]] std::optional<LogMatrix> usableLogCovariance(const LogMatrix& covariance);

/// Squared distance at which a new squeeze of a type with n squeezes is refused at the stated rate:
///     D^2 <= (1 + 1/n) p v/(v-p+1) F(1 - rate; p, v-p+1),   for p = 3   3 v/(v-2) F(1 - rate; 3, v-2).
/// Nothing while v < p: too few squeezes for a gate. Holds on average over enrolments, for Gaussian logs with
/// equal covariances; Hotelling's T^2 for a new observation (Anderson, Introduction to Multivariate
/// Statistical Analysis).
[[nodiscard]] std::optional<double> falseRejectGate(double squeezesOfType, double degreesOfFreedom,
                                                    double rate, int dimensions = 3);

/// Mahalanobis distance squared of a squeeze's logarithms from a type, with the shared covariance, as if the
/// squeeze were like those enrolled. Nothing while there is no covariance (v = 0), or when the squeeze does
/// not determine all of models.space.
[[nodiscard]] std::optional<double> squaredDistance(const TypeModels& models, const TypeModel& type,
                                                    const TypeSqueeze& squeeze);
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
/// covariance yet, and in spaces other than m, b, k.
[[nodiscard]] std::optional<Ellipsoid> typeEllipsoid(const TypeModels& models, const TypeModel& type,
                                                     double share);
/// The same for one estimate and its covariance.
[[nodiscard]] std::optional<Ellipsoid> estimateEllipsoid(const MassDampingStiffness& p,
                                                         const Eigen::Matrix3d& covariance, double share);

/// Where the squeezes of a type lie in one quantity.
struct TypeInterval {
    double mean = 0; ///< geometric
    double low = 0, high = 0;
};

/// exp(mean -+ z s) for each quantity of models.space (m, b, k), in the units of the models: s the standard
/// deviation of its logarithm that all types share, z the normal quantile that leaves (1 - share)/2 on either
/// side. Where nothing is known of the scatter, low and high are the mean. Share from 0.5 to 0.9999, else
/// 0.95.
[[nodiscard]] std::vector<TypeInterval> typeIntervals(const TypeModels& models, const TypeModel& type,
                                                      double share = 0.95);

} // namespace gripscope
