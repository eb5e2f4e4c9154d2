// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture.h"

#include "devices/replay/capture_reader.h"

#include <QtEndian>

namespace gripscope {

namespace {

constexpr char magic[] = {'G', 'S', 'C', 'A', 'P', 0, 2, 0}; // name, a zero byte, version 2 as 16 bits

Expected<std::vector<CaptureRecord>> readAll(Expected<CaptureReader> reader)
{
    if (!reader)
        return tl::unexpected<Error>(reader.error());
    std::vector<CaptureRecord> records;
    for (;;) {
        ASSIGN_OR_RETURN(std::optional<CaptureRecord> record, reader->next());
        if (!record)
            return records;
        records.push_back(std::move(*record));
    }
}

} // namespace

QByteArray captureHeader()
{
    return QByteArray(magic, sizeof magic);
}

void encodeRecordHead(std::uint64_t time_us, CaptureKind kind, std::size_t length, std::uint8_t* to)
{
    qToLittleEndian(static_cast<quint64>(time_us), to);
    qToLittleEndian(static_cast<quint16>(kind), to + 8);
    qToLittleEndian(static_cast<quint16>(length), to + 10);
}

QByteArray encodeRecord(std::uint64_t time_us, CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    QByteArray out(captureRecordHead, '\0');
    encodeRecordHead(time_us, kind, bytes.size(), reinterpret_cast<std::uint8_t*>(out.data()));
    out.append(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    return out;
}

Expected<std::vector<CaptureRecord>> parseCapture(const QByteArray& bytes, const QString& name)
{
    return readAll(CaptureReader::over(bytes, name));
}

Expected<std::vector<CaptureRecord>> readCapture(const QString& file)
{
    return readAll(CaptureReader::open(file));
}

} // namespace gripscope
