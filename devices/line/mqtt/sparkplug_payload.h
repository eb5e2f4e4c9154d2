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

/// Words of the specification.
namespace sparkplug_name {
inline constexpr const char* birthDeath = "bdSeq";
inline constexpr const char* rebirth = "Node Control/Rebirth";
inline constexpr const char* space = "spBv1.0";
} // namespace sparkplug_name

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

/// What a primary host says of itself, by STATE.
struct HostState {
    bool online = false;
    qint64 timestamp = 0; ///< milliseconds since 1970-01-01 UTC
    friend bool operator==(const HostState&, const HostState&) = default;
};
/// Nothing for what is no such JSON object; any bytes may stand there.
[[nodiscard]] std::optional<HostState> decodedHostState(const QByteArray& bytes);
[[nodiscard]] QString hostStateTopic(const QString& host);

/// Whether the primary host is there. One that left says so with the time at which it came; one that came
/// again before its last will was sent is not gone: an older message changes nothing.
class PrimaryHost {
public:
    void hear(const HostState& state);
    [[nodiscard]] bool online() const { return m_last && m_last->online; }

private:
    std::optional<HostState> m_last;
};

} // namespace gripscope
