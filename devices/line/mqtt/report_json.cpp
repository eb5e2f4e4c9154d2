// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/report_json.h"

#include "core/base/words.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int reportVersion = 1;
constexpr std::array<const char*, 3> quantityNames{"mass", "damping", "stiffness"};

QJsonValue textOrNull(const QString& text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

QJsonValue quantityJson(const std::optional<LineQuantity>& quantity)
{
    if (!quantity)
        return {};
    const auto& uncertainty = quantity->standardUncertainty;
    return QJsonObject{{u"value"_s, quantity->value},
                       {u"standardUncertainty"_s, uncertainty ? QJsonValue(*uncertainty) : QJsonValue()}};
}

std::optional<LineQuantity> quantityFrom(const QJsonValue& json)
{
    if (!json.isObject())
        return {};
    LineQuantity quantity{json["value"_L1].toDouble(), {}};
    if (json["standardUncertainty"_L1].isDouble())
        quantity.standardUncertainty = json["standardUncertainty"_L1].toDouble();
    return quantity;
}

QJsonValue clockJson(const std::optional<ClockStanding>& clock)
{
    return clock ? QJsonObject{{u"offset"_s, clock->offset_s}, {u"dispersion"_s, clock->dispersion_s}}
                 : QJsonValue();
}

std::optional<ClockStanding> clockFrom(const QJsonValue& json)
{
    if (!json["offset"_L1].isDouble() || !json["dispersion"_L1].isDouble())
        return {};
    return ClockStanding{json["offset"_L1].toDouble(), json["dispersion"_L1].toDouble()};
}

/// The one of 0 to `last` that is called so.
template <typename Word>
std::optional<Word> wordNamed(const QJsonValue& name, Word last)
{
    for (int i = 0; i <= static_cast<int>(last); ++i)
        if (toString(static_cast<Word>(i)) == name.toString())
            return static_cast<Word>(i);
    return {};
}

} // namespace

QByteArray reportJson(const LineReport& report, bool historical)
{
    const LineResult& result = report.result;
    QJsonObject json{{u"version"_s, reportVersion},
                     {u"sequence"_s, static_cast<qint64>(report.sequence)},
                     {u"historical"_s, historical},
                     {u"time"_s, result.utc.toUTC().toString(Qt::ISODateWithMs)},
                     {u"clock"_s, clockJson(report.clock)},
                     {u"gripper"_s, report.gripper},
                     {u"part"_s, textOrNull(report.part)},
                     {u"expectedType"_s, textOrNull(report.expectedType)},
                     {u"type"_s, textOrNull(report.typeFound)},
                     {u"state"_s, toString(result.state)},
                     {u"evaluation"_s, toString(result.evaluation)},
                     {u"reason"_s, toString(result.reason)},
                     {u"partial"_s, result.partial},
                     {u"simulated"_s, result.simulated}};
    for (std::size_t i = 0; i < quantityNames.size(); ++i)
        json.insert(QLatin1StringView(quantityNames[i]), quantityJson(result.quantities[i]));
    return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

Expected<LineReport> reportFromJson(const QByteArray& bytes)
{
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    LineReport report;
    report.sequence = static_cast<quint64>(json["sequence"_L1].toInteger());
    report.gripper = json["gripper"_L1].toString();
    report.part = json["part"_L1].toString();
    report.expectedType = json["expectedType"_L1].toString();
    report.typeFound = json["type"_L1].toString();
    LineResult& result = report.result;
    result.utc = QDateTime::fromString(json["time"_L1].toString(), Qt::ISODateWithMs);
    const auto state = wordNamed(json["state"_L1], ResultState::Failed);
    const auto evaluation = wordNamed(json["evaluation"_L1], ResultEvaluation::NotDecidable);
    const auto reason = wordNamed(json["reason"_L1], ResultReason::NotMeasured);
    if (json["version"_L1].toInt() != reportVersion || report.sequence == 0 || !result.utc.isValid() ||
        !state || !evaluation || !reason)
        return failure(ErrorCode::StorageCorrupt,
                       {Words::say("A result that waits for the broker"), Words::say("it cannot be read")});
    report.clock = clockFrom(json["clock"_L1]);
    result.state = *state;
    result.evaluation = *evaluation;
    result.reason = *reason;
    result.partial = json["partial"_L1].toBool();
    result.simulated = json["simulated"_L1].toBool();
    for (std::size_t i = 0; i < quantityNames.size(); ++i)
        result.quantities[i] = quantityFrom(json[QLatin1StringView(quantityNames[i])]);
    return report;
}

} // namespace gripscope
