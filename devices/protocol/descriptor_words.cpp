// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/descriptor_words.h"

#include "core/base/words.h"
#include "devices/protocol/report_words.h"

#include <QStringList>

#include <algorithm>
#include <array>

namespace gripscope::protocol {

using namespace Qt::StringLiterals;

namespace {

/// Tag and type of a short item, without the size: the prefix byte and 0xFC.
enum Item : std::uint8_t {
    Input = 0x80,
    Output = 0x90,
    Feature = 0xB0,
    Collection = 0xA0,
    EndCollection = 0xC0,
    UsagePage = 0x04,
    LogicalMinimum = 0x14,
    LogicalMaximum = 0x24,
    PhysicalMinimum = 0x34,
    PhysicalMaximum = 0x44,
    UnitExponent = 0x54,
    Unit = 0x64,
    ReportSize = 0x74,
    ReportIdItem = 0x84,
    ReportCount = 0x94,
    Push = 0xA4,
    Pop = 0xB4,
    Usage = 0x08,
    UsageMinimum = 0x18,
    UsageMaximum = 0x28,
};

constexpr std::uint8_t longItem = 0xFE;

QString hexNumber(std::uint32_t value, int digits)
{
    return u"0x%1"_qs.arg(value, digits, 16, QLatin1Char('0'));
}

QString pageName(std::uint32_t page)
{
    if (page >= 0xFF00)
        return u" (vendor-defined)"_qs;
    switch (page) {
    case 0x01:
        return u" (generic desktop)"_qs;
    case 0x09:
        return u" (button)"_qs;
    case 0x0C:
        return u" (consumer)"_qs;
    case 0x20:
        return u" (sensor)"_qs;
    default:
        return {};
    }
}

QString mainFlags(std::uint32_t flags)
{
    return QStringList{flags & 1 ? u"constant"_qs : u"data"_qs, flags & 2 ? u"variable"_qs : u"array"_qs,
                       flags & 4 ? u"relative"_qs : u"absolute"_qs}
        .join(u", "_qs);
}

QString collectionName(std::uint32_t kind)
{
    static const std::array names{u"physical"_qs, u"application"_qs, u"logical"_qs, u"report"_qs};
    return kind < names.size() ? names[kind] : hexNumber(kind, 2);
}

std::int32_t asSigned(std::uint32_t value, std::size_t size)
{
    if (size == 1)
        return static_cast<std::int8_t>(value);
    if (size == 2)
        return static_cast<std::int16_t>(value);
    return static_cast<std::int32_t>(value);
}

QString wordsOf(std::uint8_t item, std::uint32_t value, std::size_t size)
{
    const auto count = [value](const QString& name) { return u"%1 %2"_qs.arg(name).arg(value); };
    const auto range = [&](const QString& name) { return u"%1 %2"_qs.arg(name).arg(asSigned(value, size)); };
    const auto usage = [value](const QString& name) { return u"%1 %2"_qs.arg(name, hexNumber(value, 2)); };
    switch (item) {
    case Input:
        return u"Input: "_qs + mainFlags(value);
    case Output:
        return u"Output: "_qs + mainFlags(value);
    case Feature:
        return u"Feature: "_qs + mainFlags(value);
    case Collection:
        return u"Collection: "_qs + collectionName(value);
    case EndCollection:
        return u"End of collection"_qs;
    case UsagePage:
        return u"Usage page "_qs + hexNumber(value, 4) + pageName(value);
    case LogicalMinimum:
        return range(u"Logical minimum"_qs);
    case LogicalMaximum:
        return range(u"Logical maximum"_qs);
    case PhysicalMinimum:
        return range(u"Physical minimum"_qs);
    case PhysicalMaximum:
        return range(u"Physical maximum"_qs);
    case UnitExponent:
        return range(u"Unit exponent"_qs);
    case Unit:
        return usage(u"Unit"_qs);
    case ReportSize:
        return count(u"Report size"_qs) + u" bits"_qs;
    case ReportIdItem:
        return u"Report ID %1 (%2)"_qs.arg(hexNumber(value, 2), reportName(static_cast<std::uint8_t>(value)));
    case ReportCount:
        return count(u"Report count"_qs);
    case Push:
        return u"Push"_qs;
    case Pop:
        return u"Pop"_qs;
    case Usage:
        return usage(u"Usage"_qs);
    case UsageMinimum:
        return usage(u"Usage minimum"_qs);
    case UsageMaximum:
        return usage(u"Usage maximum"_qs);
    default:
        return u"Item "_qs + hexNumber(item, 2);
    }
}

} // namespace

std::vector<DescriptorItem> descriptorInWords(std::span<const std::uint8_t> bytes)
{
    static constexpr std::array<std::size_t, 4> sizes{0, 1, 2, 4};
    std::vector<DescriptorItem> items;
    int depth = 0;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::uint8_t prefix = bytes[at];
        const bool isLong = prefix == longItem;
        // A long item: its size, its tag, its data.
        const std::size_t size = !isLong                 ? sizes[prefix & 3]
                                 : at + 1 < bytes.size() ? 2U + bytes[at + 1]
                                                         : 2U;
        const std::span<const std::uint8_t> rest = bytes.subspan(at);
        const bool whole = 1 + size <= rest.size();
        const auto item = rest.first(std::min(1 + size, rest.size()));
        const auto tag = static_cast<std::uint8_t>(prefix & 0xFC);
        std::uint32_t value = 0;
        for (std::size_t i = 1; !isLong && i < item.size(); ++i)
            value |= static_cast<std::uint32_t>(item[i]) << (8 * (i - 1));
        if (whole && tag == EndCollection && !isLong)
            depth = std::max(0, depth - 1);
        const QString words = !whole
                                  ? Words::tr("cut short: %1 bytes are missing").arg(1 + size - rest.size())
                              : isLong ? u"Long item"_qs
                                       : wordsOf(tag, value, size);
        items.push_back({hexDump(item), depth, words});
        if (whole && tag == Collection && !isLong)
            ++depth;
        at += item.size();
    }
    return items;
}

} // namespace gripscope::protocol
