// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/fault_script.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>

// Scripts of faults: their times are numbers in order, and any of them may be applied.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto events = parseFaultScript(bytesOf(data, size), QStringLiteral("x"));
    if (!events) {
        require(events.error().describe().size() < 4000);
        return 0;
    }
    FaultState state;
    double before_s = 0;
    for (const FaultEvent& event : *events) {
        require(std::isfinite(event.at_s) && event.at_s >= before_s);
        before_s = event.at_s;
        state.apply(event);
        for (unsigned id = 0; id < 256; ++id)
            static_cast<void>(state.deaf(static_cast<std::uint8_t>(id)));
    }
    require(std::isfinite(state.loss) && std::isfinite(state.clock_s));
    return 0;
}
