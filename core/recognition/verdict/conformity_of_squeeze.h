// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/result/identification_result.h"
#include "core/quality/conformity/conformity.h"
#include "core/recognition/types/type_shift.h"

namespace gripscope {

/// m, b and k of the object with the combined standard uncertainty of the squeeze's own budget and its
/// effective degrees of freedom, in the channels' units times `factor`. Nothing for what the squeeze did not
/// determine, for what it gives but a bound of, and where there is no budget: a value that nobody knows the
/// uncertainty of is without one.
[[nodiscard]] MeasuredValues measuredValues(const Identification& identification, double factor = 1);

/// As the gripper that the types were enrolled on would have found them: x / exp(e) with e the transfer error
/// of each quantity, of variance c, which adds to that of the value y,
///     u^2 = (u_x y / x)^2 + c y^2,
/// with the effective degrees of freedom of the two (Welch and Satterthwaite; JCGM 100, G.4). A value whose
/// uncertainty is not known stays without; a quantity that the error says nothing of is not known there.
[[nodiscard]] MeasuredValues adjusted(const MeasuredValues& measured, const CommonShift& error);

/// The limits of a type against a squeeze of one of its parts; `toTypeUnits` takes m, b, k from the channels
/// of the recording to the units of the type, siFactor() those to SI. Nothing without limits. `transfer`: the
/// squeeze comes from another gripper than the types.
[[nodiscard]] std::optional<Conformity> conformityOf(const PartLimits& limits,
                                                     const Identification& identification, double toTypeUnits,
                                                     const std::optional<double>& siFactor,
                                                     const std::optional<CommonShift>& transfer = {});

} // namespace gripscope
