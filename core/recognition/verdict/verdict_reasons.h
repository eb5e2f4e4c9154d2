// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"

namespace gripscope {

// Why a verdict is what it is, in short sentences for a technician.

/// Another type and how far off it is, in standard deviations of the squeeze.
struct NextType {
    const TypeModel* type = nullptr;
    double deviations = 0;
};
/// `log`: the squeeze in models.space. `next`: the nearest of the other types, absent when there is none.
[[nodiscard]] Findings typeReasons(const TypeModels& models, const TypeModel& type,
                                   const std::optional<NextType>& next, const LogVector& log,
                                   const VerdictOptions& options);
/// Which quantity is off most, by how much, and how far that is; `verdict` has distance and gate.
[[nodiscard]] Findings unknownReasons(const TypeModels& models, const TypeModel& nearest,
                                      const LogVector& log, const Verdict& verdict,
                                      const VerdictOptions& options);
/// Which two types, and, where the squeeze's own covariance is known, how much longer it should be.
[[nodiscard]] Findings betweenTypesReasons(const Verdict& verdict, bool covarianceKnown);
/// Within a gate, but where strangers are as likely as the type: at its edge, or where the space says so
/// little that more than `accepted` of the strangers would be named.
[[nodiscard]] Findings strangerReasons(const QuantitySpace& space, const Verdict& verdict, double accepted);
[[nodiscard]] Findings noGateReasons(const TypeModels& models);
/// What the squeeze would have to determine to be judged in this space, and does not.
[[nodiscard]] Finding missingReason(const TypeSqueeze& squeeze, const QuantitySpace& space);
/// By which quantities it was judged, where these are not m, b, k or not all there are.
[[nodiscard]] Findings spaceReasons(const TypeModels& models);
[[nodiscard]] Findings invalidReasons(const Identification& identification);

} // namespace gripscope
