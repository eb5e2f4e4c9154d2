// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/calibration/calibration_facts.h"
#include "core/session/connection/connect_session.h"

namespace gripscope {

using namespace Qt::StringLiterals;

void ChannelCalibration::put(const CalibrationsInForce& calibrations, const GripperIdentity& gripper)
{
    clear();
    if (gripper.corrected)
        return;
    m_force = use(calibrations.force, gripper.forceUnit);
    m_position = use(calibrations.position, gripper.positionUnit);
    m_reference = calibrations.reference;
}

std::optional<ChannelCalibration::InUse>
ChannelCalibration::use(const std::optional<CalibrationRecord>& record, const QString& unit)
{
    if (!record)
        return std::nullopt;
    if (record->unit != unit) {
        m_unusable =
            Words::tr("The %1 was calibrated in %2, but the gripper now measures in %3: calibrate it again.")
                .arg(record->channel == SensorChannel::Force ? Words::tr("force") : Words::tr("position"),
                     record->unit, unit);
        return std::nullopt;
    }
    const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(*record);
    if (!evaluation) { // it was checked when it was stored
        m_unusable = evaluation.error().describe();
        return std::nullopt;
    }
    return InUse{*record, SensorCorrection(evaluation->curve), evaluation->scaleUncertainty};
}

const std::optional<ChannelCalibration::InUse>& ChannelCalibration::of(SensorChannel channel) const
{
    return channel == SensorChannel::Force ? m_force : m_position;
}

const CalibrationRecord* ChannelCalibration::record(SensorChannel channel) const
{
    const std::optional<InUse>& inUse = of(channel);
    return inUse ? &inUse->record : nullptr;
}

void ChannelCalibration::correct(std::vector<Sample>& samples) const
{
    if (m_force)
        for (Sample& sample : samples)
            sample.force = m_force->correction.loadOf(sample.force);
    if (m_position)
        for (Sample& sample : samples)
            sample.position = m_position->correction.loadOf(sample.position);
}

double ChannelCalibration::uncorrected(SensorChannel channel, double value) const
{
    const std::optional<InUse>& inUse = of(channel);
    return inUse ? inUse->correction.readingOf(value) : value;
}

void ChannelCalibration::describe(Recording& recording, const QDateTime& now) const
{
    const auto note = [&](const std::optional<InUse>& inUse, double& scaleUncertainty) {
        if (!inUse)
            return;
        noteCalibration(recording.provenance, inUse->record, inUse->correction, now.date());
        scaleUncertainty = inUse->scaleUncertainty;
    };
    note(m_force, recording.chain.forceScaleUncertainty);
    note(m_position, recording.chain.positionScaleUncertainty);
    if (m_reference)
        noteReferenceCheck(recording.provenance, *m_reference, now);
}

} // namespace gripscope
