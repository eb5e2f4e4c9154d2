// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/repeated_measurement.h"
#include "core/session/judged_series.h"

namespace gripscope {

/// Measures m, b, k of the empty gripper on some squeezes of nothing, and keeps them in the library as a
/// property of that gripper: they are taken off what later squeezes show (withoutGripper()).
///
/// Measured: baseline() or problem(). accept() stores it and puts it in force for the squeezes to come. What
/// else is known of the gripper's channels stays as it is.
class BaselineSession : public JudgedSeries<Identification> {
public:
    static constexpr int usualSqueezes = 5;

    BaselineSession(ConnectSession& connection, LibraryService& library);

    [[nodiscard]] Expected<void> start(const Recipe& recipe, int squeezes = usualSqueezes);
    /// Usage: nothing was measured, or not well enough to be used.
    [[nodiscard]] Expected<void> accept();
    /// Nothing is taken off any more. Usage: busy, or there is no baseline.
    [[nodiscard]] Expected<void> remove();

    /// In the channels' units. Its errors are those of the squeezes' noise and scatter alone: what the
    /// channels are uncertain by is common to it and to the part, and counted there.
    [[nodiscard]] const std::optional<GripperBaseline>& baseline() const { return m_baseline; }
    [[nodiscard]] const QString& problem() const { return m_problem; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    void conclude() override;

    std::optional<GripperBaseline> m_baseline;
    QString m_problem;
};

} // namespace gripscope
