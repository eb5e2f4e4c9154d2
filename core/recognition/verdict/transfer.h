// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_shift.h"

#include <optional>
#include <vector>

namespace gripscope {

/// How well types enrolled on one gripper serve on another, judged by squeezes of the same types there, each
/// held against models it had no part in.
struct TransferTrial {
    int squeezes = 0;
    int namedBefore = 0, namedAfter = 0; ///< called their own type, as measured and adjusted
    /// Gain in log predictive density by the adjustment, all squeezes together.
    double logDensityGain = 0;
};

struct TransferReport {
    std::vector<TypeShift> types;     ///< the other gripper's squeezes less the enrolment, by type
    std::optional<CommonShift> error; ///< of the logarithms, common to all types: the transfer error
    TransferTrial trial;              ///< each squeeze left out of the adjustment it is judged with
    /// Each type left out as a whole, which is how types that were not squeezed here will fare; with two
    /// types or more.
    std::optional<TransferTrial> unseenTypes;
    /// The adjustment is worth making: it gains more than e^2 in likelihood, for types left out where there
    /// are some.
    bool adjust = false;
    Findings words; ///< sentences a technician understands
};

/// `squeezes`: from the other gripper, of types that `models` knows. The transfer error is the mean shift of
/// all types in the logarithms, by generalised least squares; a squeeze there is adjusted by dividing its
/// quantities by exp(error). The error's own uncertainty counts where an adjusted squeeze is judged. Reports
/// without `error`: no squeeze of a known type, or types without a gate (v < p).
[[nodiscard]] TransferReport measureTransfer(const TypeModels& models,
                                             const std::vector<TypeSqueeze>& squeezes);

/// The squeeze as the first gripper would have found it, with the uncertainty of the adjustment in its
/// covariance (where it has one). Unchanged where it does not determine all of the error's space.
[[nodiscard]] TypeSqueeze adjusted(const TypeSqueeze& squeeze, const CommonShift& error);

// Whether one adjustment explains what all common types show, and how well it is known.

/// A type against the adjustment that the other types give: what that leaves of its own shift.
struct TransferResidual {
    QString type;
    LogVector log = Eigen::Vector3d::Zero();        ///< its shift less the others' common one
    LogMatrix covariance = Eigen::Matrix3d::Zero(); ///< of that, both uncertain
    double pValue = 1;                              ///< that so much is left by chance, T^2 as in typeShift()
    bool fits = true;                               ///< at a chance of 1 % for all types together
};

/// One a type, in the order of report.types; none with fewer than two types. Of two types both are said not
/// to fit, or neither: which of them is the odd one, a third tells.
[[nodiscard]] std::vector<TransferResidual> transferResiduals(const TransferReport& report);

/// How well the error has to be known: a third of what squeezes of one type scatter, in each quantity. It
/// then widens the interval of an adjusted squeeze by a twentieth.
[[nodiscard]] LogVector wantedUncertainty(const TypeModels& models);

/// Standard uncertainties of the error's logarithms, were `more` further squeezes made of each of its types:
/// what is due to the squeezes shrinks with their number, what is due to the enrolment stays. Nothing without
/// an error.
[[nodiscard]] std::optional<LogVector> uncertaintyWith(const TypeModels& models, const TransferReport& report,
                                                       int more);

/// The fewest further squeezes of each type after which the error is known as well as that; nothing where
/// mostFurther are not enough, since the enrolment itself is not known better.
inline constexpr int mostFurther = 30;
[[nodiscard]] std::optional<int> squeezesNeeded(const TypeModels& models, const TransferReport& report,
                                                const LogVector& wanted);

/// The verdict on a squeeze of a stated type, adjusted by what the others give: another type, or none, is a
/// part that was mistaken for one of its type. Nothing while the others give no adjustment.
[[nodiscard]] std::optional<Finding> transferDoubt(const TypeModels& models, const TypeSqueeze& squeeze,
                                                   const std::vector<TypeSqueeze>& others);

} // namespace gripscope
