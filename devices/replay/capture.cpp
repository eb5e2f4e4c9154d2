// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture.h"

#include <QFile>
#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr char magic[] = {'G', 'S', 'C', 'A', 'P', 0, 1, 0}; // name, a zero byte, version 1 as 16 bits
constexpr qsizetype recordHead = 12;
constexpr std::uint16_t longestReport = 128;

template <typename T>
void append(QByteArray& bytes, T value)
{
    char raw[sizeof(T)];
    qToLittleEndian(value, raw);
    bytes.append(raw, sizeof raw);
}

tl::unexpected<Error> bad(const QString& name, qsizetype at, const QString& found, const QString& expected)
{
    return failure(ErrorCode::BadInput, {name + u':' + QString::number(at), found, expected});
}

} // namespace

QByteArray captureHeader()
{
    return QByteArray(magic, sizeof magic);
}

QByteArray encodeRecord(std::uint64_t time_us, CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    QByteArray out;
    append(out, static_cast<quint64>(time_us));
    append(out, static_cast<quint16>(kind));
    append(out, static_cast<quint16>(bytes.size()));
    out.append(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    return out;
}

Expected<std::vector<CaptureRecord>> parseCapture(const QByteArray& bytes, const QString& name)
{
    if (!bytes.startsWith(captureHeader()))
        return bad(name, 0, u"this is no Gripscope capture"_qs, u"expected GSCAP version 1"_qs);
    std::vector<CaptureRecord> records;
    std::uint64_t lastTime = 0;
    for (qsizetype at = captureHeader().size(); bytes.size() - at >= recordHead;) {
        CaptureRecord record;
        record.time_us = qFromLittleEndian<quint64>(bytes.constData() + at);
        const auto kind = qFromLittleEndian<quint16>(bytes.constData() + at + 8);
        const auto length = qFromLittleEndian<quint16>(bytes.constData() + at + 10);
        if (kind > static_cast<quint16>(CaptureKind::Output))
            return bad(name, at + 8, u"a record of kind %1"_qs.arg(kind), u"expected 0, 1 or 2"_qs);
        if (length > longestReport)
            return bad(name, at + 10, u"a report of %1 bytes"_qs.arg(length), u"expected at most 128"_qs);
        if (record.time_us < lastTime)
            return bad(name, at, u"a time before that of the record in front"_qs,
                       u"expected times in order"_qs);
        if (bytes.size() - at - recordHead < length)
            break;
        record.kind = static_cast<CaptureKind>(kind);
        const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.constData()) + at + recordHead;
        record.bytes.assign(first, first + length);
        lastTime = record.time_us;
        records.push_back(std::move(record));
        at += recordHead + length;
    }
    return records;
}

Expected<std::vector<CaptureRecord>> readCapture(const QString& file)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    return parseCapture(in.readAll(), file);
}

} // namespace gripscope
