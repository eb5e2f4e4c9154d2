// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"

namespace gripscope {

/// How the connection to the gripper is told, the same wherever it shows.

/// "Gripper VG-7".
[[nodiscard]] QString gripperName(const GripperIdentity& identity);

struct ConnectionWords {
    QString headline, detail;
};
/// In the chip at the top: which gripper, or what is missing; then rate and losses, or what is waited for.
[[nodiscard]] ConnectionWords chipWords(const ConnectSession& connection);
/// On a page that has nothing to show without a gripper: what is missing, and what to do about it.
[[nodiscard]] ConnectionWords missingWords(const ConnectSession& connection);

/// An error of the connection itself: what happened, and what to do, now that the program looks out for the
/// gripper or does not.
[[nodiscard]] QString connectionErrorWords(const ConnectSession& connection, const Error& error);
/// An error that ended a squeeze.
[[nodiscard]] QString squeezeErrorWords(const ConnectSession& connection, const Error& error);

} // namespace gripscope
