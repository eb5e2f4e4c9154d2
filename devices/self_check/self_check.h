// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/hid/node_permission.h"
#include "devices/self_check/check_line.h"

#include <functional>
#include <optional>
#include <vector>

namespace gripscope {

/// What is looked at; everything but the library is for tests.
struct SelfCheckSubject {
    QString libraryFile;
    bool verified = true; ///< reads all of the library, which takes a second for some thousand squeezes
    NodeAccess access = NodeAccess::here();
    std::vector<HidNode> nodes = listHidNodes();
    /// What a program of this computer prints; nothing where it is not there, fails or does not answer.
    std::function<std::optional<QString>(const QString& program, const QStringList& arguments)> ask =
        askProgram;
    [[nodiscard]] static std::optional<QString> askProgram(const QString& program,
                                                           const QStringList& arguments);
};

/// Library, its integrity and ledger, the station's key, disk, calibrations, clock, permissions, versions: a
/// line each, in this order. Writes nothing, not into the library either; may take as long as reading it.
[[nodiscard]] std::vector<CheckLine> selfCheck(const SelfCheckSubject& subject);

} // namespace gripscope
