// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/approval_check.h"

#include "core/base/words.h"
#include "core/library/sql/statement.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/permission_check.h"
#include "core/library/tables/person_table.h"
#include "core/library/tables/policy_table.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As names are compared.
QString folded(const QString& name)
{
    return name.simplified().toCaseFolded();
}

/// The accepted squeezes of a type: who the operators were, and with which versions of the library they came.
struct Enrollers {
    QSet<QString> names; ///< folded
    QSet<qint64> versions;
};

Expected<Enrollers> operatorsOf(Database& database, const QString& typeId)
{
    Enrollers found;
    Statement query(database, Words::tr("read the squeezes"),
                    u"SELECT g.operator_name, g.library_version FROM grasps g "_s + grasp_table::typeJoins() +
                        u"WHERE (g.type_id = ? OR g.id IN (SELECT r.grasp_id FROM placements r WHERE "
                        "r.type_id = ?)) AND COALESCE(p.type_id, g.type_id) = ? AND "
                        "COALESCE(p.accepted, 1) = 1"_s);
    const auto done = query.bind(typeId).bind(typeId).bind(typeId).forEach([&](Statement& row) {
        found.names.insert(folded(row.takeText()));
        found.versions.insert(row.takeInteger());
    });
    if (!done)
        return tl::unexpected(done.error());
    return found;
}

/// And whom the audit trail names: an operator's name may be typed by anybody.
Expected<void> addWhoConsented(Database& database, Enrollers& enrollers)
{
    Statement query(database, Words::tr("read its audit trail"),
                    u"SELECT person, details FROM audit_entries WHERE action = 'type.squeeze'"_s);
    return query.forEach([&](Statement& row) {
        const QString person = row.takeText();
        const QJsonObject details = QJsonDocument::fromJson(row.takeText().toUtf8()).object();
        if (enrollers.versions.contains(details[u"version"_s].toInteger(-1)))
            enrollers.names.insert(folded(person));
    });
}

} // namespace

Expected<void> requireApprover(Database& database, const TypeRecord& type, Permission by)
{
    ASSIGN_OR_RETURN(const auto people, person_table::isAnybodyThere(database));
    ASSIGN_OR_RETURN(const auto policy, policy_table::approval(database));
    if (!people || policy == ApprovalPolicy::OnePerson)
        return {};
    ASSIGN_OR_RETURN(auto enrollers, operatorsOf(database, type.id));
    RETURN_IF_ERROR(addWhoConsented(database, enrollers));
    ASSIGN_OR_RETURN(const auto allowed, whoMay(database, by));
    const bool another = std::any_of(allowed.begin(), allowed.end(), [&](const Authority& authority) {
        return !enrollers.names.contains(folded(authority.name()));
    });
    if (another)
        return {};
    return failure(
        ErrorCode::Usage,
        {Words::tr("%1 was enrolled by the one who approves it, and this library asks for a second "
                   "person. Nothing was changed; ask another supervisor to approve it.")
             .arg(type.name)});
}

} // namespace gripscope
