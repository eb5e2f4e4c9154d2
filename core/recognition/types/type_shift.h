// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/recognition/types/type_model.h"

#include <optional>
#include <vector>

namespace gripscope {

// How far squeezes of known types lie from where those types were enrolled, and whether one cause explains
// it for all types.

/// Mean of some squeezes of a type in the logarithms of models.space less the type's own.
struct TypeShift {
    QString type;
    QuantitySpace space;
    LogVector enrolledLog = Eigen::Vector3d::Zero(); ///< the type's mean
    int squeezes = 0;
    LogVector log = Eigen::Vector3d::Zero();
    LogMatrix covariance = Eigen::Matrix3d::Zero(); ///< of `log` where nothing has moved
    double degreesOfFreedom = 0;                    ///< behind it
    double tSquared = 0;                            ///< log' covariance^-1 log, Hotelling's
    /// That so far a shift comes by chance: T^2 of two samples is p v/(v-p+1) F(p, v-p+1) (Anderson, An
    /// Introduction to Multivariate Statistical Analysis, 5.3).
    double pValue = 1;
};

/// Squeezes of other types, and those that do not determine all of models.space, are left out; each counts by
/// its own covariance. Nothing without any, or while the types have no gate (v < p).
[[nodiscard]] std::optional<TypeShift> typeShift(const TypeModels& models, const TypeModel& type,
                                                 const std::vector<TypeSqueeze>& squeezes);

/// "mass +4.0 ± 1.1 %, damping -2.0 ± 1.5 %, stiffness +0.1 ± 0.4 %" of a difference of logs.
[[nodiscard]] Finding changeInWords(const LogVector& log, const LogMatrix& covariance,
                                    const QuantitySpace& space = {});

/// Factor: m, b and k (each quantity) of every type times the same numbers, as when a channel's gain has
/// changed. Addition: the same numbers on top of every type's m, b and k, as fingers that were exchanged or a
/// baseline that no longer holds.
enum class ShiftKind { Factor, Addition };

/// One cause for all types, by generalised least squares: log_i = H_i s + e_i, H_i = I (Factor) or
/// diag(c / x_i) with x_i the type's and c the geometric mean of the types (Addition, to first order).
struct CommonShift {
    LogVector value = Eigen::Vector3d::Zero();      ///< of the logarithms, or of m, b, k themselves
    LogMatrix covariance = Eigen::Matrix3d::Zero(); ///< of `value`
    double pValue = 1;                              ///< that it is nothing: T^2 as above
    double agreement = 1; ///< that the types differ from it by chance; 1 with one type
    double misfit = 0;    ///< what is left, chi-square with p (types - 1) degrees of freedom
    QuantitySpace space = {};
    double degreesOfFreedom = 0; ///< behind the covariance; 0: as good as known
};

/// Of one space all. Nothing without shifts, or where types differ so much that there is no common scale.
[[nodiscard]] std::optional<CommonShift> commonShift(const std::vector<TypeShift>& shifts, ShiftKind kind);

/// One type alone has moved: the one that leaves least to explain in the others.
struct LoneShift {
    std::size_t type = 0;             ///< its place in the shifts
    double misfit = 0, agreement = 1; ///< of the others with having stayed, as in CommonShift
};
[[nodiscard]] std::optional<LoneShift> loneShift(const std::vector<TypeShift>& shifts);

} // namespace gripscope
