// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/calibration_tables.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/serial.h"

#include <QStringList>

namespace gripscope::calibration_table {

using namespace Qt::StringLiterals;

namespace {

QString readingCalibrations()
{
    return Words::tr("read the calibrations");
}
const auto calibrationColumns =
    u"id, created_utc, gripper_serial, gripper_name, channel, unit, reference_name, "
    "reference_certificate, reference_uncertainty, reference_relative_uncertainty, degree, "
    "points, taken_utc, due_date, operator_name, note, load_unit, gravity, ambient_celsius, tolerance, "
    "decision_rule, reference_due, found_correction, check_points"_s;
/// What only a stored one has.
const auto storedColumns = u", station, certificate_number"_s;

QString textOf(const std::vector<CalibrationPoint>& points)
{
    QStringList lines;
    for (const CalibrationPoint& point : points)
        lines << QString::number(point.load, 'g', 17) + u' ' + QString::number(point.reading, 'g', 17);
    return lines.join(u'\n');
}

Expected<std::vector<CalibrationPoint>> pointsOf(const QString& text)
{
    std::vector<CalibrationPoint> points;
    for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts)) {
        const QStringList numbers = line.split(u' ');
        bool hasLoad = false;
        bool hasReading = false;
        const CalibrationPoint point{numbers.value(0).toDouble(&hasLoad),
                                     numbers.value(1).toDouble(&hasReading)};
        if (!hasLoad || !hasReading || numbers.size() != 2)
            return failure(ErrorCode::StorageCorrupt,
                           {Words::tr("A calibration"), Words::tr("a point reads \"%1\"").arg(line)});
        points.push_back(point);
    }
    return points;
}

/// In the order of calibrationColumns, from load_unit on.
Expected<void> takeConditions(Statement& row, SensorCalibration& calibration)
{
    const auto corrupt = [](const QString& why) {
        return failure(ErrorCode::StorageCorrupt, {Words::tr("A calibration"), why});
    };
    CalibrationConditions& conditions = calibration.conditions;
    const std::optional<LoadUnit> loadUnit = loadUnitFromString(row.takeText());
    conditions.gravity = row.takeOptionalReal().value_or(standardGravity);
    conditions.ambient_C = row.takeOptionalReal();
    conditions.tolerance = row.takeOptionalReal();
    const std::optional<DecisionRule> rule = decisionRuleFromString(row.takeText());
    calibration.reference.due = QDate::fromString(row.takeText(), Qt::ISODate);
    calibration.foundCorrection = row.takeOptionalText();
    ASSIGN_OR_RETURN(calibration.checkPoints, pointsOf(row.takeText()));
    if (!loadUnit || !rule)
        return corrupt(Words::tr("a unit of loads or a decision rule is none that is known"));
    conditions.loadUnit = *loadUnit;
    conditions.rule = *rule;
    if (problemOf(conditions))
        return corrupt(Words::tr("its conditions are none that there can be"));
    return {};
}

Expected<CalibrationRecord> takeCalibration(Statement& row)
{
    CalibrationRecord record;
    record.id = row.takeText();
    record.stored = row.takeUtc();
    record.gripperSerial = row.takeText();
    record.gripperName = row.takeText();
    const std::optional<SensorChannel> channel = sensorChannelFromString(row.takeText());
    record.unit = row.takeText();
    record.reference.name = row.takeText();
    record.reference.certificate = row.takeText();
    record.reference.standardUncertainty = row.takeReal();
    record.reference.relativeUncertainty = row.takeReal();
    record.degree = int(row.takeInteger());
    Expected<std::vector<CalibrationPoint>> points = pointsOf(row.takeText());
    record.takenUtc = row.takeUtc();
    record.due = QDate::fromString(row.takeText(), Qt::ISODate);
    record.operatorName = row.takeText();
    record.note = row.takeText();
    const Expected<void> conditions = takeConditions(row, record);
    record.station = row.takeText();
    record.certificateNumber = row.takeInteger();
    if (!conditions)
        return tl::unexpected<Error>(conditions.error());
    if (!points)
        return tl::unexpected<Error>(points.error());
    if (!channel)
        return failure(ErrorCode::StorageCorrupt,
                       {Words::tr("A calibration"), Words::tr("a channel is neither of the two")});
    record.points = std::move(*points);
    record.channel = *channel;
    return record;
}

/// As takeConditions() takes them.
void bindConditions(Statement& row, const SensorCalibration& calibration)
{
    const CalibrationConditions& conditions = calibration.conditions;
    const bool masses = conditions.loadUnit != LoadUnit::Channel;
    row.bind(toString(conditions.loadUnit));
    row.bind(masses ? std::optional(conditions.gravity) : std::nullopt);
    row.bind(conditions.ambient_C).bind(conditions.tolerance).bind(toString(conditions.rule));
    row.bind(calibration.reference.due.isValid() ? calibration.reference.due.toString(Qt::ISODate) : u""_s);
    row.bindOptional(calibration.foundCorrection).bind(textOf(calibration.checkPoints));
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const SensorCalibration& calibration)
{
    // The next number of this station, within the transaction: no two are alike, and as rows stay, none comes
    // again.
    Statement row(
        database, Words::tr("store the calibration"),
        u"INSERT INTO calibrations (station, "_s + calibrationColumns +
            u", serial, certificate_number) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
            "?, ?, ?, ?, ?, ?, ?, ?, "_s +
            nextSerial(u"calibrations"_s) +
            u", (SELECT COALESCE(MAX(certificate_number), 0) + 1 FROM calibrations WHERE station = ?))"_s);
    row.bind(stamp.station).bind(stamp.id).bind(stamp.utc);
    row.bind(calibration.gripperSerial).bind(calibration.gripperName);
    row.bind(toString(calibration.channel)).bind(calibration.unit);
    row.bind(calibration.reference.name).bind(calibration.reference.certificate);
    row.bind(calibration.reference.standardUncertainty).bind(calibration.reference.relativeUncertainty);
    row.bind(calibration.degree).bind(textOf(calibration.points));
    row.bind(utcText(calibration.takenUtc)).bind(calibration.due.toString(Qt::ISODate));
    row.bind(calibration.operatorName).bind(calibration.note);
    bindConditions(row, calibration);
    return row.bind(stamp.station).run();
}

Expected<std::vector<CalibrationRecord>> read(Database& database, const QString& gripperSerial, int limit)
{
    Statement query(database, readingCalibrations(),
                    u"SELECT "_s + calibrationColumns + storedColumns +
                        u" FROM calibrations WHERE ? IN ('', gripper_serial) "
                        "ORDER BY "_s +
                        newestFirst + u" LIMIT ?"_s);
    query.bind(gripperSerial).bind(limit);
    return allRows(query, takeCalibration);
}

Expected<CalibrationsInForce> inForce(Database& database, const QString& gripperSerial)
{
    CalibrationsInForce found;
    for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position}) {
        Statement query(database, readingCalibrations(),
                        u"SELECT "_s + calibrationColumns + storedColumns +
                            u" FROM calibrations WHERE gripper_serial = ? AND channel = ? "
                            "ORDER BY "_s +
                            newestFirst + u" LIMIT 1"_s);
        query.bind(gripperSerial).bind(toString(channel));
        ASSIGN_OR_RETURN(std::optional<CalibrationRecord> newest, firstRow(query, takeCalibration));
        (channel == SensorChannel::Force ? found.force : found.position) = std::move(newest);
    }
    return found;
}

} // namespace gripscope::calibration_table

namespace gripscope::measuring_chain_table {

using namespace Qt::StringLiterals;

namespace {

MeasuringChainRecord takeChain(Statement& row, const QString& gripperSerial)
{
    MeasuringChainRecord record;
    record.gripperSerial = gripperSerial;
    record.measured = row.takeUtc();
    record.operatorName = row.takeText();
    record.basis = row.takeText();
    record.forceLag_s = row.takeReal();
    MeasuringChain& chain = record.chain;
    for (double* value :
         {&chain.forceLagUncertainty_s, &chain.forceNoiseDeviation, &chain.forceScaleUncertainty,
          &chain.positionScaleUncertainty, &chain.frameCompliance, &chain.frameComplianceUncertainty})
        *value = row.takeReal();
    GripperBaseline baseline;
    bool complete = true;
    for (auto* values : {&baseline.parameters, &baseline.standardErrors})
        for (double& value : *values) {
            const std::optional<double> stored = row.takeOptionalReal();
            complete = complete && stored;
            value = stored.value_or(0);
        }
    if (complete)
        chain.baseline = baseline;
    const std::optional<double> friction = row.takeOptionalReal();
    const std::optional<double> frictionError = row.takeOptionalReal();
    if (friction && frictionError)
        chain.friction = GripperFriction{*friction, *frictionError};
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewMeasuringChain& measured)
{
    Statement row(
        database, Words::tr("store what was measured of the gripper"),
        u"INSERT INTO measuring_chains (id, station, created_utc, gripper_serial, operator_name, basis, "
        u"force_lag_s, "
        "force_lag_uncertainty_s, force_noise_deviation, force_scale_uncertainty, "
        "position_scale_uncertainty, frame_compliance, "
        "frame_compliance_uncertainty, baseline_m, baseline_b, baseline_k, baseline_error_m, "
        "baseline_error_b, "
        "baseline_error_k, friction, friction_error, serial) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "_s +
            nextSerial(u"measuring_chains"_s) + u')');
    const MeasuringChain& chain = measured.chain;
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    row.bind(measured.gripperSerial).bind(measured.operatorName).bind(measured.basis);
    row.bind(measured.forceLag_s)
        .bind(chain.forceLagUncertainty_s)
        .bind(chain.forceNoiseDeviation)
        .bind(chain.forceScaleUncertainty);
    row.bind(chain.positionScaleUncertainty)
        .bind(chain.frameCompliance)
        .bind(chain.frameComplianceUncertainty);
    for (const auto member : {&GripperBaseline::parameters, &GripperBaseline::standardErrors})
        for (std::size_t i = 0; i < 3; ++i)
            row.bind(chain.baseline ? std::optional((*chain.baseline.*member)[i]) : std::nullopt);
    for (const auto member : {&GripperFriction::value, &GripperFriction::standardError})
        row.bind(chain.friction ? std::optional(*chain.friction.*member) : std::nullopt);
    return row.run();
}

Expected<std::vector<MeasuringChainRecord>> list(Database& database, const QString& gripperSerial, int limit)
{
    std::vector<MeasuringChainRecord> found;
    Statement query(
        database, Words::tr("read what is known of the gripper"),
        u"SELECT created_utc, operator_name, basis, force_lag_s, force_lag_uncertainty_s, "
        u"force_noise_deviation, force_scale_uncertainty, "
        "position_scale_uncertainty, frame_compliance, frame_compliance_uncertainty, baseline_m, baseline_b, "
        "baseline_k, baseline_error_m, baseline_error_b, baseline_error_k, friction, friction_error "
        "FROM measuring_chains "
        "WHERE gripper_serial = ? ORDER BY "_s +
            newestFirst + u" LIMIT ?"_s);
    RETURN_IF_ERROR(query.bind(gripperSerial).bind(limit).forEach([&](Statement& row) {
        found.push_back(takeChain(row, gripperSerial));
    }));
    return found;
}

Expected<std::optional<MeasuringChainRecord>> newest(Database& database, const QString& gripperSerial)
{
    ASSIGN_OR_RETURN(const std::vector<MeasuringChainRecord> found, list(database, gripperSerial, 1));
    return found.empty() ? std::nullopt : std::optional(found.front());
}

} // namespace gripscope::measuring_chain_table
