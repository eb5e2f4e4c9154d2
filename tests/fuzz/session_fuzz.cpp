// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_limits.h"
#include "devices/protocol/report.h"
#include "devices/replay/capture.h"
#include "devices/replay/capture_folder.h"
#include "devices/replay/captured_session.h"
#include "tests/fuzz/fuzzing.h"

#include <cstring>

// Whole captures, cut into squeezes: as they are, and with the CRC of every report put right, since hardly
// any other report would be read.

using namespace gripscope;
using namespace gripscope::fuzz;

namespace {

/// The records of `bytes` with their reports sealed, as far as they are whole.
QByteArray sealed(QByteArray bytes)
{
    constexpr qsizetype header = 8;
    for (qsizetype at = header; at + captureRecordHead <= bytes.size();) {
        std::uint16_t kind = 0, length = 0;
        std::memcpy(&kind, bytes.constData() + at + 8, 2);
        std::memcpy(&length, bytes.constData() + at + 10, 2);
        at += captureRecordHead;
        if (at + length > bytes.size())
            break;
        if (kind != static_cast<std::uint16_t>(CaptureKind::Note) && length == protocol::reportSize) {
            protocol::Report report{};
            std::memcpy(report.data(), bytes.constData() + at, report.size());
            protocol::seal(report);
            std::memcpy(bytes.data() + at, report.data(), report.size());
        }
        at += length;
    }
    return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FuzzFile file(QStringLiteral("x.gscap"));
    const QByteArray bytes = bytesOf(data, size);
    for (const QByteArray& capture : {bytes, sealed(bytes)}) {
        file.write(capture);
        const Expected<CapturedSession> session = readCapturedSession(file.path());
        if (!session) {
            require(session.error().describe().size() < 4000);
            continue;
        }
        for (const CapturedSqueeze& squeeze : session->squeezes)
            require(squeeze.recording.size() <= session->counters.samples);
    }
    return 0;
}
