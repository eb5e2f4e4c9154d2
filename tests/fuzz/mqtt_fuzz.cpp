// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/outbox_file.h"
#include "devices/line/mqtt/sparkplug_payload.h"
#include "tests/fuzz/fuzzing.h"

// What a broker hands on from whoever may publish there, commands and the state of a host, and what a program
// before left in its file: any bytes are read to their end, and nothing is read out of order.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    static_cast<void>(decodedCommand(bytes));
    if (const std::optional<HostState> state = decodedHostState(bytes))
        require(state->timestamp >= 0);
    qsizetype end = 0;
    const OutboxFile::Contents contents = readOutbox(outboxHead() + bytes, end);
    require(end >= outboxHead().size() && end <= outboxHead().size() + bytes.size());
    std::uint64_t before = 0;
    for (const OutboxFile::Waiting& one : contents.waiting) {
        require(one.sequence >= before && one.sequence < contents.next);
        before = one.sequence + 1;
    }
    return 0;
}
