// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace gripscope {

/// Which file a name leads to: a file that was removed, moved away or replaced is another, though a process
/// that has it open can go on writing into what nobody will find again.
struct FileIdentity {
    quint64 device = 0, number = 0;
    /// Nothing where there is no such file.
    [[nodiscard]] static std::optional<FileIdentity> of(const QString& name);
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

} // namespace gripscope
