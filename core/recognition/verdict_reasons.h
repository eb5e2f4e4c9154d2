// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/type_model.h"
#include "core/recognition/verdict.h"

#include <QStringList>

namespace gripscope {

// Why a verdict is what it is, in short sentences for a technician.

/// `next`: the nearest of the other types, null when there is none.
[[nodiscard]] QStringList typeReasons(const TypeModels& models, const TypeModel& type, const TypeModel* next,
                                      const MassDampingStiffness& parameters, const VerdictOptions& options);
/// Which of m, b, k is off most, by how much, and how far that is.
[[nodiscard]] QStringList unknownReasons(const TypeModels& models, const TypeModel& nearest,
                                         const MassDampingStiffness& parameters,
                                         const VerdictOptions& options);
[[nodiscard]] QStringList betweenTypesReasons(const Verdict& verdict);
[[nodiscard]] QStringList noGateReasons(const TypeModels& models);
[[nodiscard]] QStringList invalidReasons(const Identification& identification);

} // namespace gripscope
