// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

#include <deque>

namespace gripscope {

/// Whether a link loses samples now: their share of the last seconds, by its counters. What was lost before
/// says nothing of how the link is.
class LossWatch {
public:
    static constexpr std::chrono::seconds window{5};
    /// Below it a measurement bears them: a report or two in five seconds at 2 kHz.
    static constexpr double bearableShare = 1e-3;

    /// To be called several times a second. Counters that fell are another link's.
    void look(const LinkCounters& counters, LinkCounters::TimePoint now);
    /// Of the samples that were due in the window; 0 as long as two looks are missing.
    [[nodiscard]] double share() const;
    [[nodiscard]] bool losing() const { return share() > bearableShare; }

private:
    struct Look {
        LinkCounters::TimePoint at;
        std::uint64_t samples = 0, lost = 0;
    };
    std::deque<Look> m_looks; ///< the first is the last one from before the window
};

} // namespace gripscope
