// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

struct ChainEnd;
struct SpilledInspection;

/// A file of fixed size that keeps a few blocks of bytes for a while. It is allocated in full before anything
/// is put in, so that putting in needs no room on the disk; one program has it at a time (the system lets go
/// of the lock when a program is killed).
///
///     at 0     "GSPL"  u32 version (1)  u16 n  n bytes: the owner  SHA-256 of all before
///     at 4096  blocks, each from a multiple of 64:
///              "GSBK"  u32 state (1: waits, 2: done)  u64 n  SHA-256 of the n bytes
///              SHA-256 of n and that, its first 8 bytes; n bytes behind the 64th
///     zeros where the next block would begin
///
/// All numbers are big-endian. The bytes of a block are on the disk before its head is, so that a block whose
/// head is there is whole, or was damaged.
class SpillFile {
public:
    static constexpr qint64 size = qint64(16) * 1024 * 1024;
    enum class Missing { Make, Leave };

    /// Opens and locks it. Nothing where another program has it, or where it is missing and left so.
    /// FileUnwritable: also where it is no plain file.
    [[nodiscard]] static Expected<std::unique_ptr<SpillFile>> open(const QString& name, Missing missing);
    /// Takes the file away where nothing waits in it, else gives back the room that is not used.
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    struct Block {
        qint64 place = 0;
        QByteArray bytes;
    };
    struct Contents {
        QByteArray owner; ///< empty in a new file
        std::vector<Block> waiting;
        qint64 end = 0;       ///< where the next block goes
        bool damaged = false; ///< what stands from `end` on can be read by nobody
    };
    /// What stands in it; any bytes may.
    [[nodiscard]] Expected<Contents> read() const;
    /// Sets all room aside and goes on behind `contents`. FileUnwritable: the disk has no room.
    [[nodiscard]] Expected<void> prepare(const QByteArray& owner, const Contents& contents);
    /// Where the block then is. FileUnwritable: there is no room, or the disk failed.
    [[nodiscard]] Expected<qint64> add(const QByteArray& bytes);
    /// No longer needed; once no block is, the file is empty again.
    [[nodiscard]] Expected<void> remove(qint64 place);
    [[nodiscard]] qint64 room() const; ///< for the bytes of one more
    /// Keeps all of it under another name, which is returned; this object is of no use then.
    [[nodiscard]] Expected<QString> setAside();
    /// Nothing in it is needed here any more: it goes with this object.
    void discard();
    [[nodiscard]] const QString& name() const { return m_name; }

private:
    SpillFile(QString name, int descriptor) : m_name(std::move(name)), m_descriptor(descriptor) {}
    [[nodiscard]] tl::unexpected<Error> failed() const;
    [[nodiscard]] Expected<void> write(qint64 at, const QByteArray& bytes, bool now);

    QString m_name;
    int m_descriptor;
    qint64 m_end = 0;
    std::size_t m_waiting = 0;
    bool m_keep = true; ///< nothing is known yet of what it holds
};

/// How a file names the library that it belongs to, whose first link that is.
[[nodiscard]] QByteArray spillOwner(const std::optional<ChainEnd>& birth);
/// A library without a row has no link yet, and gets its first one later.
[[nodiscard]] bool isSpillOwner(const QByteArray& named, const QByteArray& owner);
/// All of a file that can be read; it is `damaged` where that is not all there is.
[[nodiscard]] std::vector<SpilledInspection> unpackedOf(const SpillFile::Contents& contents, bool& damaged);

} // namespace gripscope
