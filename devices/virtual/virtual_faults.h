// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "devices/address/fault_script.h"
#include "devices/protocol/report.h"

#include <algorithm>
#include <deque>
#include <optional>

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

/// What became of the reports that a device wanted to send.
struct FaultCounts {
    std::uint64_t samples = 0;          ///< in stream reports, counted one by one
    std::optional<std::uint64_t> first; ///< the number of the first of them, as the device gives it
    std::uint64_t last = 0;             ///< and of the last
    std::uint64_t lostSamples = 0;      ///< of them, in reports that did not arrive or arrived damaged
    std::uint64_t damagedReports = 0;   ///< arrived with a bit flipped; twice when doubled
    std::uint64_t duplicateReports = 0; ///< stream reports that arrived whole a second time
};

/// Loses, doubles and damages reports on their way. Stream reports and acknowledgements draw from generators
/// of their own, and the first from one a squeeze, so that what befalls a squeeze depends on its number and
/// the seed alone, not on how often the program repeated a command.
class FaultInjector {
public:
    explicit FaultInjector(std::uint64_t seed);

    void beginSqueeze(std::uint64_t number);
    /// Puts what arrives of `report` into `wire`.
    void pass(const protocol::Report& report, const FaultState& faults, std::deque<protocol::Report>& wire);
    /// The report is lost, whatever the faults are.
    void lose(const protocol::Report& report);
    [[nodiscard]] const FaultCounts& counts() const { return m_counts; }

private:
    std::uint64_t countSent(const protocol::Report& report); ///< the samples in it

    std::uint64_t m_seed;
    RandomStream m_stream;
    RandomStream m_acknowledgements;
    FaultCounts m_counts;
};

} // namespace gripscope
