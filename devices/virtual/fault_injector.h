// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "devices/address/fault_script.h"
#include "devices/protocol/report.h"

#include <deque>
#include <optional>

namespace gripscope {

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
