// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/foreign_table.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

// Tables of other programs: what is proposed can be read or is refused in words, and what is read is in range
// and reads again from what is written of it.

using namespace gripscope;
using namespace gripscope::fuzz;

namespace {

void readAs(const QByteArray& text, CsvReadOptions options)
{
    if (!options.columns->time)
        options.sampleTime_s = 0.01;
    const Expected<Recording> read = parseRecordingCsv(text, QStringLiteral("x"), options);
    if (!read) {
        require(read.error().describe().size() < 4000);
        return;
    }
    require(!outOfRange(*read));
    const Expected<Recording> again = parseRecordingCsv(toCsv(*read), QStringLiteral("x"));
    require(again && *again == *read);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray text = tableText(bytesOf(data, size));
    CsvFormat odd;
    odd.delimiter = ';';
    odd.decimalMark = ',';
    odd.skippedLines = size % 4;
    odd.header = size % 2 == 0;
    odd.linesBelow = size % 3;
    for (const std::optional<CsvFormat>& given : {std::optional<CsvFormat>(), std::optional(odd)}) {
        const Expected<ForeignTable> table = examineTable(text, QStringLiteral("x"), given);
        if (!table)
            continue;
        require(table->columns.size() >= 2 && table->units.size() == table->columns.size());
        require(layoutKey(*table).size() == 32);
        const CsvReadOptions options = proposedReading(*table);
        require(options.columns && options.columns->force != options.columns->position);
        readAs(text, options);
    }
    return 0;
}
