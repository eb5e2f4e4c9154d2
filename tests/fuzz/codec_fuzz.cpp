// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/packed_recording.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

// Recordings as the library keeps them: what is decoded is in range and encodes to the same bytes.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Expected<Recording> read = decodeRecording(bytesOf(data, size));
    if (!read) {
        require(read.error().code == ErrorCode::StorageCorrupt);
        return 0;
    }
    require(!outOfRange(*read));
    const Expected<QByteArray> written = encodeRecording(*read);
    require(written.has_value());
    const Expected<Recording> again = decodeRecording(*written);
    require(again && *again == *read);
    const Expected<QByteArray> series = encodeInSeries(*read);
    const Expected<Recording> unpacked = series.has_value() ? decodeRecording(*series) : read;
    require(series && unpacked && encodeRecording(*unpacked) == written);
    return 0;
}
