// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_registers.h"
#include "tests/fuzz/fuzzing.h"

// What a PLC, or whoever reaches its port, sends to a station that answers each job at once: every frame has
// an answer of its own length at the most, and a result is the one of its job.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto desk = std::make_shared<SharedJobDesk>(1);
    LineRegisters registers(desk);
    desk->with([](JobDesk& known) { known.setStation({LineState::Ready, true, false, 3}); });
    std::span<const std::uint8_t> stream(data, size);
    ModbusFrame frame;
    while (nextFrame(stream, frame) == FrameState::Whole) {
        require(frame.bytes > 0 && frame.bytes <= stream.size());
        require(framed(frame, answerPdu(frame.pdu, registers)).size() <= 260);
        stream = stream.subspan(frame.bytes);
        desk->with([](JobDesk& known) {
            const auto now = std::chrono::steady_clock::now();
            const std::optional<LineJob> job = known.takeJob();
            if (!job)
                return;
            require(job->trigger != 0 && job->type <= 3);
            require(!known.view(now).unread); // none is taken before it was acknowledged
            known.finish({}, now);
            require(known.view(now).result->job == *job);
        });
    }
    return 0;
}
