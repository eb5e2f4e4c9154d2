// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/line/line_status.h"

#include <QStringList>

#include <memory>

namespace gripscope {

struct ModbusServerOptions {
    QString host = QStringLiteral("127.0.0.1"); ///< the address to listen on, no name
    std::uint16_t port = 1502; ///< 502, Modbus's own, is for programs with the right to it; 0: any free one
    /// Who may connect: addresses and networks ("10.1.2.0/24"); this computer always may.
    QStringList peers;
};
/// Usage, in words for a person: what is no address, no network.
[[nodiscard]] Expected<void> checkOptions(const ModbusServerOptions& options);
/// "HOST:PORT", with an address of version 6 in brackets. Usage where it is none.
[[nodiscard]] Expected<ModbusServerOptions> parseListenAddress(const QString& text);

/// Puts a JobDesk on the network as a Modbus TCP server (modbus_registers.h), in a thread of its own, which
/// does nothing else and is waited for by nobody. Bounded: some clients, of each a few requests at a time and
/// some kilobytes that it did not fetch; what goes beyond is put off, or the client is.
class ModbusServer {
public:
    static constexpr int mostClients = 8;
    /// Of all clients together and of one, in 10 ms: what keeps a flood off the processor.
    static constexpr int requestsAtOnce = 200, requestsOfOne = 100;

    /// An address that cannot be listened on is tried again every few seconds, and told by link().
    ModbusServer(const ModbusServerOptions& options, std::shared_ptr<SharedJobDesk> desk);
    ~ModbusServer(); ///< closes what is open
    ModbusServer(const ModbusServer&) = delete;
    ModbusServer& operator=(const ModbusServer&) = delete;

    [[nodiscard]] LineLink link() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
