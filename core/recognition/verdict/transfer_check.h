// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/transfer.h"

#include <optional>
#include <vector>

namespace gripscope {

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
