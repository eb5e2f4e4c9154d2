// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/audit_csv.h"

#include "core/store/library.h"
#include "ui/models/csv_cell.h"

#include <QStringList>

#include <algorithm>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

QByteArray toCsv(const std::vector<AuditEntry>& entries)
{
    QString text =
        u"number,time_utc,station,person,role,action,subject,reason,details,previous_hash,hash\n"_s;
    for (const AuditEntry& entry : entries) {
        QStringList line;
        for (const QString& cell :
             {QString::number(entry.number), entry.utc, entry.station, entry.person, entry.role, entry.action,
              entry.subject, entry.reason, entry.details, entry.previousHash, entry.hash})
            line << csvCell(cell);
        text += line.join(u',') + u'\n';
    }
    return text.toUtf8();
}

Expected<QByteArray> auditCsv(Library& library)
{
    auto entries = library.auditTrail().entries({{}, {}, std::numeric_limits<int>::max(), 0});
    if (!entries)
        return tl::unexpected<Error>(entries.error());
    std::reverse(entries->begin(), entries->end());
    return toCsv(*entries);
}

} // namespace gripscope
