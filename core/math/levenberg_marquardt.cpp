// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/levenberg_marquardt.h"

#include <algorithm>

namespace gripscope {

SearchEnd LevenbergMarquardt::minimise(int maxIterations)
{
    m_end = {};
    while (m_end.iterations < maxIterations && prepare()) {
        if (hasArrived()) {
            if (refresh())
                continue;
            m_end.outcome = SearchOutcome::Converged;
            break;
        }
        ++m_end.iterations;
        if (isLostInRounding()) {
            if (polish() || refresh())
                continue;
            m_end.outcome = SearchOutcome::Converged;
            break;
        }
        if (!improve()) {
            stall();
            break;
        }
    }
    if (m_end.outcome == SearchOutcome::NotConverged && finite())
        markUndetermined();
    return m_end;
}

double LevenbergMarquardt::residualDeviation() const
{
    return std::sqrt(cost() / degreesOfFreedom());
}

bool LevenbergMarquardt::hasArrived() const
{
    const double floor = search::rounding * std::sqrt(m_size / degreesOfFreedom());
    return toGo() <= m_arrived * residualDeviation() + floor;
}

bool LevenbergMarquardt::improve()
{
    return improveByDamping() && !runsAway();
}

bool LevenbergMarquardt::improveByDamping()
{
    for (; m_damping < search::largestDamping; m_damping *= 10) {
        const Step step = dampedStep(m_damping);
        if (!step.allFinite())
            continue;
        const double before = cost();
        if (!accept(step)) {
            if (refresh())
                m_damping /= 10; // the same again
            continue;
        }
        m_gain = before - cost();
        m_damping = std::max(m_damping / 10, search::smallestDamping);
        return true;
    }
    return false;
}

/// The cost stands still while a logarithm keeps going.
bool LevenbergMarquardt::runsAway()
{
    const double noise = search::rounding * (cost() + search::rounding * m_size);
    m_idle = m_gain < noise ? m_idle + 1 : 0;
    return m_idle >= 3;
}

/// No step lowers the cost any more: rounding, the end of a valley, or a runaway.
void LevenbergMarquardt::stall()
{
    const Logarithms step = logarithmsOf(dampedStep(0));
    Eigen::Index index = 0;
    const double longest = step.cwiseAbs().maxCoeff(&index);
    if (std::isfinite(longest) && longest > search::runaway) {
        m_end.outcome = SearchOutcome::Boundary;
        m_end.boundaryIndex = static_cast<int>(index);
        m_end.boundaryAtZero = step(index) < 0;
    } else if (toGo() < nearEnough() * residualDeviation() || cost() < search::rounding * m_size ||
               longest < 1e-10) {
        m_end.outcome = SearchOutcome::Converged;
    }
}

/// A search that goes on and on along a valley ends for want of data, not of iterations: there the standard
/// error of a logarithm is above `undetermined`.
void LevenbergMarquardt::markUndetermined()
{
    Eigen::Index index = 0;
    const double largest = residualDeviation() * logarithmDeviations().maxCoeff(&index);
    if (largest <= search::undetermined)
        return;
    m_end.outcome = SearchOutcome::Boundary;
    m_end.boundaryIndex = static_cast<int>(index);
    m_end.boundaryAtZero = true;
}

} // namespace gripscope
