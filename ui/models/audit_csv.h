// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/audit_trail.h"

#include <QByteArray>

namespace gripscope {

class Library;

/// UTF-8 with a header line, oldest first, every field as it was hashed, so that the chain can be checked
/// from the file alone.
[[nodiscard]] QByteArray toCsv(const std::vector<AuditEntry>& entries);
/// All entries, whatever is filtered on the screen: a part would be no chain.
[[nodiscard]] Expected<QByteArray> auditCsv(Library& library);

} // namespace gripscope
