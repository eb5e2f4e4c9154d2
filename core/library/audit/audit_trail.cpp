// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/permission_check.h"
#include "core/library/tables/write_transaction.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<std::vector<AuditEntry>> AuditTrail::entries(const AuditFilter& filter) const
{
    return audit_table::page(*m_database, filter);
}

Expected<qint64> AuditTrail::count(const AuditFilter& filter) const
{
    return audit_table::count(*m_database, filter);
}

Expected<AuditVerification> AuditTrail::verify() const
{
    // Before the trail: what another process adds in between is only more.
    LibraryWitness witness = readWitness(m_database->file());
    settleRestore(witness, ledger_table::hashesOf(*m_database));
    AuditChainCheck check(std::move(witness.audit));
    const auto done = audit_table::forEach(*m_database, [&](const AuditEntry& entry) { check.take(entry); });
    if (!done)
        return tl::unexpected(done.error());
    AuditVerification found = check.finish();
    found.witness = witnessFile(m_database->file());
    return found;
}

Expected<void> AuditTrail::record(Permission permission, const QString& action, const QString& subject,
                                  const QJsonObject& details, const QString& reason)
{
    return writeTo<void>(*m_database, Words::tr("continue the audit trail"), [&]() -> Expected<void> {
        RETURN_IF_ERROR(requirePermission(*m_database, permission));
        return audit_table::append(*m_database, {action, subject, reason, details});
    });
}

} // namespace gripscope
