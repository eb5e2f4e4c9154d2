// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/calibration_table.h"
#include "core/store/library_private.h"
#include "core/store/reference_check_table.h"
#include "core/store/reference_table.h"
#include "core/words.h"

#include <cmath>

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
    Expected<CalibrationsInForce> found = calibration_table::inForce(*d->database, gripperSerial);
    if (!found)
        return found;
    const auto reference = reference_table::newest(*d->database, gripperSerial);
    if (!reference)
        return tl::unexpected<Error>(reference.error());
    if (!*reference)
        return found;
    auto last = reference_check_table::newest(*d->database, **reference);
    if (!last)
        return tl::unexpected<Error>(last.error());
    found->reference = ReferenceStanding{**reference, std::move(*last)};
    return found;
}

Expected<void> Library::addReferenceObject(const ReferenceObject& reference)
{
    if (reference.gripperSerial.isEmpty())
        return failure(ErrorCode::Usage,
                       {u"This gripper has no serial number to keep its reference object under."_s});
    if (const QString problem = problemOf(reference); !problem.isEmpty())
        return failure(ErrorCode::Usage, {problem});
    return d->write<void>(u"store the reference object"_s,
                          [&] { return reference_table::insert(*d->database, RowStamp::now(), reference); });
}

Expected<void> Library::addReferenceCheck(const ReferenceCheck& check)
{
    for (const std::optional<MeasuredQuantity>& measured : check.measured)
        if (measured && !(std::isfinite(measured->value) && std::isfinite(measured->standardUncertainty)))
            return failure(ErrorCode::Usage, {u"A number that was measured in the check is not finite."_s});
    return d->write<void>(u"store the check on the reference object"_s, [&]() -> Expected<void> {
        const auto reference = reference_table::find(*d->database, check.referenceId);
        if (!reference)
            return tl::unexpected<Error>(reference.error());
        if (!*reference)
            return failure(ErrorCode::NotFound, {u"the reference object of this check"_s});
        return reference_check_table::insert(*d->database, RowStamp::now(), check);
    });
}

Expected<std::vector<ReferenceCheckRecord>> Library::referenceChecks(const QString& gripperSerial,
                                                                     int limit) const
{
    return reference_check_table::read(*d->database, gripperSerial, limit);
}

} // namespace gripscope
