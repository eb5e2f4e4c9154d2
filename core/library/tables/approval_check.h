// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/type_record.h"
#include "core/people/permission.h"

namespace gripscope {

class Database;

/// Whether the one who works through this connection may approve this type by the library's ApprovalPolicy;
/// requirePermission() has been asked. Who enrolled a squeeze is the operator it is stored with, and whoever
/// had signed in or consented when it was stored. Usage, worded, when not. Inside the transaction of the
/// approval. `by`: what the consent is to.
[[nodiscard]] Expected<void> requireApprover(Database& database, const TypeRecord& type,
                                             Permission by = Permission::ApproveTypes);

} // namespace gripscope
