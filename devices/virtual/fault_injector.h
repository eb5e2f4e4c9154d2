// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/device_address.h"
#include "devices/protocol/report.h"
#include "devices/virtual/random_stream.h"

#include <deque>

namespace gripscope {

/// Loses, doubles and damages reports on their way. Stream reports and acknowledgements draw from generators
/// of their own, and the first from one a squeeze, so that what befalls a squeeze depends on its number and
/// the seed alone, not on how often the program repeated a command.
class FaultInjector {
public:
    FaultInjector(const VirtualFaults& faults, std::uint64_t seed);

    void beginSqueeze(std::uint64_t number);
    /// Puts what arrives of `report` into `wire`.
    void pass(const protocol::Report& report, std::deque<protocol::Report>& wire);

private:
    VirtualFaults m_faults;
    std::uint64_t m_seed;
    RandomStream m_stream;
    RandomStream m_acknowledgements;
};

} // namespace gripscope
