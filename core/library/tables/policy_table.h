// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/statement.h"
#include "core/people/permission.h"

namespace gripscope::policy_table {

// As the newest version says; the default while none is stored.
[[nodiscard]] Expected<ArmingPolicy> arming(Database& database);
[[nodiscard]] Expected<ApprovalPolicy> approval(Database& database);
// The next version. Inside the transaction that asked what was in force.
[[nodiscard]] Expected<void> insertArming(Database& database, ArmingPolicy policy);
[[nodiscard]] Expected<void> insertApproval(Database& database, ApprovalPolicy policy);

} // namespace gripscope::policy_table
