// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
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

/// A file that this program has open by SQLite, as long as the object lives; there may be several of one
/// file.
///
/// POSIX takes all locks of a process off a file as soon as the process closes any descriptor of it
/// (sqlite.org/howtocorrupt.html, 2.2). Whoever opened and closed a library that is open here would take
/// SQLite's locks off it, and the next other program to close it would delete the log that is still being
/// written.
class FileInUse {
public:
    /// `name` need not be there yet: noteNew() follows then.
    explicit FileInUse(const QString& name);
    ~FileInUse();
    FileInUse(const FileInUse&) = delete;
    FileInUse& operator=(const FileInUse&) = delete;
    /// The file was made meanwhile, and nothing is locked in it yet.
    void noteNew(const QString& name);

    /// Does what opens and closes the file, unless this program has it open: it was looked at when it was
    /// opened first. Nobody here opens one meanwhile.
    static void unlessInUse(const QString& name, const std::function<void()>& look);

private:
    std::optional<FileIdentity> m_identity;
};

} // namespace gripscope
