// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/gripper_profile.h"

namespace gripscope {

/// What one field of a report says.
struct FieldValue {
    QString name;          ///< as in the profile: "force"
    std::size_t index;     ///< of the sample, for those that a report has several of
    std::size_t byte, end; ///< the field's bytes, [byte, end)
    double number;         ///< as it stands in the report
    double value;          ///< in `unit`
    QString unit;          ///< "s" for time, empty for a counter or flags
    QString words;         ///< of flags: those that hold, "moving, fault"; else empty
};

/// All fields of a report that has the profile's length (and ID), sample by sample; none for another one.
[[nodiscard]] std::vector<FieldValue> fieldValues(const GripperProfile& profile, protocol::ReportView report);

/// What a byte belongs to: "force", "force 2" (the second sample's), "report ID", several with commas; empty:
/// nothing.
[[nodiscard]] QString ownersOfByte(const GripperProfile& profile, std::size_t byte);

} // namespace gripscope
