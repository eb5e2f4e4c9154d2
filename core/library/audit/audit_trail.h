// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/audit_filter.h"
#include "core/people/acting.h"
#include "core/people/audit_chain.h"

#include <vector>

namespace gripscope {

class Database;

/// The audit trail of a library: appended to together with what it tells of, read and verified here.
class AuditTrail {
public:
    explicit AuditTrail(Database& database) : m_database(&database) {}

    [[nodiscard]] Expected<std::vector<AuditEntry>>
    entries(const AuditFilter& filter) const; ///< newest first
    [[nodiscard]] Expected<qint64> count(const AuditFilter& filter) const;
    /// Reads all of it; see AuditVerification.
    [[nodiscard]] Expected<AuditVerification> verify() const;

    /// What is about to be changed outside the library: `details` with the old and the new. Refused as the
    /// change has to be.
    [[nodiscard]] Expected<void> record(Permission permission, const QString& action, const QString& subject,
                                        const QJsonObject& details, const QString& reason = {});

private:
    Database* m_database;
};

} // namespace gripscope
