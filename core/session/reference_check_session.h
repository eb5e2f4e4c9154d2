// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/identification/repeated_measurement.h"
#include "core/session/judged_series.h"

namespace gripscope {

/// Checks the connected gripper on its reference object: as many squeezes as are stated there, then the
/// verdict (judgeCheck()), which is kept in the library whatever it is: a check cannot be repeated until it
/// passes without that being seen.
///
/// From Measured on there is check(). Stored: how the gripper stands is in force for the squeezes to come.
class ReferenceCheckSession : public JudgedSeries<Identification> {
public:
    ReferenceCheckSession(ConnectSession& connection, LibraryService& library);

    /// Usage: the gripper has no reference object, or its channels have no units that are known. Else what
    /// SqueezeJob says.
    [[nodiscard]] Expected<void> start();

    [[nodiscard]] const std::optional<ReferenceCheckRecord>& check() const { return m_check; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    void conclude() override;

    ReferenceObjectRecord m_reference;
    double m_toSi = 1;
    std::optional<ReferenceCheckRecord> m_check;
};

/// How a gripper is squeezed on its reference object.
[[nodiscard]] Recipe recipeOf(const ReferenceObject& reference);

} // namespace gripscope
