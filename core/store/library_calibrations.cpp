// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/calibration_table.h"
#include "core/store/library_private.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<void> Library::addCalibration(const SensorCalibration& calibration)
{
    const auto missing = [](const QString& what) { return failure(ErrorCode::Usage, {what}); };
    if (calibration.gripperSerial.isEmpty())
        return missing(Words::tr("This gripper has no serial number to keep its calibration under."));
    if (calibration.unit.isEmpty() || !calibration.takenUtc.isValid())
        return missing(Words::tr("A calibration needs the unit of its channel and the time it was taken."));
    if (!calibration.due.isValid())
        return missing(Words::tr("A calibration needs a date until which it holds."));
    if (const auto evaluation = evaluateCalibration(calibration); !evaluation)
        return tl::unexpected<Error>(evaluation.error());
    return d->write<void>(Words::tr("store the calibration"), [&] {
        return calibration_table::insert(*d->database, RowStamp::now(), calibration);
    });
}

Expected<std::vector<CalibrationRecord>> Library::calibrations(const QString& gripperSerial, int limit) const
{
    return calibration_table::read(*d->database, gripperSerial, limit);
}

Expected<CalibrationsInForce> Library::calibrationsInForce(const QString& gripperSerial) const
{
    return calibration_table::inForce(*d->database, gripperSerial);
}

} // namespace gripscope
