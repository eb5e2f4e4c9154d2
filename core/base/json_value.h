// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonValue>
#include <QString>

#include <cmath>
#include <optional>

namespace gripscope {

/// JSON has no infinity and no NaN: a number that does not exist is null.
[[nodiscard]] inline QJsonValue jsonNumber(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}
[[nodiscard]] inline QJsonValue jsonNumber(const std::optional<double>& value)
{
    return value ? jsonNumber(*value) : QJsonValue(QJsonValue::Null);
}

/// [lower, upper], null where there is none.
[[nodiscard]] inline QJsonArray jsonInterval(const std::optional<double>& lower,
                                             const std::optional<double>& upper)
{
    return {jsonNumber(lower), jsonNumber(upper)};
}

/// A text that was not given is null in JSON, not an empty one.
[[nodiscard]] inline QJsonValue jsonText(const QString& text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

} // namespace gripscope
