// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/descriptor_words.h"
#include "devices/protocol/report_words.h"
#include "tests/fuzz/fuzzing.h"

// What the inspector shows of a report descriptor and of a report.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    require(protocol::descriptorInWords({data, size}).size() <= size);
    static_cast<void>(protocol::reportInWords({data, size}));
    static_cast<void>(protocol::hexDump({data, size}));
    return 0;
}
