// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/models_by_space.h"
#include "core/recognition/verdict/verdict.h"

namespace gripscope {

/// The verdict by all that the squeeze and the types it may be determine. First by what all types determine;
/// then those that are not ruled out, with others that determine as much, by what these determine together,
/// and so on while that is more. A part is held against each space that it is judged by, so that one of the
/// right stiffness that does not yield as a foam does is none of it. Where too few squeezes are enrolled for
/// a gate that keeps anything out in the larger space, the verdict before stands.
///
/// Each look may be wrong, so they share the rates: the first of several has half of each, the next half of
/// what is left, the last all of it. Where no type determines more than all do, there is one.
[[nodiscard]] Verdict judge(const ModelsBySpace& types, const TypeSqueeze& squeeze,
                            const VerdictOptions& options = {});
/// The verdict on a measurement, as that by TypeModels.
[[nodiscard]] Verdict judge(const ModelsBySpace& types, const Identification& identification,
                            const std::optional<TypeSqueeze>& found, const VerdictOptions& options = {},
                            const std::optional<CommonShift>& transfer = {});

} // namespace gripscope
