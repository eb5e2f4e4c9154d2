// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/audit_filter.h"
#include "core/library/records/clock_step.h"
#include "core/library/sql/statement.h"
#include "core/people/acting.h"
#include "core/people/audit_chain.h"

#include <functional>

namespace gripscope {

/// What is to be told; number, time, station, person and role come from the connection.
struct NewAuditEntry {
    QString action, subject, reason;
    QJsonObject details = {};
    QString operatorName = {};                  ///< as given, where nobody has signed in
    std::optional<Authority> by = std::nullopt; ///< instead of the one who acts
};

namespace audit_table {

/// Continues the chain. Inside the write transaction of what it tells.
[[nodiscard]] Expected<void> append(Database& database, const NewAuditEntry& entry);
/// Tells of the station's clock where it was set back since its last entry or inspection; append() does so
/// too.
[[nodiscard]] Expected<void> noteClock(Database& database);
/// All that were told, the first first.
[[nodiscard]] Expected<std::vector<ClockStep>> clockSteps(Database& database);
/// Newest first.
[[nodiscard]] Expected<std::vector<AuditEntry>> page(Database& database, const AuditFilter& filter);
[[nodiscard]] Expected<qint64> count(Database& database, const AuditFilter& filter);
/// All, from the first.
[[nodiscard]] Expected<void> forEach(Database& database, const std::function<void(const AuditEntry&)>& take);
/// As stored; empty when there is no such entry.
[[nodiscard]] Expected<QString> hashOf(Database& database, qint64 number);

} // namespace audit_table
} // namespace gripscope
