// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/excitation/force_levels.h"
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>
#include <optional>

// Recordings: what is read is in range, and reads again from what is written of it. Forces to be squeezed
// with are read from the same bytes: each level is within the peak, and there are not too many.

using namespace gripscope;
using namespace gripscope::fuzz;

namespace {

void readForce(const QByteArray& text)
{
    for (const std::optional<double> step_s : {std::optional<double>(), std::optional(0.01)}) {
        const Expected<ForceLevels> force = parseForceLevels(text, QStringLiteral("x"), step_s);
        if (!force) {
            require(force.error().describe().size() < 4000);
            continue;
        }
        require(force->levels.size() <= mostLevels && force->peak > 0 && force->bit_s > 0);
        for (const double level : force->levels)
            require(std::abs(level) <= 1);
        require(std::isfinite(force->bias) && std::isfinite(force->peak));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    readForce(bytesOf(data, size));
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
