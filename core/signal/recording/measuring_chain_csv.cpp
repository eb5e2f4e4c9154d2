// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/measuring_chain_csv.h"

#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/signal/recording/recording_limits.h"

#include <array>
#include <charconv>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct NumberKey {
    std::string_view key;
    double MeasuringChain::*member;
};
constexpr std::array<NumberKey, 6> numberKeys{{
    {"force_lag_uncertainty_s", &MeasuringChain::forceLagUncertainty_s},
    {"force_noise", &MeasuringChain::forceNoiseDeviation},
    {"force_scale_uncertainty", &MeasuringChain::forceScaleUncertainty},
    {"position_scale_uncertainty", &MeasuringChain::positionScaleUncertainty},
    {"frame_compliance", &MeasuringChain::frameCompliance},
    {"frame_compliance_uncertainty", &MeasuringChain::frameComplianceUncertainty},
}};

struct FrictionKey {
    std::string_view key;
    double GripperFriction::*member;
};
constexpr std::array<FrictionKey, 2> frictionKeys{{
    {"friction", &GripperFriction::value},
    {"friction_uncertainty", &GripperFriction::standardError},
}};

struct TripleKey {
    std::string_view key;
    std::array<double, 3> GripperBaseline::*member;
};
constexpr std::array<TripleKey, 2> tripleKeys{{
    {"baseline", &GripperBaseline::parameters},
    {"baseline_uncertainty", &GripperBaseline::standardErrors},
}};

std::optional<double> fromZeroUp(std::string_view text)
{
    const std::optional<double> value = parseNumber(text);
    return value && *value >= 0 && isReading(*value) ? value : std::nullopt;
}

std::optional<std::array<double, 3>> parseTriple(std::string_view text)
{
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == values.size()))
            return std::nullopt;
        const std::optional<double> value = fromZeroUp(text.substr(0, comma));
        if (!value)
            return std::nullopt;
        values[i] = *value;
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    return values;
}

void append(QByteArray& text, double value)
{
    std::array<char, 32> buffer; // the longest double has 24 characters
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), result.ptr - buffer.data());
}

void appendKey(QByteArray& text, std::string_view key)
{
    text += "# ";
    text.append(key.data(), static_cast<qsizetype>(key.size()));
    text += ": ";
}

void appendLine(QByteArray& text, std::string_view key, double value)
{
    appendKey(text, key);
    append(text, value);
    text += '\n';
}

} // namespace

ChainSetting setMeasuringChain(MeasuringChain& chain, std::string_view key, std::string_view value)
{
    for (const NumberKey& known : numberKeys) {
        if (key != known.key)
            continue;
        const std::optional<double> number = fromZeroUp(value);
        if (!number)
            return ChainSetting::BadValue;
        chain.*known.member = *number;
        return ChainSetting::Taken;
    }
    for (const FrictionKey& known : frictionKeys) {
        if (key != known.key)
            continue;
        const std::optional<double> number = fromZeroUp(value);
        if (!number)
            return ChainSetting::BadValue;
        if (!chain.friction)
            chain.friction.emplace();
        (*chain.friction).*known.member = *number;
        return ChainSetting::Taken;
    }
    for (const TripleKey& known : tripleKeys) {
        if (key != known.key)
            continue;
        const std::optional<std::array<double, 3>> triple = parseTriple(value);
        if (!triple)
            return ChainSetting::BadValue;
        if (!chain.baseline)
            chain.baseline.emplace();
        (*chain.baseline).*known.member = *triple;
        return ChainSetting::Taken;
    }
    return ChainSetting::NoSuchKey;
}

Finding measuringChainExpectation(std::string_view key)
{
    for (const TripleKey& known : tripleKeys) {
        if (key == known.key)
            return Words::say("expected three numbers from 0 to %1 with commas between: m,b,k")
                .arg(largestReading);
    }
    return Words::say("expected a number from 0 to %1").arg(largestReading);
}

QByteArray measuringChainLines(const MeasuringChain& chain)
{
    QByteArray text;
    for (const NumberKey& known : numberKeys) {
        if (chain.*known.member != 0)
            appendLine(text, known.key, chain.*known.member);
    }
    if (chain.friction)
        for (const FrictionKey& known : frictionKeys)
            appendLine(text, known.key, (*chain.friction).*known.member);
    if (!chain.baseline)
        return text;
    for (const TripleKey& known : tripleKeys) {
        appendKey(text, known.key);
        const std::array<double, 3>& values = (*chain.baseline).*known.member;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0)
                text += ',';
            append(text, values[i]);
        }
        text += '\n';
    }
    return text;
}

} // namespace gripscope
