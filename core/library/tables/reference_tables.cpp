// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/calibration_tables.h"
#include "core/library/tables/serial.h"

#include <algorithm>

namespace gripscope::reference_table {

using namespace Qt::StringLiterals;

namespace {

const auto referenceColumns =
    u"id, created_utc, gripper_serial, name, certificate, m, m_uncertainty, m_tolerance, b, "
    "b_uncertainty, b_tolerance, k, k_uncertainty, k_tolerance, bias_n, peak_n, squeezes, "
    "interval_hours, operator_name"_s;

Expected<ReferenceObjectRecord> takeReference(Statement& row)
{
    ReferenceObjectRecord record;
    record.id = row.takeText();
    record.created = row.takeUtc();
    record.gripperSerial = row.takeText();
    record.name = row.takeText();
    record.certificate = row.takeText();
    for (std::optional<ReferenceQuantity>& stated : record.stated) {
        const std::optional<double> value = row.takeOptionalReal();
        const std::optional<double> uncertainty = row.takeOptionalReal();
        const std::optional<double> tolerance = row.takeOptionalReal();
        if (value && uncertainty && tolerance)
            stated = ReferenceQuantity{*value, *uncertainty, *tolerance};
    }
    record.bias_N = row.takeReal();
    record.peak_N = row.takeReal();
    record.squeezes = int(row.takeInteger());
    record.intervalHours = int(row.takeInteger());
    record.operatorName = row.takeText();
    return record;
}

QString selecting(const QString& rows)
{
    return u"SELECT "_s + referenceColumns + u" FROM reference_objects WHERE "_s + rows;
}

QString readingReferences()
{
    return Words::tr("read the reference objects");
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const ReferenceObject& reference)
{
    Statement row(database, Words::tr("store the reference object"),
                  u"INSERT INTO reference_objects (station, "_s + referenceColumns +
                      u", serial) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"reference_objects"_s) + u')');
    row.bind(stamp.station).bind(stamp.id).bind(stamp.utc);
    row.bind(reference.gripperSerial).bind(reference.name).bind(reference.certificate);
    for (const std::optional<ReferenceQuantity>& stated : reference.stated)
        for (const auto member : {&ReferenceQuantity::value, &ReferenceQuantity::standardUncertainty,
                                  &ReferenceQuantity::tolerance})
            row.bind(stated ? std::optional((*stated).*member) : std::nullopt);
    row.bind(reference.bias_N).bind(reference.peak_N);
    row.bind(reference.squeezes).bind(reference.intervalHours).bind(reference.operatorName);
    return row.run();
}

Expected<std::optional<ReferenceObjectRecord>> newest(Database& database, const QString& gripperSerial)
{
    Statement query(database, readingReferences(),
                    selecting(u"gripper_serial = ? ORDER BY "_s + newestFirst + u" LIMIT 1"_s));
    query.bind(gripperSerial);
    return firstRow(query, takeReference);
}

Expected<std::optional<ReferenceObjectRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingReferences(), selecting(u"id = ?"_s));
    query.bind(id);
    return firstRow(query, takeReference);
}

Expected<std::vector<ReferenceObjectRecord>> read(Database& database, const QString& gripperSerial)
{
    Statement query(database, readingReferences(), selecting(u"gripper_serial = ?"_s));
    query.bind(gripperSerial);
    return allRows(query, takeReference);
}

} // namespace gripscope::reference_table

namespace gripscope::reference_check_table {

using namespace Qt::StringLiterals;

namespace {

QString readingChecks()
{
    return Words::tr("read the checks on the reference object");
}
const auto checkColumns = u"id, created_utc, gripper_serial, reference_id, verdict, obstacle, squeezes, m, "
                          "m_uncertainty, b, b_uncertainty, k, k_uncertainty, operator_name"_s;

Expected<ReferenceCheckRecord> takeCheck(Statement& row)
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
                  u"INSERT INTO reference_checks (station, "_s + checkColumns +
                      u", serial) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"reference_checks"_s) + u')');
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
    ASSIGN_OR_RETURN(const auto references, reference_table::read(database, gripperSerial));
    Statement query(database, readingChecks(),
                    u"SELECT "_s + checkColumns +
                        u" FROM reference_checks WHERE gripper_serial = ? "
                        "ORDER BY "_s +
                        newestFirst + u" LIMIT ?"_s);
    query.bind(gripperSerial).bind(limit);
    Expected<std::vector<ReferenceCheckRecord>> checks = allRows(query, takeCheck);
    if (!checks)
        return checks;
    for (ReferenceCheckRecord& check : *checks) {
        const auto found =
            std::find_if(references.begin(), references.end(),
                         [&](const ReferenceObjectRecord& one) { return one.id == check.referenceId; });
        if (found == references.end())
            return failure(ErrorCode::StorageCorrupt, {Words::tr("A check on the reference object"),
                                                       Words::tr("it is on an object that is not there")});
        check.reference = *found;
    }
    return checks;
}

Expected<std::optional<ReferenceCheckRecord>> newest(Database& database,
                                                     const ReferenceObjectRecord& reference)
{
    Statement query(database, readingChecks(),
                    u"SELECT "_s + checkColumns +
                        u" FROM reference_checks WHERE reference_id = ? AND verdict <> 'not_valid' "
                        "ORDER BY "_s +
                        newestFirst + u" LIMIT 1"_s);
    query.bind(reference.id);
    Expected<std::optional<ReferenceCheckRecord>> found = firstRow(query, takeCheck);
    if (found && *found)
        (*found)->reference = reference;
    return found;
}

} // namespace gripscope::reference_check_table
