// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/table_lines.h"
#include "core/clustering/feature_table.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>

// Tables: features of squeezes, and the lines and columns that every table is read by.

using namespace gripscope;
using namespace gripscope::fuzz;
using namespace Qt::StringLiterals;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray text = bytesOf(data, size);
    if (const auto lines = splitTable(text, u"x"_s))
        static_cast<void>(findTableColumns(*lines, {u"load"_s, u"reading"_s}, u"x"_s));
    if (const auto table = parseFeatureTable(text, u"x"_s, {u"m"_s, u"b"_s, u"k"_s}, u"object"_s))
        require(table->values.allFinite());
    return 0;
}
