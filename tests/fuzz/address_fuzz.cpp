// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/device_address.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>

// Addresses of grippers, as they are typed.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto address = parseDeviceAddress(QString::fromUtf8(bytesOf(data, size)));
    if (!address) {
        require(address.error().describe().size() < 4000);
        return 0;
    }
    if (const auto* virtualOne = std::get_if<VirtualAddress>(&*address)) {
        require(virtualOne->speed >= 0 && virtualOne->speed <= 100);
        for (const FaultEvent& event : virtualOne->faults)
            require(std::isfinite(event.at_s));
    }
    return 0;
}
