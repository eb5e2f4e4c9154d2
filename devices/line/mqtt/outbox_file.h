// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

namespace gripscope {

/// What waits to be sent, in a file that outlives the program: records behind one another, the first to wait
/// first. One program has it at a time (the system lets go of the lock when a program is killed).
///
///     "GSMQ"  u32 version (1)
///     records: "GSMR"  u8 kind  u64 number  u32 n  n bytes  SHA-256 of all before in the record, its first 8
///     bytes
///
/// All numbers are big-endian. Kinds: 1 a result, `number` its sequence; 2 all results to `number` are
/// acknowledged; 3 the sequence that is given next; 4 a session began, `number` its bdSeq. A record that was
/// torn off is cut off when the file is opened; one that was damaged is left out, and the ones behind it are
/// found by their beginning. What is no longer of use goes when it is most of the file: all that is goes into
/// a new one, which takes its name.
class OutboxFile {
public:
    struct Waiting {
        std::uint64_t sequence = 0;
        QByteArray bytes;
        friend bool operator==(const Waiting&, const Waiting&) = default;
    };
    struct Contents {
        std::deque<Waiting> waiting;
        std::uint64_t next = 1;   ///< the sequence of the next result
        std::uint8_t birth = 255; ///< of the session that began last
        bool damaged = false;     ///< some of it could not be read, and is lost
    };
    static constexpr qint64 leastCompacted = 65536;
    static constexpr quint32 longestRecord = 65536;

    /// Nothing where another program has it. FileUnwritable.
    [[nodiscard]] static Expected<std::unique_ptr<OutboxFile>> open(const QString& name);
    ~OutboxFile();
    OutboxFile(const OutboxFile&) = delete;
    OutboxFile& operator=(const OutboxFile&) = delete;

    [[nodiscard]] const Contents& contents() const { return m_contents; }
    /// Keeps a result under the next sequence, and is on the disk before it returns.
    [[nodiscard]] Expected<std::uint64_t> add(const QByteArray& bytes);
    /// A result got a sequence and is not kept: there is no room.
    [[nodiscard]] Expected<void> skip();
    [[nodiscard]] Expected<void> acknowledge(std::uint64_t sequence);
    /// The number of a session that begins, kept before it is used.
    [[nodiscard]] Expected<std::uint8_t> nextBirth();
    [[nodiscard]] qint64 size() const { return m_size; }

private:
    OutboxFile(QString name, int descriptor) : m_name(std::move(name)), m_descriptor(descriptor) {}
    [[nodiscard]] tl::unexpected<Error> failed() const;
    [[nodiscard]] Expected<void> load();
    [[nodiscard]] Expected<void> append(const QByteArray& record, bool now);
    [[nodiscard]] Expected<void> compactIfItPays();
    [[nodiscard]] Expected<void> compact();

    QString m_name;
    int m_descriptor;
    qint64 m_size = 0;
    qint64 m_needed = 0; ///< bytes of it that are of use
    Contents m_contents;
};

// Its records as bytes. Pure functions.

enum class OutboxKind : std::uint8_t { Result = 1, Acknowledged = 2, Next = 3, Birth = 4 };

struct OutboxRecord {
    OutboxKind kind = OutboxKind::Result;
    std::uint64_t number = 0;
    QByteArray bytes;
};
[[nodiscard]] QByteArray outboxHead();
[[nodiscard]] QByteArray packed(const OutboxRecord& record);
[[nodiscard]] qint64 packedSize(const QByteArray& bytes);
/// The record that begins there, and where it ends; nothing for anything else.
[[nodiscard]] std::optional<OutboxRecord> recordAt(const QByteArray& file, qsizetype at, qsizetype& end);
/// All that can be read of a file's bytes; any may stand there. `end`: behind the last whole record.
[[nodiscard]] OutboxFile::Contents readOutbox(const QByteArray& file, qsizetype& end);

} // namespace gripscope
