// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/mqtt/outbox_file.h"

#include <optional>

namespace gripscope {

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
