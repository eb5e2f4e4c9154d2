// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/sensor_correction.h"
#include "core/session/gripper_port.h"

namespace gripscope {

/// The calibrations in force for the connected gripper, and what they do to its samples: from the device's
/// readings to loads. Recordings hold loads, and say in their provenance by which calibration; the readings
/// can be found again from it.
class ChannelCalibration {
public:
    /// Only those whose unit is the channel's own; the others are told by unusable(). None for a gripper
    /// whose samples are corrected already.
    void put(const CalibrationsInForce& calibrations, const GripperIdentity& gripper);
    void clear() { *this = {}; }
    /// What is used of a channel; null when nothing is.
    [[nodiscard]] const CalibrationRecord* record(SensorChannel channel) const;
    /// The reference object that the gripper is checked on.
    [[nodiscard]] const std::optional<ReferenceStanding>& reference() const { return m_reference; }
    [[nodiscard]] const QString& unusable() const { return m_unusable; }

    void correct(std::vector<Sample>& samples) const;
    /// The reading of the device itself that correct() takes to this value.
    [[nodiscard]] double uncorrected(SensorChannel channel, double value) const;
    /// Notes in the recording what was done to its channels, how long that holds and how certain it is.
    void describe(Recording& recording, const QDateTime& now) const;

private:
    struct InUse {
        CalibrationRecord record;
        SensorCorrection correction;
        double scaleUncertainty = 0; ///< relative, standard
    };
    [[nodiscard]] std::optional<InUse> use(const std::optional<CalibrationRecord>& record,
                                           const QString& unit);
    [[nodiscard]] const std::optional<InUse>& of(SensorChannel channel) const;

    std::optional<InUse> m_force, m_position;
    std::optional<ReferenceStanding> m_reference;
    QString m_unusable;
};

} // namespace gripscope
