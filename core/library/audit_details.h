// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "core/library/records/measuring_chain_record.h"

#include <QJsonObject>

#include <optional>

namespace gripscope {

// For the audit trail: what is different now, each with "from" and "to". What was not known before differs
// from nothing and from zero.

/// And how it was measured.
[[nodiscard]] QJsonObject auditDetails(const std::optional<MeasuringChainRecord>& before,
                                       const NewMeasuringChain& now);
/// And the object's name.
[[nodiscard]] QJsonObject auditDetails(const std::optional<ReferenceObjectRecord>& before,
                                       const ReferenceObject& now);

} // namespace gripscope
