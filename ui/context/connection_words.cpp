// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/connection_words.h"

#include "core/base/words.h"
#include "core/session/connection/loss_watch.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

using LinkPhase = ConnectSession::State;

struct Told {
    Q_DECLARE_TR_FUNCTIONS(gripscope::Connection)
};

/// It was connected before, so that it has a name.
bool isKnown(const ConnectSession& connection)
{
    return !connection.identity().serial.isEmpty() || !connection.identity().name.isEmpty();
}

bool isForbidden(const ConnectSession& connection)
{
    const std::optional<Error> error = connection.lastError();
    return error && error->code == ErrorCode::DevicePermission;
}

QString streamWords(const ConnectSession& connection)
{
    const LinkCounters counters = connection.counters();
    // As it is measured over the last second, to as many digits as that second tells; none in the first.
    const QString rate = counters.sampleRate_Hz > 0
                             ? Told::tr("%1 kHz").arg(Words::number(1e-3 * counters.sampleRate_Hz, 'g', 2))
                             : QString(QChar(0x2026));
    const auto lost = static_cast<qint64>(counters.lostSamples);
    // Beside the sign of a link that is well, what was lost is told as past.
    const bool earlier =
        counters.lastLoss && std::chrono::steady_clock::now() - *counters.lastLoss > LossWatch::window;
    return (earlier ? Told::tr("%1 · %2 lost earlier") : Told::tr("%1 · %2 lost"))
        .arg(counters.stalled ? Told::tr("silent") : rate, formatCount(lost));
}

} // namespace

QString gripperName(const GripperIdentity& identity)
{
    return identity.serial.isEmpty() ? identity.name : Told::tr("Gripper %1").arg(identity.serial);
}

ConnectionWords chipWords(const ConnectSession& connection)
{
    const GripperIdentity identity = connection.identity();
    switch (connection.state()) {
    case LinkPhase::Connected:
        return {identity.serial.isEmpty() ? identity.name : u"%1 %2"_s.arg(identity.name, identity.serial),
                streamWords(connection)};
    case LinkPhase::Connecting:
        return {Told::tr("Connecting…"), connection.address()};
    case LinkPhase::Lost:
        if (isForbidden(connection))
            return {Told::tr("No permission"), Told::tr("see what to type")};
        if (!connection.awaiting())
            return {Told::tr("Gripper lost"), Told::tr("choose one")};
        return {isKnown(connection) ? Told::tr("%1 is away").arg(gripperName(identity))
                                    : Told::tr("No gripper yet"),
                Told::tr("waiting for it")};
    case LinkPhase::Disconnected:
        return {Told::tr("No gripper"), Told::tr("choose one")};
    }
    return {};
}

ConnectionWords missingWords(const ConnectSession& connection)
{
    if (isForbidden(connection))
        return {Told::tr("No permission"), Told::tr("Choose the gripper at the top to see what to type")};
    if (!connection.awaiting())
        return {Told::tr("No gripper"), Told::tr("Choose one at the top of the window")};
    if (!isKnown(connection))
        return {Told::tr("No gripper yet"), Told::tr("Plug it in: Gripscope connects it by itself")};
    return {Told::tr("%1 is away").arg(gripperName(connection.identity())),
            Told::tr("Plug it in again: Gripscope goes on by itself")};
}

QString connectionErrorWords(const ConnectSession& connection, const Error& error)
{
    if (!connection.awaiting())
        return error.describe();
    if (error.code == ErrorCode::DevicePermission)
        return Told::tr(
                   "The gripper at %1 may not be opened by this user. Choose it at the top to see what to "
                   "type; "
                   "Gripscope connects it by itself then.")
            .arg(error.argument(0));
    if (error.code == ErrorCode::DeviceLost && isKnown(connection))
        return Told::tr("%1 went away: %2. Plug it in again: Gripscope goes on by itself.")
            .arg(gripperName(connection.identity()), error.argument(1));
    return Told::tr("%1 Gripscope connects it as soon as it is there.").arg(error.describe());
}

QString squeezeErrorWords(const ConnectSession& connection, const Error& error)
{
    if (error.code != ErrorCode::DeviceLost || !connection.awaiting())
        return error.describe();
    return Told::tr(
               "%1 went away during the squeeze, so nothing was measured. Plug it in again, arm it, then "
               "repeat "
               "the squeeze.")
        .arg(gripperName(connection.identity()));
}

} // namespace gripscope
