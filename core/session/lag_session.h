// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lag_estimation.h"
#include "core/session/judged_series.h"

namespace gripscope {

/// Measures how much later a gripper's position channel samples than its force channel, on some squeezes of
/// one firm object, and keeps it in the library as a property of that gripper.
///
/// Measured holds result(); accept() stores it and puts it in force for the squeezes to come. What else is
/// known of the gripper's channels stays as it is.
class LagSession : public JudgedSeries<LagEstimate> {
public:
    static constexpr int usualSqueezes = 5;

    LagSession(ConnectSession& connection, LibraryService& library);

    [[nodiscard]] Expected<void> start(const Recipe& recipe, int squeezes = usualSqueezes);
    /// Usage: nothing was measured, or not well enough to be used.
    [[nodiscard]] Expected<void> accept();

    [[nodiscard]] const LagEstimate& result() const { return m_result; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    void conclude() override;

    LagEstimate m_result;
};

/// The lag of one squeeze, prepared as identify() would.
[[nodiscard]] LagEstimate estimateLag(const Recording& recording);

} // namespace gripscope
