// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/identification/identification.h"
#include "core/identification/lag/lag_estimation.h"
#include "core/session/squeeze/series_session.h"

#include <optional>

namespace gripscope {

/// Measures the empty gripper on some squeezes of nothing: m, b, k, the friction of its drive and the noise
/// of its force at rest, and keeps them in the library as properties of that gripper: m, b and k are taken
/// off what later squeezes show (withoutGripper()), its friction is known to them
/// (MotionOptions::knownFriction). A gripper that nothing holds back has no k (`carriage`).
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
    [[nodiscard]] const std::optional<GripperFriction>& friction() const { return m_friction; }
    /// Standard deviation, in the force's unit; 0: no squeeze had enough rest before it.
    [[nodiscard]] double forceNoise() const { return m_forceNoise; }
    [[nodiscard]] const QString& problem() const { return m_problem; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    void conclude() override;

    std::optional<GripperBaseline> m_baseline;
    std::optional<GripperFriction> m_friction;
    double m_forceNoise = 0;
    QString m_problem;
};

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
