// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace gripscope {

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
