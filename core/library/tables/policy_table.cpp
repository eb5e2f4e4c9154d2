// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/policy_table.h"

#include "core/base/words.h"

namespace gripscope::policy_table {

using namespace Qt::StringLiterals;

namespace {

const QString armingName = u"arming"_s;

} // namespace

Expected<ArmingPolicy> arming(Database& database)
{
    ArmingPolicy policy = ArmingPolicy::SignedIn;
    Statement query(database, Words::tr("read its policies"),
                    u"SELECT value FROM policies WHERE name = ? ORDER BY version DESC LIMIT 1"_s);
    const auto done = query.bind(armingName).forEach([&](Statement& row) {
        // What this edition does not know is taken for the strictest.
        policy = armingPolicyFromString(row.takeText()).value_or(ArmingPolicy::Supervisors);
    });
    if (!done)
        return tl::unexpected(done.error());
    return policy;
}

Expected<void> insertArming(Database& database, ArmingPolicy policy)
{
    const RowStamp stamp = RowStamp::now();
    Statement statement(
        database, Words::tr("store the policy"),
        u"INSERT INTO policies (id, station, created_utc, name, version, value) SELECT ?, ?, ?, ?, "
        "COALESCE(MAX(version), 0) + 1, ? FROM policies WHERE name = ?"_s);
    statement.bind(stamp.id)
        .bind(stamp.station)
        .bind(stamp.utc)
        .bind(armingName)
        .bind(toString(policy))
        .bind(armingName);
    return statement.run();
}

} // namespace gripscope::policy_table
