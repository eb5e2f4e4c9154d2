// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/byte_writer.h"
#include "devices/line/mqtt/outbox_file.h"

#include <QCryptographicHash>
#include <QtEndian>

#include <algorithm>

namespace gripscope {

namespace {

constexpr QByteArrayView outboxMagic = "GSMQ";
constexpr QByteArrayView recordMagic = "GSMR";
constexpr quint32 outboxVersion = 1;
constexpr qsizetype kindAt = 4, numberAt = 5, lengthAt = 13, bytesAt = 17, checkBytes = 8;

QByteArray checkOf(QByteArrayView bytes)
{
    return QCryptographicHash::hash(bytes.toByteArray(), QCryptographicHash::Sha256).left(checkBytes);
}

void acknowledgeTo(OutboxFile::Contents& contents, std::uint64_t sequence)
{
    while (!contents.waiting.empty() && contents.waiting.front().sequence <= sequence)
        contents.waiting.pop_front();
}

void take(OutboxFile::Contents& contents, OutboxRecord record)
{
    switch (record.kind) {
    case OutboxKind::Result:
        if (record.number < contents.next) // the same once more, or a damaged order
            return;
        contents.next = record.number + 1;
        contents.waiting.push_back({record.number, std::move(record.bytes)});
        return;
    case OutboxKind::Acknowledged:
        return acknowledgeTo(contents, record.number);
    case OutboxKind::Next:
        contents.next = std::max(contents.next, record.number);
        return;
    case OutboxKind::Birth:
        contents.birth = static_cast<std::uint8_t>(record.number);
        return;
    }
}

} // namespace

QByteArray outboxHead()
{
    return ByteWriter().plain(outboxMagic).number(outboxVersion).bytes();
}

QByteArray packed(const OutboxRecord& record)
{
    const QByteArray body = ByteWriter()
                                .plain(recordMagic)
                                .number(static_cast<quint8>(record.kind))
                                .number(static_cast<quint64>(record.number))
                                .number(static_cast<quint32>(record.bytes.size()))
                                .plain(record.bytes)
                                .bytes();
    return body + checkOf(body);
}

qint64 packedSize(const QByteArray& bytes)
{
    return bytesAt + bytes.size() + checkBytes;
}

std::optional<OutboxRecord> recordAt(const QByteArray& file, qsizetype at, qsizetype& end)
{
    if (file.size() - at < bytesAt + checkBytes || QByteArrayView(file).sliced(at, kindAt) != recordMagic)
        return {};
    const char* begin = file.constData() + at;
    const auto kind = static_cast<quint8>(begin[kindAt]);
    const auto length = qFromBigEndian<quint32>(begin + lengthAt);
    if (kind < 1 || kind > 4 || length > OutboxFile::longestRecord ||
        file.size() - at < bytesAt + checkBytes + qsizetype(length))
        return {};
    const QByteArrayView body = QByteArrayView(file).sliced(at, bytesAt + qsizetype(length));
    end = at + body.size() + checkBytes;
    if (file.mid(at + body.size(), checkBytes) != checkOf(body))
        return {};
    return OutboxRecord{static_cast<OutboxKind>(kind), qFromBigEndian<quint64>(begin + numberAt),
                        body.sliced(bytesAt).toByteArray()};
}

OutboxFile::Contents readOutbox(const QByteArray& file, qsizetype& end)
{
    OutboxFile::Contents contents;
    const QByteArray head = outboxHead();
    contents.damaged = file.size() >= head.size() && !file.startsWith(head);
    qsizetype at = end = std::min(file.size(), head.size());
    while (at < file.size()) {
        qsizetype behind = 0;
        if (std::optional<OutboxRecord> record = recordAt(file, at, behind)) {
            contents.damaged = contents.damaged || at != end;
            take(contents, std::move(*record));
            at = end = behind;
        } else {
            at = file.indexOf(recordMagic, at + 1);
            if (at < 0)
                break;
        }
    }
    return contents;
}

} // namespace gripscope
