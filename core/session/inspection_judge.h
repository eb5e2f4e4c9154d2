// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/type_shift.h"
#include "core/session/comparable_units.h"
#include "core/session/hold_history.h"
#include "core/session/pool_task.h"

namespace gripscope {

/// One recording after another: identified and judged in the thread pool (a gate may take 50 ms), while the
/// owner polls. The squeezes of a session tell together how a gripper holds its force.
class InspectionJudge {
public:
    IdentificationOptions identification;
    VerdictOptions rates;
    std::optional<CommonShift> transfer; ///< the squeezes come from another gripper than the types

    struct Judged {
        Recording recording;
        Identification identification;
        Verdict verdict;
        VerdictOptions rates; ///< those in force when it began; they may be set anew meanwhile
    };

    /// UnitsDiffer: the recording cannot be compared with the types.
    [[nodiscard]] Expected<void> start(Recording recording, const ComparableTypes& types);
    /// What was found, once.
    [[nodiscard]] std::optional<Judged> take();
    void forget() { m_task.forget(); }

private:
    struct Found {
        Identification identification;
        Verdict verdict;
    };
    PoolTask<Found> m_task;
    HoldHistory m_holds;
    Recording m_measured; ///< what is being identified
    VerdictOptions m_ratesThen;
};

} // namespace gripscope
