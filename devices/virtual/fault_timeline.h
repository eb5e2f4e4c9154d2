// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/fault_script.h"

#include <algorithm>

namespace gripscope {

/// Faults as they come and go. Not a clock: who owns it says how late it is.
class FaultTimeline {
public:
    /// `events` in order of time.
    explicit FaultTimeline(std::vector<FaultEvent> events = {}) : m_events(std::move(events)) {}

    /// Takes in all events up to `time_s`; time runs forward only.
    void advanceTo(double time_s)
    {
        for (; m_next < m_events.size() && m_events[m_next].at_s <= time_s; ++m_next)
            m_state.apply(m_events[m_next]);
    }
    [[nodiscard]] const FaultState& state() const { return m_state; }

    /// When the gripper comes back, if it does.
    [[nodiscard]] std::optional<double> nextReplug_s() const
    {
        const auto found =
            std::find_if(m_events.begin() + static_cast<std::ptrdiff_t>(m_next), m_events.end(),
                         [](const FaultEvent& event) { return event.fault == Fault::Replug; });
        return found == m_events.end() ? std::nullopt : std::optional(found->at_s);
    }

private:
    std::vector<FaultEvent> m_events;
    std::size_t m_next = 0;
    FaultState m_state;
};

} // namespace gripscope
