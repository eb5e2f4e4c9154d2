// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/session/squeeze/series_session.h"

namespace gripscope {

/// How far frame and fingers give way, in series with the object: position unit per force unit.
struct FrameCompliance {
    double value = 0;
    double standardError = 0;
};

/// Measures the compliance of frame and fingers on some squeezes of a rigid block, and keeps it in the
/// library as a property of that gripper: what it gives way is taken off the position of every later squeeze.
///
/// Of a block that does not give way the stiffness that is found, k, is the frame's, and the compliance 1 / k
/// (to first order with the standard error u(k) / k^2). A steel gauge block of 1 cm^2 and 20 mm has 1000
/// N/um: its own share is a thousandth of what a frame of 1 N/um gives.
///
/// Measured: compliance() or problem(). accept() stores it and puts it in force for the squeezes to come.
/// What else is known of the gripper's channels stays as it is.
class FrameSession : public JudgedSeries<Identification> {
public:
    static constexpr int usualSqueezes = 5;

    FrameSession(ConnectSession& connection, LibraryService& library);

    [[nodiscard]] Expected<void> start(const Recipe& recipe, int squeezes = usualSqueezes);
    /// Usage: nothing was measured, or not well enough to be used.
    [[nodiscard]] Expected<void> accept();

    [[nodiscard]] const std::optional<FrameCompliance>& compliance() const { return m_compliance; }
    [[nodiscard]] const QString& problem() const { return m_problem; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    void conclude() override;

    std::optional<FrameCompliance> m_compliance;
    QString m_problem;
};

} // namespace gripscope
