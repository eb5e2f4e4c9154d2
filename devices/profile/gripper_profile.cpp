// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/gripper_profile.h"

#include "core/session/connection/device_button.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct TypeFacts {
    const char16_t* name;
    std::size_t size;
    bool isSigned;
};

/// In the order of FieldType.
constexpr std::array<TypeFacts, 9> facts{{{u"u8", 1, false},
                                          {u"u16", 2, false},
                                          {u"u24", 3, false},
                                          {u"u32", 4, false},
                                          {u"i8", 1, true},
                                          {u"i16", 2, true},
                                          {u"i24", 3, true},
                                          {u"i32", 4, true},
                                          {u"f32", 4, true}}};

const TypeFacts& factsOf(FieldType type)
{
    return facts[static_cast<std::size_t>(type)];
}

/// All ones in the lowest `bits`.
std::uint32_t mask(unsigned bits)
{
    return bits >= 32 ? 0xFFFFFFFFU : (1U << bits) - 1U;
}

std::uint32_t load(protocol::ReportView report, std::size_t first, std::size_t size, bool bigEndian)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < size; ++i)
        word |= std::uint32_t(report[first + i]) << (8 * (bigEndian ? size - 1 - i : i));
    return word;
}

void store(std::uint32_t word, std::span<std::uint8_t> report, std::size_t first, std::size_t size,
           bool bigEndian)
{
    for (std::size_t i = 0; i < size; ++i)
        report[first + i] = static_cast<std::uint8_t>(word >> (8 * (bigEndian ? size - 1 - i : i)));
}

constexpr std::array<std::pair<const char16_t*, std::uint16_t>, 7> flags{
    {{u"moving", StatusMoving},
     {u"force_limit", StatusForceLimit},
     {u"travel_limit", StatusTravelLimit},
     {u"force_saturated", StatusForceSaturated},
     {u"position_saturated", StatusPositionSaturated},
     {u"fault", StatusFault},
     {u"button", statusButton}}};

} // namespace

QString toString(FieldType type)
{
    return QString::fromUtf16(factsOf(type).name);
}

std::optional<FieldType> fieldTypeFromString(const QString& text)
{
    const qsizetype index = fieldTypeNames().indexOf(text);
    return index < 0 ? std::nullopt : std::optional(static_cast<FieldType>(index));
}

QStringList fieldTypeNames()
{
    QStringList names;
    for (const TypeFacts& type : facts)
        names << QString::fromUtf16(type.name);
    return names;
}

std::size_t ProfileField::size() const
{
    return factsOf(type).size;
}

unsigned ProfileField::width() const
{
    return bits > 0 ? bits : static_cast<unsigned>(8 * size()) - firstBit;
}

bool ProfileField::isSigned() const
{
    return factsOf(type).isSigned;
}

std::uint32_t ProfileField::count(protocol::ReportView report, std::size_t shift) const
{
    return load(report, byte + shift, size(), bigEndian) >> firstBit & mask(width());
}

double ProfileField::number(protocol::ReportView report, std::size_t shift) const
{
    if (type == FieldType::F32)
        return static_cast<double>(std::bit_cast<float>(load(report, byte + shift, size(), bigEndian)));
    const std::uint32_t raw = count(report, shift);
    const bool negative = isSigned() && (raw >> (width() - 1) & 1U) != 0;
    return negative ? static_cast<double>(raw) - std::ldexp(1.0, static_cast<int>(width()))
                    : static_cast<double>(raw);
}

double ProfileField::least() const
{
    if (type == FieldType::F32)
        return -static_cast<double>(std::numeric_limits<float>::max());
    return isSigned() ? -std::ldexp(1.0, static_cast<int>(width()) - 1) : 0.0;
}

double ProfileField::most() const
{
    if (type == FieldType::F32)
        return static_cast<double>(std::numeric_limits<float>::max());
    return std::ldexp(1.0, static_cast<int>(width()) - (isSigned() ? 1 : 0)) - 1.0;
}

bool ProfileField::put(double value, std::span<std::uint8_t> report, std::size_t shift) const
{
    const double held = std::clamp(value, least(), most());
    const std::size_t first = byte + shift;
    if (type == FieldType::F32) {
        store(std::bit_cast<std::uint32_t>(static_cast<float>(held)), report, first, size(), bigEndian);
        return held == value;
    }
    const double whole = std::round(held);
    const auto raw = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)) & mask(width());
    const std::uint32_t others = load(report, first, size(), bigEndian) & ~(mask(width()) << firstBit);
    store(others | raw << firstBit, report, first, size(), bigEndian);
    return held == value;
}

double ProfileTime::secondsPerCount() const
{
    if (unit == u"ns")
        return 1e-9 * scale;
    if (unit == u"us")
        return 1e-6 * scale;
    return unit == u"ms" ? 1e-3 * scale : scale;
}

bool GripperProfile::clockIsFine() const
{
    constexpr double longestTick = 0.5; // of a report's time
    return time && time->secondsPerCount() <= longestTick * reportTime_s();
}

LossEvidence GripperProfile::lossEvidence() const
{
    if (sequence)
        return LossEvidence::SequenceNumber;
    return clockIsFine() ? LossEvidence::Clock : LossEvidence::None;
}

QString GripperProfile::usbNumbers() const
{
    return u"%1:%2"_s.arg(vendor, 4, 16, QLatin1Char('0')).arg(product, 4, 16, QLatin1Char('0'));
}

std::vector<NamedField> fieldsOf(const GripperProfile& profile)
{
    std::vector<NamedField> fields{{u"force"_s, &profile.force.field, true},
                                   {u"position"_s, &profile.position.field, true}};
    if (profile.sequence)
        fields.push_back({u"sequence"_s, &profile.sequence->field, false});
    if (profile.time)
        fields.push_back({u"time"_s, &profile.time->field, false});
    if (profile.status)
        fields.push_back({u"status"_s, &profile.status->field, false});
    return fields;
}

QString flagName(std::uint16_t meaning)
{
    for (const auto& flag : flags)
        if (flag.second == meaning)
            return QString::fromUtf16(flag.first);
    return {};
}

std::uint16_t flagFromName(const QString& name)
{
    for (const auto& flag : flags)
        if (name == QStringView(flag.first))
            return flag.second;
    return 0;
}

QStringList flagNames()
{
    QStringList names;
    for (const auto& flag : flags)
        names << QString::fromUtf16(flag.first);
    return names;
}

} // namespace gripscope
