// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// The folder in which sessions are kept: `SESSION.part0001.gscap`, ..., and SHA256SUMS, which `sha256sum -c`
/// reads: the hash of every part that was closed, behind a comment that counts its squeezes. A part that is
/// not listed is being written, or its program ended without closing it.
class CaptureFolder {
public:
    struct Part {
        QString name; ///< of the file
        qint64 bytes = 0;
        QString hash;                        ///< empty: it was not closed
        std::optional<qint64> squeezes = {}; ///< known once it was closed
        [[nodiscard]] bool closed() const { return !hash.isEmpty(); }
    };
    enum class Condition { Whole, Changed, NotClosed, Unreadable };
    struct Checked {
        Part part;
        Condition condition = Condition::Whole;
        QString words; ///< for a person
    };

    explicit CaptureFolder(QString path) : m_path(std::move(path)) {}
    /// The user's own: captures in the folder of the application's data, or GRIPSCOPE_CAPTURES.
    [[nodiscard]] static QString defaultPath();

    [[nodiscard]] QString path() const { return m_path; }
    [[nodiscard]] QString filePath(const QString& name) const;
    /// All parts by name, which is the order of time. None where there is no such folder.
    [[nodiscard]] std::vector<Part> parts() const;
    /// Reads a part: its hash, or for one that was not closed its records.
    [[nodiscard]] Checked check(const Part& part) const;

    /// Lists a part as closed. StorageFailed.
    [[nodiscard]] Expected<void> list(const Part& closed) const;
    struct Pruned {
        std::vector<Part> removed;
        std::optional<Error> problem; ///< it ended there: not all went that was to go
    };
    /// Removes parts until all together have at most `most` bytes: the oldest first, those without a squeeze
    /// before those with one or not known to have none. `keep` stays.
    [[nodiscard]] Pruned prune(qint64 most, const QString& keep = {}) const;

private:
    [[nodiscard]] Expected<void> rewriteList(const std::vector<Part>& removed) const;
    QString m_path;
};

} // namespace gripscope
