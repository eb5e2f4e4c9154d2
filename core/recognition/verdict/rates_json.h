// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json_value.h"
#include "core/recognition/verdict/verdict.h"

#include <QJsonObject>

namespace gripscope {

/// What a verdict is held to, by the names that the command line's documents and the audit trail have for it.
[[nodiscard]] inline QJsonObject toJson(const VerdictOptions& rates)
{
    return {{QStringLiteral("false_reject"), rates.falseReject},
            {QStringLiteral("wrong_type"), rates.wrongType},
            {QStringLiteral("stranger_accept"), rates.strangerAccept},
            {QStringLiteral("confidence"), jsonNumber(rates.confidence)},
            {QStringLiteral("robust"), rates.robust}};
}

} // namespace gripscope
