// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

// Recordings: what is read is in range, and reads again from what is written of it.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    CsvReadOptions given;
    given.forceColumn = QStringLiteral("u");
    given.positionColumn = QStringLiteral("y");
    given.sampleTime_s = 0.05;
    for (const CsvReadOptions& options : {CsvReadOptions(), given}) {
        const Expected<Recording> read = parseRecordingCsv(bytesOf(data, size), QStringLiteral("x"), options);
        if (!read) {
            require(read.error().describe().size() < 4000);
            continue;
        }
        require(!outOfRange(*read));
        const QByteArray written = toCsv(*read);
        const Expected<Recording> again = parseRecordingCsv(written, QStringLiteral("x"));
        require(again && *again == *read);
        require(toCsv(*again) == written);
    }
    return 0;
}
