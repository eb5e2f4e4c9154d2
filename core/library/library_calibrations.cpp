// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/audit_details.h"
#include "core/library/library_private.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/calibration_tables.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

NewAuditEntry auditEntryOf(const SensorCalibration& calibration)
{
    NewAuditEntry entry;
    entry.action = QString::fromUtf16(audit_action::calibrationAccepted);
    entry.subject = calibration.gripperSerial;
    entry.reason = calibration.note;
    entry.operatorName = calibration.operatorName;
    entry.details = {{u"channel"_s, toString(calibration.channel)},
                     {u"points"_s, int(calibration.points.size())},
                     {u"degree"_s, calibration.degree},
                     {u"due"_s, calibration.due.toString(Qt::ISODate)},
                     {u"reference"_s, calibration.reference.name}};
    return entry;
}

} // namespace

Expected<void> Library::addCalibration(const SensorCalibration& calibration)
{
    const auto missing = [](const QString& what) { return failure(ErrorCode::Usage, {what}); };
    if (calibration.gripperSerial.isEmpty())
        return missing(Words::tr("This gripper has no serial number to keep its calibration under."));
    if (calibration.unit.isEmpty() || !calibration.takenUtc.isValid())
        return missing(Words::tr("A calibration needs the unit of its channel and the time it was taken."));
    if (!calibration.due.isValid())
        return missing(Words::tr("A calibration needs a date until which it holds."));
    RETURN_IF_ERROR(problemOf(calibration.conditions));
    RETURN_IF_ERROR(evaluateCalibration(calibration));
    for (const CalibrationPoint& point : calibration.checkPoints)
        if (!std::isfinite(point.load) || !std::isfinite(point.reading))
            return missing(Words::tr("A point that was checked holds a number that is not finite."));
    return d->writeIf<void>(
        Permission::AcceptCalibrations, Words::tr("store the calibration"), [&]() -> Expected<void> {
            RETURN_IF_ERROR(calibration_table::insert(*d->database, RowStamp::now(), calibration));
            return audit_table::append(*d->database, auditEntryOf(calibration));
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
    ASSIGN_OR_RETURN(const auto reference, reference_table::newest(*d->database, gripperSerial));
    if (!reference)
        return found;
    ASSIGN_OR_RETURN(auto last, reference_check_table::newest(*d->database, *reference));
    found->reference = ReferenceStanding{*reference, std::move(last)};
    return found;
}

Expected<void> Library::addReferenceObject(const ReferenceObject& reference, const QString& reason)
{
    if (reference.gripperSerial.isEmpty())
        return failure(ErrorCode::Usage,
                       {Words::tr("This gripper has no serial number to keep its reference object under.")});
    if (const Finding problem = problemOf(reference); !problem.isEmpty())
        return failure(ErrorCode::Usage, {problem});
    return d->writeIf<void>(
        Permission::AcceptCalibrations, Words::tr("store the reference object"), [&]() -> Expected<void> {
            ASSIGN_OR_RETURN(const auto before,
                             reference_table::newest(*d->database, reference.gripperSerial));
            RETURN_IF_ERROR(reference_table::insert(*d->database, RowStamp::now(), reference));
            return audit_table::append(
                *d->database, {QString::fromUtf16(audit_action::referenceStated), reference.gripperSerial,
                               reason, auditDetails(before, reference), reference.operatorName});
        });
}

Expected<void> Library::addReferenceCheck(const ReferenceCheck& check)
{
    for (const std::optional<MeasuredQuantity>& measured : check.measured)
        if (measured && !(std::isfinite(measured->value) && std::isfinite(measured->standardUncertainty)))
            return failure(ErrorCode::Usage,
                           {Words::tr("A number that was measured in the check is not finite.")});
    return d->write<void>(Words::tr("store the check on the reference object"), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto reference, reference_table::find(*d->database, check.referenceId));
        if (!reference)
            return failure(ErrorCode::NotFound, {Words::tr("the reference object of this check")});
        RETURN_IF_ERROR(reference_check_table::insert(*d->database, RowStamp::now(), check));
        return audit_table::append(*d->database, {QString::fromUtf16(audit_action::referenceChecked),
                                                  reference->gripperSerial,
                                                  check.obstacle,
                                                  {{u"reference"_s, reference->name},
                                                   {u"verdict"_s, toString(check.verdict)},
                                                   {u"squeezes"_s, check.squeezes}},
                                                  check.operatorName});
    });
}

Expected<std::vector<ReferenceCheckRecord>> Library::referenceChecks(const QString& gripperSerial,
                                                                     int limit) const
{
    return reference_check_table::read(*d->database, gripperSerial, limit);
}

} // namespace gripscope
