// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/calibration_table.h"

#include "core/store/rows.h"
#include "core/words.h"

#include <QStringList>

namespace gripscope::calibration_table {

using namespace Qt::StringLiterals;

namespace {

QString reading()
{
    return Words::tr("read the calibrations");
}
const auto columns = u"id, created_utc, gripper_serial, gripper_name, channel, unit, reference_name, "
                     "reference_certificate, reference_uncertainty, reference_relative_uncertainty, degree, "
                     "points, taken_utc, due_date, operator_name, note"_s;

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

Expected<CalibrationRecord> take(Statement& row)
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
    if (!points)
        return tl::unexpected<Error>(points.error());
    if (!channel)
        return failure(ErrorCode::StorageCorrupt,
                       {Words::tr("A calibration"), Words::tr("a channel is neither of the two")});
    record.points = std::move(*points);
    record.channel = *channel;
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const SensorCalibration& calibration)
{
    Statement row(database, Words::tr("store the calibration"),
                  u"INSERT INTO calibrations (station, "_s + columns +
                      u") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.station).bind(stamp.id).bind(stamp.utc);
    row.bind(calibration.gripperSerial).bind(calibration.gripperName);
    row.bind(toString(calibration.channel)).bind(calibration.unit);
    row.bind(calibration.reference.name).bind(calibration.reference.certificate);
    row.bind(calibration.reference.standardUncertainty).bind(calibration.reference.relativeUncertainty);
    row.bind(calibration.degree).bind(textOf(calibration.points));
    row.bind(utcText(calibration.takenUtc)).bind(calibration.due.toString(Qt::ISODate));
    row.bind(calibration.operatorName).bind(calibration.note);
    return row.run();
}

Expected<std::vector<CalibrationRecord>> read(Database& database, const QString& gripperSerial, int limit)
{
    Statement query(database, reading(),
                    u"SELECT "_s + columns +
                        u" FROM calibrations WHERE ? IN ('', gripper_serial) "
                        "ORDER BY created_utc DESC, id DESC LIMIT ?"_s);
    query.bind(gripperSerial).bind(limit);
    return allRows(query, take);
}

Expected<CalibrationsInForce> inForce(Database& database, const QString& gripperSerial)
{
    CalibrationsInForce found;
    for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position}) {
        Statement query(database, reading(),
                        u"SELECT "_s + columns +
                            u" FROM calibrations WHERE gripper_serial = ? AND channel = ? "
                            "ORDER BY created_utc DESC, id DESC LIMIT 1"_s);
        query.bind(gripperSerial).bind(toString(channel));
        Expected<std::optional<CalibrationRecord>> newest = firstRow(query, take);
        if (!newest)
            return tl::unexpected<Error>(newest.error());
        (channel == SensorChannel::Force ? found.force : found.position) = std::move(*newest);
    }
    return found;
}

} // namespace gripscope::calibration_table
