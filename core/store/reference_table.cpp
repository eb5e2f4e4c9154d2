// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/reference_table.h"

#include "core/store/rows.h"
#include "core/words.h"

namespace gripscope::reference_table {

using namespace Qt::StringLiterals;

namespace {

const auto columns = u"id, created_utc, gripper_serial, name, certificate, m, m_uncertainty, m_tolerance, b, "
                     "b_uncertainty, b_tolerance, k, k_uncertainty, k_tolerance, bias_n, peak_n, squeezes, "
                     "interval_hours, operator_name"_s;

Expected<ReferenceObjectRecord> take(Statement& row)
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
    return u"SELECT "_s + columns + u" FROM reference_objects WHERE "_s + rows;
}

QString reading()
{
    return Words::tr("read the reference objects");
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const ReferenceObject& reference)
{
    Statement row(database, Words::tr("store the reference object"),
                  u"INSERT INTO reference_objects (station, "_s + columns +
                      u") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
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
    Statement query(database, reading(),
                    selecting(u"gripper_serial = ? ORDER BY created_utc DESC, id DESC LIMIT 1"_s));
    query.bind(gripperSerial);
    return firstRow(query, take);
}

Expected<std::optional<ReferenceObjectRecord>> find(Database& database, const QString& id)
{
    Statement query(database, reading(), selecting(u"id = ?"_s));
    query.bind(id);
    return firstRow(query, take);
}

Expected<std::vector<ReferenceObjectRecord>> read(Database& database, const QString& gripperSerial)
{
    Statement query(database, reading(), selecting(u"gripper_serial = ?"_s));
    query.bind(gripperSerial);
    return allRows(query, take);
}

} // namespace gripscope::reference_table
