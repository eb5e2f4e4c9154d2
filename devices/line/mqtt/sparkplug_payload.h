// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace gripscope {

/// Of Sparkplug B 3.0, chapter 6: what is sent here. The numbers are the specification's.
enum class SparkplugType : std::uint32_t {
    UInt16 = 6,
    UInt32 = 7,
    UInt64 = 8,
    Double = 10,
    Boolean = 11,
    String = 12,
    DateTime = 13,
};

struct SparkplugMetric {
    /// Nothing: the value is null.
    using Value = std::variant<std::monostate, quint64, double, bool, QString>;
    QString name; ///< empty: left out, where an alias says which it is
    std::optional<std::uint64_t> alias;
    SparkplugType type = SparkplugType::String;
    Value value;
    bool historical = false;
    bool typed = true; ///< births say the type; data need not
};

struct SparkplugPayload {
    std::optional<QDateTime> sent; ///< a will has none: it is sent when nobody knows
    std::optional<std::uint8_t> seq;
    QDateTime measured; ///< of all metrics; not valid: nobody knows
    std::vector<SparkplugMetric> metrics;
};
/// As bytes of protobuf.
[[nodiscard]] QByteArray encoded(const SparkplugPayload& payload);

/// What a command to the edge node asks for.
enum class NodeCommand {
    None, ///< something that this node has not
    Rebirth,
    Unreadable,
};
inline constexpr qsizetype longestCommand = 65536;
/// Any bytes may stand there.
[[nodiscard]] NodeCommand decodedCommand(const QByteArray& bytes);

} // namespace gripscope
