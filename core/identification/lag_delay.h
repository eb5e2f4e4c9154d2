// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lag_alignment.h"
#include "core/identification/recursive_pass.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

namespace gripscope {

/// Takes the whole samples of a lag between two channels out as they come: each position with the force at
/// its time, or the rest of a sample before it, and the forces beside that. It waits for as many samples as
/// that needs.
class LagDelay {
public:
    struct Sample {
        RecursivePass::Forces forces;
        double position;
    };

    LagDelay() : LagDelay({}, ForceHold::Zero) {}
    LagDelay(const LagAlignment& lag, ForceHold hold)
    {
        // Longer than any squeeze: nothing ever comes out.
        constexpr std::ptrdiff_t longest = 1'000'000;
        m_lag = std::clamp(lag.samples, -longest, longest);
        const std::ptrdiff_t forceAhead = hold == ForceHold::First && lag.rest > 0 ? 1 : 0;
        m_delay = std::max({forceAhead, -m_lag, std::ptrdiff_t(0)});
        const std::ptrdiff_t reach = m_delay + std::max(m_lag, std::ptrdiff_t(1)) + 1;
        const std::size_t size =
            std::bit_ceil(static_cast<std::size_t>(reach)); // a mask is faster than a division
        m_forces.resize(size);
        m_positions.resize(size);
    }

    /// What is complete now that this sample is known.
    std::optional<Sample> push(double force, double position)
    {
        at(m_forces, m_count) = force;
        at(m_positions, m_count) = position;
        const std::ptrdiff_t forceIndex = m_count - m_delay, positionIndex = forceIndex - m_lag;
        ++m_count;
        if (forceIndex < 0 || positionIndex < 0)
            return std::nullopt;
        const double now = at(m_forces, forceIndex);
        return Sample{{forceIndex > 0 ? at(m_forces, forceIndex - 1) : now, now,
                       at(m_forces, std::min(forceIndex + 1, m_count - 1))},
                      at(m_positions, positionIndex)};
    }

private:
    [[nodiscard]] static double& at(std::vector<double>& ring, std::ptrdiff_t index)
    {
        return ring[static_cast<std::size_t>(index) & (ring.size() - 1)];
    }

    std::ptrdiff_t m_lag = 0, m_delay = 0, m_count = 0;
    std::vector<double> m_forces, m_positions;
};

} // namespace gripscope
