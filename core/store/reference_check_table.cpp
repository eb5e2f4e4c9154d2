// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/reference_check_table.h"

#include "core/store/reference_table.h"
#include "core/store/rows.h"
#include "core/words.h"

#include <algorithm>

namespace gripscope::reference_check_table {

using namespace Qt::StringLiterals;

namespace {

QString reading()
{
    return Words::tr("read the checks on the reference object");
}
const auto columns = u"id, created_utc, gripper_serial, reference_id, verdict, obstacle, squeezes, m, "
                     "m_uncertainty, b, b_uncertainty, k, k_uncertainty, operator_name"_s;

Expected<ReferenceCheckRecord> take(Statement& row)
{
    ReferenceCheckRecord record;
    record.id = row.takeText();
    record.made = row.takeUtc();
    record.gripperSerial = row.takeText();
    record.referenceId = row.takeText();
    const std::optional<CheckVerdict> verdict = checkVerdictFromString(row.takeText());
    record.obstacle = row.takeText();
    record.squeezes = int(row.takeInteger());
    for (std::optional<MeasuredQuantity>& measured : record.measured) {
        const std::optional<double> value = row.takeOptionalReal();
        const std::optional<double> uncertainty = row.takeOptionalReal();
        if (value && uncertainty)
            measured = MeasuredQuantity{*value, *uncertainty};
    }
    record.operatorName = row.takeText();
    if (!verdict)
        return failure(ErrorCode::StorageCorrupt, {Words::tr("A check on the reference object"),
                                                   Words::tr("a verdict is none of the three")});
    record.verdict = *verdict;
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const ReferenceCheck& check)
{
    Statement row(database, Words::tr("store the check on the reference object"),
                  u"INSERT INTO reference_checks (station, "_s + columns +
                      u") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.station).bind(stamp.id).bind(stamp.utc);
    row.bind(check.gripperSerial).bind(check.referenceId);
    row.bind(toString(check.verdict)).bind(check.obstacle).bind(check.squeezes);
    for (const std::optional<MeasuredQuantity>& measured : check.measured)
        for (const auto member : {&MeasuredQuantity::value, &MeasuredQuantity::standardUncertainty})
            row.bind(measured ? std::optional((*measured).*member) : std::nullopt);
    row.bind(check.operatorName);
    return row.run();
}

Expected<std::vector<ReferenceCheckRecord>> read(Database& database, const QString& gripperSerial, int limit)
{
    const auto references = reference_table::read(database, gripperSerial);
    if (!references)
        return tl::unexpected<Error>(references.error());
    Statement query(database, reading(),
                    u"SELECT "_s + columns +
                        u" FROM reference_checks WHERE gripper_serial = ? "
                        "ORDER BY created_utc DESC, id DESC LIMIT ?"_s);
    query.bind(gripperSerial).bind(limit);
    Expected<std::vector<ReferenceCheckRecord>> checks = allRows(query, take);
    if (!checks)
        return checks;
    for (ReferenceCheckRecord& check : *checks) {
        const auto found =
            std::find_if(references->begin(), references->end(),
                         [&](const ReferenceObjectRecord& one) { return one.id == check.referenceId; });
        if (found == references->end())
            return failure(ErrorCode::StorageCorrupt, {Words::tr("A check on the reference object"),
                                                       Words::tr("it is on an object that is not there")});
        check.reference = *found;
    }
    return checks;
}

Expected<std::optional<ReferenceCheckRecord>> newest(Database& database,
                                                     const ReferenceObjectRecord& reference)
{
    Statement query(database, reading(),
                    u"SELECT "_s + columns +
                        u" FROM reference_checks WHERE reference_id = ? AND verdict <> 'not_valid' "
                        "ORDER BY created_utc DESC, id DESC LIMIT 1"_s);
    query.bind(reference.id);
    Expected<std::optional<ReferenceCheckRecord>> found = firstRow(query, take);
    if (found && *found)
        (*found)->reference = reference;
    return found;
}

} // namespace gripscope::reference_check_table
