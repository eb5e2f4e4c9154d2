// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/policy_table.h"

#include "core/base/words.h"

namespace gripscope::policy_table {

using namespace Qt::StringLiterals;

namespace {

const QString armingName = u"arming"_s;
const QString approvalName = u"approval"_s;

/// As it is stored; nothing while it is not.
Expected<std::optional<QString>> newestPolicy(Database& database, const QString& name)
{
    std::optional<QString> value;
    Statement query(database, Words::tr("read its policies"),
                    u"SELECT value FROM policies WHERE name = ? ORDER BY version DESC LIMIT 1"_s);
    const auto done = query.bind(name).forEach([&](Statement& row) { value = row.takeText(); });
    if (!done)
        return tl::unexpected(done.error());
    return value;
}

Expected<void> insertPolicy(Database& database, const QString& name, const QString& value)
{
    const RowStamp stamp = RowStamp::now();
    Statement statement(
        database, Words::tr("store the policy"),
        u"INSERT INTO policies (id, station, created_utc, name, version, value) SELECT ?, ?, ?, ?, "
        "COALESCE(MAX(version), 0) + 1, ? FROM policies WHERE name = ?"_s);
    statement.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(name).bind(value).bind(name);
    return statement.run();
}

} // namespace

// What this edition does not know is taken for the strictest.
Expected<ArmingPolicy> arming(Database& database)
{
    ASSIGN_OR_RETURN(const auto stored, newestPolicy(database, armingName));
    return stored ? armingPolicyFromString(*stored).value_or(ArmingPolicy::Supervisors)
                  : ArmingPolicy::SignedIn;
}

Expected<ApprovalPolicy> approval(Database& database)
{
    ASSIGN_OR_RETURN(const auto stored, newestPolicy(database, approvalName));
    return stored ? approvalPolicyFromString(*stored).value_or(ApprovalPolicy::SecondPerson)
                  : ApprovalPolicy::OnePerson;
}

Expected<void> insertArming(Database& database, ArmingPolicy policy)
{
    return insertPolicy(database, armingName, toString(policy));
}

Expected<void> insertApproval(Database& database, ApprovalPolicy policy)
{
    return insertPolicy(database, approvalName, toString(policy));
}

} // namespace gripscope::policy_table
