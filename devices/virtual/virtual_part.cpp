// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_part.h"

namespace gripscope {

namespace {

/// The part's and the gripper's own act on the same motion.
double frictionOf(const VirtualTerms& further)
{
    return further.friction_N + further.ownFriction_N;
}

MotionTerms termsOf(const VirtualTerms& further)
{
    MotionTerms terms;
    terms.friction = frictionOf(further) > 0;
    terms.relaxation = further.relaxingShare > 0;
    terms.cubic = further.cubic != 0;
    return terms;
}

MotionIntegrator<double>::Coefficients coefficientsOf(const MassDampingStiffness& object,
                                                      const VirtualTerms& further)
{
    using P = MotionParameter;
    MotionValues values;
    values[P::Mass] = object.m;
    values[P::Damping] = object.b;
    values[P::Stiffness] = object.k;
    values[P::Friction] = frictionOf(further);
    values[P::Relaxing] = further.relaxingShare * object.k;
    values[P::RelaxationTime] = further.relaxationTime_s;
    values[P::Cubic] = further.cubic;
    return values.values;
}

} // namespace

VirtualPart::VirtualPart(const MassDampingStiffness& object, const VirtualTerms& terms, double sampleTime_s)
    : m_object(object), m_sampleTime_s(sampleTime_s),
      m_step(discretize(object, sampleTime_s, ForceHold::Zero))
{
    if (!terms.any())
        return;
    m_motion.emplace(termsOf(terms), coefficientsOf(object, terms));
    m_motion->begin(0, 0, 0, 0);
}

bool VirtualPart::move(Integrator& motion, double duration_s, double force_N, int halvings)
{
    constexpr int mostHalvings = 12;
    const Integrator before = motion;
    if (motion.advance(duration_s, force_N, force_N))
        return true;
    // It follows some of the motion's own times at once; a slow gripper's sample may hold more.
    motion = before;
    return halvings < mostHalvings && move(motion, duration_s / 2, force_N, halvings + 1) &&
           move(motion, duration_s / 2, force_N, halvings + 1);
}

void VirtualPart::advance(double force_N)
{
    if (!m_motion) {
        m_state = (m_step.phi * m_state + m_step.gamma0 * force_N).eval();
        return;
    }
    Integrator next = *m_motion;
    m_lost = m_lost || !move(next, m_sampleTime_s, force_N);
    if (!m_lost)
        m_motion = next;
}

double VirtualPart::position_m() const
{
    return m_motion ? m_motion->position() : m_state[0];
}

double VirtualPart::positionAfter(double later_s, double force_N) const
{
    if (!(later_s > 0) || !(m_object.m > 0))
        return position_m();
    if (!m_motion) {
        const ExactStep<2> step = discretize(m_object, later_s, ForceHold::Zero);
        return (step.phi * m_state + step.gamma0 * force_N)[0];
    }
    Integrator then = *m_motion;
    return !m_lost && move(then, later_s, force_N) ? then.position() : m_motion->position();
}

} // namespace gripscope
