// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <chrono>
#include <cstdint>

namespace gripscope {

/// Which broker gets the results, and as what: JSON, Sparkplug B or both.
struct MqttOptions {
    QString host;
    std::uint16_t port = 1883;
    bool tls = false;
    QString caFile; ///< PEM; empty: the authorities that this computer trusts
    QString user;   ///< empty: none
    /// Its first line is the password, so that no setting, export, audit entry or command line has it.
    QString passwordFile;
    QString jsonTopic;   ///< empty: no JSON
    QString group, node; ///< of Sparkplug; both empty: no Sparkplug
    QString primaryHost; ///< by its host id; empty: nothing waits for one
    int keepAlive_s = 30;
    /// Between two attempts to connect: at first, doubled by each that fails, at most.
    std::chrono::milliseconds retryFirst{1000}, retryMost{30'000};

    [[nodiscard]] bool sparkplug() const { return !group.isEmpty(); }
    [[nodiscard]] QString broker() const; ///< "HOST:PORT"
    friend bool operator==(const MqttOptions&, const MqttOptions&) = default;
};
/// Usage, in words for a person.
[[nodiscard]] Expected<void> checkOptions(const MqttOptions& options);
/// "HOST:PORT" or "HOST", whose port is that of MQTT, or of MQTT over TLS.
[[nodiscard]] Expected<void> parseBroker(const QString& text, MqttOptions& options);
/// "GROUP/NODE"; empty: no Sparkplug. checkOptions() says what is wrong with them.
void setSparkplug(const QString& text, MqttOptions& options);
/// The same for each station, and unlike that of any other.
[[nodiscard]] QByteArray clientId(const MqttOptions& options);
/// Nothing where no file is named. FileUnreadable; Usage: others than its owner may read it.
[[nodiscard]] Expected<QByteArray> readPassword(const MqttOptions& options);

} // namespace gripscope
