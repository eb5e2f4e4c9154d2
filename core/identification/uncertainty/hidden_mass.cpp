// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/uncertainty/uncertainty_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

using P = MotionParameter;

/// m k / b^2 of the masses that are tried: 0.25 is critical, 4 swings long. The first one is next to none.
constexpr std::array<double, 8> massShares{0.001, 0.05, 0.15, 0.25, 0.5, 1, 2, 4};
/// Factors of the damping, from a quarter to sixteen times.
constexpr int dampings = 49;
constexpr double leastFactor = 0.25, factorStep = 1.0905077326652577; // 2^(1/8)
/// Chi-square with one degree of freedom, 95 %.
constexpr double refutedBeyond = 3.841458820694124;
/// Of longer records a first part is as good: what is told of a mass is told at every change of the force.
constexpr std::size_t longest = 4000;

/// Holds a motion with a mass against the record: its offset is free.
class MassTrial {
public:
    MassTrial(const Estimate& estimate, const std::vector<double>& force, const std::vector<double>& position,
              const OutputErrorOptions& options)
        : m_motion(*estimate.motion)
    {
        const std::size_t count = std::min(force.size(), longest);
        m_force.assign(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(count));
        m_position.assign(position.begin(), position.begin() + static_cast<std::ptrdiff_t>(count));
        m_simulation = {options.sampleTime_s, options.hold, options.lag_s, estimate.nuisance.x0.value_or(0)};
    }

    [[nodiscard]] double sumOfSquares(double b, double massShare) const
    {
        const double k = m_motion.values[P::Stiffness];
        const std::vector<double> x = simulate({massShare * b * b / k, b, k}, m_force, m_simulation);
        double count = 0, sum = 0, squares = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (m_motion.influences.row(static_cast<Eigen::Index>(i)).isZero(0))
                continue;
            const double error = m_position[i] - x[i];
            ++count;
            const double delta = error - sum;
            sum += delta / count; // the mean so far
            squares += delta * (error - sum);
        }
        return count > 0 && std::isfinite(squares) ? squares : std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] double samples() const { return static_cast<double>(m_force.size()); }

private:
    const MotionEstimate& m_motion;
    std::vector<double> m_force, m_position;
    SimulationOptions m_simulation;
};

} // namespace

std::optional<MotionValues> hiddenMassShift(const Estimate& estimate, const std::vector<double>& force,
                                            const std::vector<double>& position,
                                            const OutputErrorOptions& options)
{
    if (!estimate.motion || estimate.motion->terms != damperAndSpring || force.size() != position.size() ||
        estimate.motion->influences.rows() != static_cast<Eigen::Index>(force.size()))
        return std::nullopt;
    const MassTrial trial(estimate, force, position, options);
    const double b0 = estimate.motion->values[P::Damping];
    std::vector<std::pair<double, double>> tried; // damping, sum of squares
    double best = std::numeric_limits<double>::infinity();
    for (const double share : massShares) {
        double b = leastFactor * b0;
        for (int i = 0; i < dampings; ++i, b *= factorStep) {
            tried.emplace_back(b, trial.sumOfSquares(b, share));
            best = std::min(best, tried.back().second);
        }
    }
    if (!(best > 0) || !std::isfinite(best))
        return std::nullopt;
    double farthest = 0;
    for (const auto& [b, squares] : tried)
        if (trial.samples() * std::log(squares / best) <= refutedBeyond)
            farthest = std::max(farthest, std::abs(b - b0));
    MotionValues shift;
    shift[P::Damping] = farthest / std::numbers::sqrt3; // all alike
    return shift;
}

} // namespace gripscope
