// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/codec.h"
#include "devices/protocol/stream_assembler.h"
#include "devices/replay/capture.h"
#include "devices/virtual/virtual_firmware.h"

#include <QString>

#include <cmath>
#include <cstdlib>

// Whatever bytes come, from a device or a program: no crash, no report read beyond its end, nothing that is
// not finite, time and numbers that only grow, and no force on a gripper that is not armed.
//
// The input is cut into pieces of 64 bytes. Each is decoded as it is; and once more with its CRC and version
// put right, since hardly any would pass otherwise.

namespace {

using namespace gripscope;
using namespace gripscope::protocol;

void require(bool holds)
{
    if (!holds)
        std::abort();
}

void decodeAll(ReportView bytes, StreamAssembler& assembler, std::vector<Sample>& samples)
{
    if (const auto input = decodeInput(bytes)) {
        if (const auto* stream = std::get_if<StreamReport>(&*input)) {
            static_cast<void>(assembler.take(*stream, samples));
            require(decodeInput(encode(*stream)) == InputMessage(*stream));
        } else {
            const Acknowledgement answer = std::get<Acknowledgement>(*input);
            require(decodeInput(encode(answer)) == InputMessage(answer));
        }
    }
    if (const auto command = decodeCommand(bytes))
        require(decodeCommand(encode(*command)) == *command);
    if (const auto measurement = decodeMeasurement(bytes))
        require(decodeMeasurement(encode(*measurement)) == *measurement);
    if (const auto limits = decodeLimits(bytes))
        require(decodeLimits(encode(*limits)) == *limits);
    static_cast<void>(decodeIdentity(bytes));
}

void checkSamples(const std::vector<Sample>& samples)
{
    for (std::size_t i = 0; i < samples.size(); ++i) {
        require(std::isfinite(samples[i].time_s) && std::isfinite(samples[i].force));
        require(std::isfinite(samples[i].position));
        require(i == 0 || samples[i].sequence > samples[i - 1].sequence);
    }
}

void takeSamples(VirtualFirmware& firmware, std::uint64_t& now_us, int count)
{
    for (int i = 0; i < count; ++i) {
        now_us += 500;
        firmware.sample(now_us);
    }
    for (const Report& report : firmware.outbox()) {
        const auto message = decodeInput(report);
        require(message.has_value());
        const auto* stream = std::get_if<StreamReport>(&*message);
        if (stream && (stream->status & StatusMoving))
            require(stream->status & StatusArmed);
    }
    firmware.outbox().clear();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const ReportView all(data, size);
    static_cast<void>(
        parseCapture(QByteArray(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size)),
                     QStringLiteral("fuzz")));
    VirtualFirmwareOptions options;
    options.object = VirtualObject::exactly({0.04, 43, 9990});
    VirtualFirmware firmware(options);
    StreamAssembler assembler(0.001, 20e-6, 0.0005);
    std::vector<Sample> samples;
    std::uint64_t now_us = 0;
    for (std::size_t first = 0; first < size; first += reportSize) {
        const ReportView piece = all.subspan(first, std::min(reportSize, size - first));
        decodeAll(piece, assembler, samples);
        firmware.receive(piece, now_us);
        Report repaired{};
        std::copy(piece.begin(), piece.end(), repaired.begin());
        seal(repaired);
        decodeAll(repaired, assembler, samples);
        firmware.receive(repaired, now_us);
        takeSamples(firmware, now_us, 10);
    }
    checkSamples(samples);
    return 0;
}
