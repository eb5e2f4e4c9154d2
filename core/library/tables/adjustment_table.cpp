// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/adjustment_table.h"

#include "core/base/words.h"
#include "core/library/records/determined_text.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/serial.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace gripscope::adjustment_table {

using namespace Qt::StringLiterals;

namespace {

QString readingAdjustments()
{
    return Words::tr("read the adjustments of grippers");
}

/// That no later one of the same gripper is there, and no end.
const auto isInForce =
    u"(x.id IS NULL AND NOT EXISTS (SELECT 1 FROM gripper_adjustments n WHERE "
    "n.gripper_serial = a.gripper_serial AND (n.serial > a.serial OR (n.serial = a.serial AND "
    "n.id > a.id))))"_s;

QString selectAdjustments()
{
    return u"SELECT a.id, a.created_utc, a.station, a.gripper_serial, a.gripper_name, a.enrolled_on, "
           u"a.types, "
           "a.squeezes, a.quantities, a.logarithms, a.covariance, a.degrees_of_freedom, a.p_value, "
           "a.agreement, "
           "a.misfit, COALESCE(a.study_id, ''), a.library_version, a.program, a.operator_name, a.reason, "_s +
           isInForce +
           u", COALESCE(x.created_utc, ''), COALESCE(x.operator_name, ''), COALESCE(x.reason, '') "
           "FROM gripper_adjustments a LEFT JOIN adjustment_ends x ON x.adjustment_id = a.id "_s;
}

QString namesText(const QStringList& names)
{
    return QString::fromUtf8(QJsonDocument(QJsonArray::fromStringList(names)).toJson(QJsonDocument::Compact));
}

QStringList takeNames(Statement& row)
{
    QStringList names;
    for (const QJsonValue name : QJsonDocument::fromJson(row.takeText().toUtf8()).array())
        names << name.toString();
    return names;
}

Expected<AdjustmentRecord> takeAdjustment(Statement& row)
{
    AdjustmentRecord record;
    NewAdjustment& own = record.adjustment;
    record.id = row.takeText();
    record.accepted = row.takeUtc();
    record.station = row.takeText();
    own.gripperSerial = row.takeText();
    own.gripperName = row.takeText();
    own.enrolledOn = takeNames(row);
    own.types = takeNames(row);
    own.squeezes = int(row.takeInteger());
    DeterminedText text;
    for (QString* const column : {&text.quantities, &text.logarithms, &text.covariance})
        *column = row.takeText();
    for (double* const number :
         {&own.error.degreesOfFreedom, &own.error.pValue, &own.error.agreement, &own.error.misfit})
        *number = row.takeReal();
    own.studyId = row.takeText();
    record.libraryVersion = row.takeInteger();
    record.program = row.takeText();
    own.operatorName = row.takeText();
    own.reason = row.takeText();
    record.inForce = row.takeInteger() != 0;
    record.withdrawnAt = row.takeUtc();
    record.withdrawn = record.withdrawnAt.isValid();
    record.withdrawnBy = row.takeText();
    record.withdrawnReason = row.takeText();
    const std::optional<DeterminedQuantities> error = determinedQuantities(text);
    if (!error || !error->covariance)
        return failure(ErrorCode::StorageCorrupt,
                       {Words::tr("The adjustment of gripper %1").arg(own.gripperSerial),
                        Words::tr("its numbers are not those that were stored")});
    own.error.space = error->space;
    own.error.value = error->log;
    own.error.covariance = *error->covariance;
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewAdjustment& adjustment,
                      qint64 libraryVersion)
{
    const CommonShift& error = adjustment.error;
    const std::optional<DeterminedText> text =
        determinedText(DeterminedQuantities{error.space, error.value, error.covariance});
    if (!text)
        return failure(ErrorCode::Usage, {Words::tr("An adjustment holds a number that is not finite.")});
    Statement row(database, Words::tr("store the adjustment"),
                  u"INSERT INTO gripper_adjustments (id, station, created_utc, gripper_serial, gripper_name, "
                  u"enrolled_on, "
                  "types, squeezes, quantities, logarithms, covariance, degrees_of_freedom, p_value, "
                  "agreement, misfit, "
                  "study_id, library_version, program, operator_name, reason, serial) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"gripper_adjustments"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    row.bind(adjustment.gripperSerial).bind(adjustment.gripperName);
    row.bind(namesText(adjustment.enrolledOn)).bind(namesText(adjustment.types)).bind(adjustment.squeezes);
    row.bind(text->quantities).bind(text->logarithms).bind(text->covariance);
    row.bind(error.degreesOfFreedom).bind(error.pValue).bind(error.agreement).bind(error.misfit);
    row.bindOrNull(adjustment.studyId).bind(libraryVersion).bind(QStringLiteral(GRIPSCOPE_VERSION));
    return row.bind(adjustment.operatorName).bind(adjustment.reason).run();
}

Expected<void> insertEnd(Database& database, const QString& id, const QString& reason,
                         const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(
        database, Words::tr("withdraw the adjustment"),
        u"INSERT INTO adjustment_ends (id, station, created_utc, adjustment_id, operator_name, reason) "
        "VALUES (?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(id);
    return row.bind(operatorName).bind(reason).run();
}

Expected<std::optional<AdjustmentRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingAdjustments(), selectAdjustments() + u"WHERE a.id = ?"_s);
    return firstRow(query.bind(id), takeAdjustment);
}

Expected<std::vector<AdjustmentRecord>> newest(Database& database, int limit)
{
    Statement query(database, readingAdjustments(),
                    selectAdjustments() + u"ORDER BY a.serial DESC, a.id DESC LIMIT ?"_s);
    return allRows(query.bind(std::max(0, limit)), takeAdjustment);
}

Expected<std::optional<AdjustmentRecord>> inForce(Database& database, const QString& gripperSerial)
{
    Statement query(database, readingAdjustments(),
                    selectAdjustments() + u"WHERE a.gripper_serial = ? AND "_s + isInForce);
    return firstRow(query.bind(gripperSerial), takeAdjustment);
}

Expected<std::vector<AdjustmentRecord>> allInForce(Database& database)
{
    Statement query(database, readingAdjustments(),
                    selectAdjustments() + u"WHERE "_s + isInForce + u" ORDER BY a.gripper_serial"_s);
    return allRows(query, takeAdjustment);
}

Expected<QMap<QString, QStringList>> grippersOfTypes(Database& database)
{
    Statement query(database, readingAdjustments(),
                    u"SELECT DISTINCT s.name, g.device_serial FROM grasps g "_s + grasp_table::typeJoins() +
                        u"WHERE g.type_id IS NOT NULL AND COALESCE(p.accepted, 1) = 1 AND "
                        "s.status IN ('enrolled', 'approved') ORDER BY s.name, g.device_serial"_s);
    QMap<QString, QStringList> grippers;
    const auto done = query.forEach([&](Statement& row) {
        const QString type = row.takeText();
        grippers[type] << row.takeText();
    });
    if (!done)
        return tl::unexpected<Error>(done.error());
    return grippers;
}

} // namespace gripscope::adjustment_table
