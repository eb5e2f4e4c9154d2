// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/identification/motion/motion_integrator.h"
#include "devices/address/virtual_object.h"

#include <Eigen/Core>

#include <optional>

namespace gripscope {

/// What is between the virtual gripper's fingers, from rest at the contact point:
///     m x'' + b x' + k x + k3 x^3 + k1 (x - q) + Fc s(x') = F,   tau q' = x - q,
/// Fc that of the part and of the gripper together. Without further terms the exact steps of a linear motion,
/// else MotionIntegrator, which the estimators use too: how true they are is not told by this part but by
/// `study truth`, whose simulator is its own.
class VirtualPart {
public:
    VirtualPart() = default; ///< nothing that moves
    VirtualPart(const MassDampingStiffness& object, const VirtualTerms& terms, double sampleTime_s);

    /// One sample time on, under a force that is held.
    void advance(double force_N);
    [[nodiscard]] double position_m() const;
    /// Where it would be `later_s` (0 to a sample time) from now, under a force that is held.
    [[nodiscard]] double positionAfter(double later_s, double force_N) const;

private:
    using Integrator = MotionIntegrator<double>;
    /// False where the motion left all bounds: there it stays.
    static bool move(Integrator& motion, double duration_s, double force_N, int halvings = 0);

    MassDampingStiffness m_object;
    double m_sampleTime_s = 0;
    ExactStep<2> m_step;
    Eigen::Vector2d m_state = Eigen::Vector2d::Zero(); ///< position and speed, SI
    std::optional<Integrator> m_motion;                ///< with further terms, in place of the above
    bool m_lost = false;
};

} // namespace gripscope
