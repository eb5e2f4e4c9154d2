// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/library/tables/adjustment_table.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/calibration_tables.h"
#include "core/people/audit_entry.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> noAdjustment(const QString& why)
{
    return failure(ErrorCode::Usage, {why});
}

bool isSoundError(const CommonShift& error)
{
    const auto p = Eigen::Index(error.space.dimensions());
    return p > 0 && error.value.size() == p && error.covariance.rows() == p && error.covariance.cols() == p &&
           error.value.allFinite() && error.value.cwiseAbs().maxCoeff() < 10 &&
           usableLogCovariance(error.covariance) && std::isfinite(error.degreesOfFreedom);
}

/// Types in use that have a squeeze of this gripper.
Expected<QStringList> typesOf(Database& database, const QString& gripperSerial)
{
    ASSIGN_OR_RETURN(const auto grippers, adjustment_table::grippersOfTypes(database));
    QStringList types;
    for (auto type = grippers.cbegin(); type != grippers.cend(); ++type)
        if (type->contains(gripperSerial))
            types << type.key();
    return types;
}

/// In the audit trail: by how much this gripper finds more than the other, in percent.
QJsonObject percentDetails(const CommonShift& error)
{
    QJsonObject details;
    for (int i = 0; i < error.space.dimensions(); ++i)
        details.insert(symbolOf(error.space.quantities[std::size_t(i)]) + u"_percent"_s,
                       std::round(1e5 * std::expm1(error.value(i))) / 1e3);
    return details;
}

NewAuditEntry auditEntryOf(const NewAdjustment& adjustment, const std::optional<AdjustmentRecord>& before)
{
    NewAuditEntry entry;
    entry.action = QString::fromUtf16(audit_action::adjustmentAccepted);
    entry.subject = adjustment.gripperSerial;
    entry.reason = adjustment.reason;
    entry.operatorName = adjustment.operatorName;
    entry.details = percentDetails(adjustment.error);
    entry.details.insert(u"types"_s, QJsonArray::fromStringList(adjustment.types));
    entry.details.insert(u"squeezes"_s, adjustment.squeezes);
    if (before)
        entry.details.insert(u"replaces"_s, before->id);
    return entry;
}

/// When the gripper's channels were calibrated or measured last.
Expected<QDateTime> lastCalibrated(Database& database, const QString& gripperSerial)
{
    ASSIGN_OR_RETURN(const CalibrationsInForce calibrations,
                     calibration_table::inForce(database, gripperSerial));
    ASSIGN_OR_RETURN(const auto chain, measuring_chain_table::newest(database, gripperSerial));
    QDateTime last;
    for (const auto& one : {calibrations.force, calibrations.position})
        if (one && (!last.isValid() || one->stored > last))
            last = one->stored;
    if (chain && (!last.isValid() || chain->measured > last))
        last = chain->measured;
    return last;
}

} // namespace

Expected<AdjustmentRecord> Library::acceptAdjustment(const NewAdjustment& adjustment)
{
    if (adjustment.gripperSerial.isEmpty())
        return noAdjustment(Words::tr("This gripper has no serial number to keep its adjustment under."));
    if (adjustment.reason.trimmed().isEmpty())
        return noAdjustment(Words::tr("Say why the gripper is adjusted."));
    if (!isSoundError(adjustment.error))
        return noAdjustment(Words::tr("An adjustment holds a number that is not finite."));
    const auto accept = [&]() -> Expected<AdjustmentRecord> {
        ASSIGN_OR_RETURN(const QStringList own, typesOf(*d->database, adjustment.gripperSerial));
        if (!own.isEmpty())
            return noAdjustment(
                Words::tr("%1 was enrolled on this gripper itself: adjusted, its parts would be "
                          "judged wrongly. Enrol it on the other gripper or retire it first.")
                    .arg(own.join(u", "_s)));
        ASSIGN_OR_RETURN(const auto before,
                         adjustment_table::inForce(*d->database, adjustment.gripperSerial));
        ASSIGN_OR_RETURN(const qint64 now, version());
        const RowStamp stamp = RowStamp::now();
        RETURN_IF_ERROR(adjustment_table::insert(*d->database, stamp, adjustment, now));
        RETURN_IF_ERROR(audit_table::append(*d->database, auditEntryOf(adjustment, before)));
        ASSIGN_OR_RETURN(auto stored, adjustment_table::find(*d->database, stamp.id));
        return *std::move(stored);
    };
    return d->writeIf<AdjustmentRecord>(Permission::AdjustGrippers, Words::tr("store the adjustment"),
                                        accept);
}

Expected<void> Library::withdrawAdjustment(const QString& id, const QString& reason,
                                           const QString& operatorName)
{
    if (reason.trimmed().isEmpty())
        return noAdjustment(Words::tr("Say why the adjustment is withdrawn."));
    const auto withdraw = [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto found, adjustment_table::find(*d->database, id));
        if (!found)
            return failure(ErrorCode::NotFound, {Words::tr("adjustment with the key %1").arg(id)});
        if (!found->inForce)
            return {};
        RETURN_IF_ERROR(adjustment_table::insertEnd(*d->database, id, reason.trimmed(), operatorName));
        NewAuditEntry entry;
        entry.action = QString::fromUtf16(audit_action::adjustmentWithdrawn);
        entry.subject = found->adjustment.gripperSerial;
        entry.reason = reason.trimmed();
        entry.operatorName = operatorName;
        entry.details = percentDetails(found->adjustment.error);
        return audit_table::append(*d->database, entry);
    };
    return d->writeIf<void>(Permission::AdjustGrippers, Words::tr("withdraw the adjustment"), withdraw);
}

Expected<std::vector<AdjustmentRecord>> Library::adjustments(int limit) const
{
    return adjustment_table::newest(*d->database, limit);
}

Expected<std::vector<AdjustmentStanding>> Library::adjustmentsInForce() const
{
    std::vector<AdjustmentStanding> standings;
    ASSIGN_OR_RETURN(std::vector<AdjustmentRecord> records, adjustment_table::allInForce(*d->database));
    for (AdjustmentRecord& record : records) {
        AdjustmentStanding standing;
        const QString serial = record.adjustment.gripperSerial;
        ASSIGN_OR_RETURN(const QDateTime calibrated, lastCalibrated(*d->database, serial));
        if (calibrated.isValid() && calibrated > record.accepted)
            standing.calibratedSince = calibrated;
        ASSIGN_OR_RETURN(standing.ownTypes, typesOf(*d->database, serial));
        standing.record = std::move(record);
        standings.push_back(std::move(standing));
    }
    return standings;
}

Expected<QMap<QString, QStringList>> Library::grippersOfTypes() const
{
    return adjustment_table::grippersOfTypes(*d->database);
}

} // namespace gripscope
