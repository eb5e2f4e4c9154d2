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

} // namespace gripscope
