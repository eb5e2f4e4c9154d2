// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/hid/hid_discovery.h"

#include <QStringList>

namespace gripscope {

/// Who asks, and which rules this computer has: what decides over a node beside the node itself.
struct NodeAccess {
    QStringList ruleFolders; ///< where udev reads its rules
    QString user;
    /// The session is one at the computer's own screen. The rule gives a node to whoever sits there, not to
    /// who came over the network, and not to a service.
    bool atTheScreen = true;
    [[nodiscard]] static NodeAccess here();
};

/// What this user may do with a node, and what stands behind it.
struct NodePermission {
    bool read = false, write = false;
    QString owner, group, mode; ///< "root", "root", "rw-------"
    bool ruled = false;         ///< a rule of this computer gives it to whoever sits at the screen
    friend bool operator==(const NodePermission&, const NodePermission&) = default;
};
[[nodiscard]] NodePermission permissionOf(const HidNode& node, const NodeAccess& access = NodeAccess::here());

/// What is missing, in words: "reading and writing (it belongs to root, group root, rw-------)"; empty where
/// nothing is.
[[nodiscard]] QString missingIn(const NodePermission& permission);

/// Whether a rule of udev in `folders` gives this product's nodes to whoever sits at the screen.
[[nodiscard]] bool hasRule(const QStringList& folders, std::uint16_t vendor, std::uint16_t product);

/// The one line that helps, for a terminal: where there is no rule, it puts one in force; where there is one,
/// it applies it anew, or for a session that no rule is for, opens this node to this user until it is plugged
/// in again.
[[nodiscard]] QString permissionCommand(const HidNode& node, const NodeAccess& access = NodeAccess::here());
/// What is missing and that line, in words.
[[nodiscard]] QString permissionAdvice(const HidNode& node, const NodeAccess& access = NodeAccess::here());

} // namespace gripscope
