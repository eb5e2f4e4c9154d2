// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/channel_calibration.h"

#include "core/calibration/calibration_facts.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

void ChannelCalibration::put(const CalibrationsInForce& calibrations, const GripperIdentity& gripper)
{
    clear();
    if (gripper.corrected)
        return;
    const auto use = [&](const std::optional<CalibrationRecord>& record, const QString& unit,
                         std::optional<CalibrationRecord>& kept, std::optional<SensorCorrection>& correction,
                         std::optional<double>& scale) {
        if (!record)
            return;
        if (record->unit != unit) {
            m_unusable =
                Words::tr(
                    "The %1 was calibrated in %2, but the gripper now measures in %3: calibrate it again.")
                    .arg(record->channel == SensorChannel::Force ? Words::tr("force") : Words::tr("position"),
                         record->unit, unit);
            return;
        }
        const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(*record);
        if (!evaluation) { // it was checked when it was stored
            m_unusable = evaluation.error().describe();
            return;
        }
        kept = record;
        correction.emplace(evaluation->curve);
        scale = evaluation->scaleUncertainty;
    };
    use(calibrations.force, gripper.forceUnit, m_inForce.force, m_force, m_forceScale);
    use(calibrations.position, gripper.positionUnit, m_inForce.position, m_position, m_positionScale);
}

void ChannelCalibration::correct(std::vector<Sample>& samples) const
{
    if (m_force)
        for (Sample& sample : samples)
            sample.force = m_force->loadOf(sample.force);
    if (m_position)
        for (Sample& sample : samples)
            sample.position = m_position->loadOf(sample.position);
}

double ChannelCalibration::uncorrected(SensorChannel channel, double value) const
{
    const std::optional<SensorCorrection>& correction =
        channel == SensorChannel::Force ? m_force : m_position;
    return correction ? correction->readingOf(value) : value;
}

void ChannelCalibration::describe(Recording& recording, const QDate& today) const
{
    if (m_inForce.force)
        noteCalibration(recording.provenance, *m_inForce.force, *m_force, today);
    if (m_inForce.position)
        noteCalibration(recording.provenance, *m_inForce.position, *m_position, today);
    recording.chain.forceScaleUncertainty = m_forceScale.value_or(recording.chain.forceScaleUncertainty);
    recording.chain.positionScaleUncertainty =
        m_positionScale.value_or(recording.chain.positionScaleUncertainty);
}

} // namespace gripscope
