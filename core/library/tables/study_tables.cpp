// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/study_tables.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/recipe_columns.h"
#include "core/library/tables/serial.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(StudyState state)
{
    switch (state) {
    case StudyState::Open:
        return u"open"_s;
    case StudyState::Finished:
        return u"finished"_s;
    case StudyState::Abandoned:
        break;
    }
    return u"abandoned"_s;
}

namespace study_table {

namespace {

QString readingStudies()
{
    return Words::tr("read the studies");
}

QString documentText(const QJsonObject& object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

QJsonObject takeDocument(Statement& row)
{
    return QJsonDocument::fromJson(row.takeText().toUtf8()).object();
}

QString selectStudies()
{
    return u"SELECT s.id, s.created_utc, s.kind, s.name, s.plan, s.options, s.gripper_serial, "_s +
           recipeColumns(u"s."_s) +
           u", s.operator_name, COALESCE(e.state, ''), COALESCE(e.created_utc, ''), "
           "COALESCE(e.reason, ''), COALESCE(e.operator_name, ''), "
           "(SELECT COUNT(*) FROM study_measurements m WHERE m.study_id = s.id AND m.outcome = 'measured' "
           "AND m.id NOT IN (SELECT u.measurement_id FROM study_undos u)) "
           "FROM studies s LEFT JOIN study_ends e ON e.study_id = s.id "_s;
}

StudyRecord takeStudy(Statement& row)
{
    StudyRecord record;
    record.id = row.takeText();
    record.begun = row.takeUtc();
    record.study.kind = row.takeText();
    record.study.name = row.takeText();
    record.study.plan = takeDocument(row);
    record.study.options = takeDocument(row);
    record.study.gripperSerial = row.takeText();
    record.study.recipe = takeRecipe(row);
    record.study.operatorName = row.takeText();
    const QString state = row.takeText();
    if (!state.isEmpty())
        record.state = state == toString(StudyState::Finished) ? StudyState::Finished : StudyState::Abandoned;
    if (const QDateTime ended = row.takeUtc(); ended.isValid())
        record.ended = ended;
    record.endReason = row.takeText();
    record.endedBy = row.takeText();
    record.measurements = row.takeInteger();
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewStudy& study)
{
    Statement row(database, Words::tr("begin the study"),
                  u"INSERT INTO studies (id, station, created_utc, kind, name, plan, options, "
                  "gripper_serial, "_s +
                      recipeColumns() + u", operator_name, serial) VALUES (?, ?, ?, ?, ?, ?, ?, ?, "_s +
                      recipePlaces() + u", ?, "_s + nextSerial(u"studies"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(study.kind).bind(study.name);
    row.bind(documentText(study.plan)).bind(documentText(study.options)).bind(study.gripperSerial);
    bindRecipe(row, study.recipe);
    return row.bind(study.operatorName).run();
}

Expected<void> insertEnd(Database& database, const QString& studyId, StudyState end, const QString& reason,
                         const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("end the study"),
                  u"INSERT INTO study_ends (id, station, created_utc, study_id, state, reason, "
                  "operator_name) VALUES (?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(studyId).bind(toString(end));
    return row.bind(reason).bind(operatorName).run();
}

Expected<std::optional<StudyRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingStudies(), selectStudies() + u"WHERE s.id = ?"_s);
    return firstRow(query.bind(id), takeStudy);
}

Expected<std::vector<StudyRecord>> newest(Database& database, int limit, bool openOnly)
{
    Statement query(database, readingStudies(),
                    selectStudies() + (openOnly ? u"WHERE e.id IS NULL "_s : QString()) +
                        u"ORDER BY s.serial DESC, s.id DESC LIMIT ?"_s);
    return allRows(query.bind(std::max(0, limit)), takeStudy);
}

} // namespace study_table

namespace study_measurement_table {

namespace {

QString readingMeasurements()
{
    return Words::tr("read the measurements of the study");
}

const auto selectMeasurements =
    u"SELECT m.id, m.created_utc, m.study_id, m.plan_row, m.outcome, m.m, m.m_error, m.b, m.b_error, m.k, "
    u"m.k_error, m.m_unit, m.b_unit, m.k_unit, m.rating, m.validity, m.reasons, m.gripper_serial, "
    "m.operator_name, COALESCE(m.squeeze_id, ''), COALESCE(u.id, ''), COALESCE(u.reason, '') "
    "FROM study_measurements m LEFT JOIN study_undos u ON u.measurement_id = m.id "_s;

QString reasonsText(const Findings& reasons)
{
    QJsonArray array;
    for (const Finding& reason : reasons)
        array.append(reason.toJson());
    return QString::fromUtf8(QJsonDocument(array).toJson(QJsonDocument::Compact));
}

Findings reasonsFrom(const QString& text)
{
    Findings reasons;
    for (const QJsonValue reason : QJsonDocument::fromJson(text.toUtf8()).array())
        if (std::optional<Finding> finding = Finding::fromJson(reason))
            reasons.push_back(*std::move(finding));
    return reasons;
}

StudyMeasurementRecord takeMeasurement(Statement& row)
{
    StudyMeasurementRecord record;
    NewStudyMeasurement& measured = record.measured;
    record.id = row.takeText();
    record.stored = row.takeUtc();
    measured.studyId = row.takeText();
    measured.row = row.takeInteger();
    measured.outcome = row.takeText();
    for (std::optional<StudyValue>& value : measured.values) {
        const std::optional<double> number = row.takeOptionalReal(), error = row.takeOptionalReal();
        // The library stores none that is not finite; a file that was changed past it may have one.
        if (number && std::isfinite(*number))
            value = StudyValue{*number, error && std::isfinite(*error) ? std::max(0.0, *error) : 0};
    }
    for (QString& unit : measured.units)
        unit = row.takeText();
    measured.rating = row.takeText();
    measured.validity = row.takeText();
    measured.reasons = reasonsFrom(row.takeText());
    measured.gripperSerial = row.takeText();
    measured.operatorName = row.takeText();
    record.squeezeId = row.takeText();
    record.undone = !row.takeText().isEmpty();
    record.undoReason = row.takeText();
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewStudyMeasurement& measured)
{
    Statement row(database, Words::tr("store the measurement"),
                  u"INSERT INTO study_measurements (id, station, created_utc, study_id, plan_row, outcome, "
                  "m, m_error, b, b_error, k, k_error, m_unit, b_unit, k_unit, rating, validity, reasons, "
                  "gripper_serial, operator_name, squeeze_id, serial) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "_s +
                      nextSerial(u"study_measurements"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(measured.studyId);
    row.bind(measured.row).bind(measured.outcome);
    for (const std::optional<StudyValue>& value : measured.values) {
        row.bind(value ? std::optional(value->value) : std::nullopt);
        row.bind(value ? std::optional(value->standardUncertainty) : std::nullopt);
    }
    for (const QString& unit : measured.units)
        row.bind(unit);
    row.bind(measured.rating).bind(measured.validity).bind(reasonsText(measured.reasons));
    row.bind(measured.gripperSerial).bind(measured.operatorName);
    return row.bindOrNull(measured.squeeze ? measured.squeeze->id : QString()).run();
}

Expected<void> insertUndo(Database& database, const QString& measurementId, const QString& reason,
                          const QString& operatorName)
{
    const RowStamp stamp = RowStamp::now();
    Statement row(database, Words::tr("take the measurement back"),
                  u"INSERT INTO study_undos (id, station, created_utc, measurement_id, reason, "
                  "operator_name) VALUES (?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(measurementId);
    return row.bind(reason).bind(operatorName).run();
}

Expected<std::optional<StudyMeasurementRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingMeasurements(), selectMeasurements + u"WHERE m.id = ?"_s);
    return firstRow(query.bind(id), takeMeasurement);
}

Expected<std::vector<StudyMeasurementRecord>> ofStudy(Database& database, const QString& studyId)
{
    Statement query(database, readingMeasurements(),
                    selectMeasurements + u"WHERE m.study_id = ? ORDER BY m.serial, m.id"_s);
    return allRows(query.bind(studyId), takeMeasurement);
}

} // namespace study_measurement_table
} // namespace gripscope
