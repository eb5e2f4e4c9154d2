// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/conformity_json.h"
#include "tests/fuzz/fuzzing.h"

#include <QJsonDocument>

// Tolerance limits and decisions by them, as a library holds them.

using namespace gripscope;
using namespace gripscope::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    if (const auto limits = partLimitsFromText(QString::fromUtf8(bytes)); limits && !limits->isEmpty()) {
        require(!limits->validate());
        require(partLimitsFromText(toText(*limits)).has_value());
        const MeasuredValue one{12, 0.1};
        require(judgeConformity(*limits, {one, one, one}).has_value());
    }
    const QJsonObject document = QJsonDocument::fromJson(bytes).object();
    if (const auto conformity = conformityFromJson(document)) {
        require(!inWords(*conformity).english().isEmpty());
        require(conformityFromJson(conformityJson(*conformity)).has_value());
    }
    return 0;
}
