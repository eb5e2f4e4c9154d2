// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_reader.h"

#include "core/base/bounded_file.h"
#include "core/base/words.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 headerSize = 8;
constexpr quint16 newestVersion = 2;

tl::unexpected<Error> bad(const QString& name, qint64 at, const QString& found, const QString& expected)
{
    return failure(ErrorCode::BadInput, {name + u':' + QString::number(at), found, expected});
}

/// 0: this is no capture.
quint16 versionOf(const QByteArray& header)
{
    if (header.size() < headerSize || !header.startsWith(QByteArray("GSCAP\0", 6)))
        return 0;
    return qFromLittleEndian<quint16>(header.constData() + 6);
}

} // namespace

QStringList capturePartsFrom(const QString& file)
{
    static const QRegularExpression form(u"^(.+)\\.part(\\d{4,})\\.gscap$"_s);
    const QFileInfo info(file);
    const QRegularExpressionMatch match = form.match(info.fileName());
    if (!match.hasMatch())
        return {file};
    QStringList parts;
    const QDir folder = info.dir();
    for (const QString& name :
         folder.entryList({match.captured(1) + u".part*.gscap"_s}, QDir::Files, QDir::Name)) {
        const QRegularExpressionMatch other = form.match(name);
        if (other.captured(1) == match.captured(1) &&
            other.captured(2).toULongLong() >= match.captured(2).toULongLong())
            parts << folder.filePath(name);
    }
    return parts.isEmpty() ? QStringList{file} : parts;
}

Expected<CaptureReader> CaptureReader::open(const QString& file)
{
    return over(capturePartsFrom(file));
}

Expected<CaptureReader> CaptureReader::openPart(const QString& file)
{
    return over(QStringList{file});
}

Expected<CaptureReader> CaptureReader::over(QStringList parts)
{
    CaptureReader reader;
    reader.m_parts = std::move(parts);
    RETURN_IF_ERROR(reader.beginNextPart());
    return reader;
}

Expected<CaptureReader> CaptureReader::over(const QByteArray& bytes, const QString& name)
{
    auto buffer = std::make_unique<QBuffer>();
    buffer->setData(bytes);
    buffer->open(QIODevice::ReadOnly);
    CaptureReader reader;
    RETURN_IF_ERROR(reader.begin(std::move(buffer), name));
    return reader;
}

Expected<void> CaptureReader::begin(std::unique_ptr<QIODevice> part, const QString& name)
{
    m_part = std::move(part);
    m_name = name;
    m_version = versionOf(m_part->read(headerSize));
    if (m_version == 0)
        return bad(name, 0, Words::tr("this is no Gripscope capture"),
                   Words::tr("expected GSCAP, version 1 or 2"));
    if (m_version > newestVersion)
        return bad(name, 0, Words::tr("a capture of version %1").arg(m_version),
                   Words::tr("expected version 1 or 2; a newer program reads it"));
    m_at = headerSize;
    m_left = 0;
    return {};
}

Expected<bool> CaptureReader::beginNextPart()
{
    if (m_parts.isEmpty())
        return false;
    auto file = std::make_unique<QFile>(m_parts.takeFirst());
    const QString name = file->fileName();
    RETURN_IF_ERROR(openRegular(*file));
    return begin(std::move(file), name).map([] { return true; });
}

Expected<std::optional<CaptureRecord>> CaptureReader::next()
{
    for (;;) {
        Expected<std::optional<CaptureRecord>> record = nextInPart();
        if (!record || *record)
            return record;
        ASSIGN_OR_RETURN(const bool more, beginNextPart());
        if (!more)
            return std::optional<CaptureRecord>();
    }
}

Expected<std::optional<CaptureRecord>> CaptureReader::nextInPart()
{
    const QByteArray head = m_part->read(captureRecordHead);
    const auto length =
        head.size() < captureRecordHead ? quint16(0) : qFromLittleEndian<quint16>(head.constData() + 10);
    CaptureRecord record;
    if (head.size() == captureRecordHead) {
        record.time_us = qFromLittleEndian<quint64>(head.constData());
        const auto kind = qFromLittleEndian<quint16>(head.constData() + 8);
        record.kind = static_cast<CaptureKind>(kind);
        const auto most = static_cast<quint16>(m_version > 1 ? CaptureKind::Note : CaptureKind::Output);
        if (kind > most)
            return bad(m_name, m_at + 8, Words::tr("a record of kind %1").arg(kind),
                       Words::tr("expected a kind from 0 to %1").arg(most));
        if (record.kind != CaptureKind::Note && length > longestCapturedReport)
            return bad(m_name, m_at + 10, Words::tr("a report of %1 bytes").arg(length),
                       Words::tr("expected at most %1").arg(longestCapturedReport));
        if (record.time_us < m_lastTime)
            return bad(m_name, m_at, Words::tr("a time before that of the record in front"),
                       Words::tr("expected times in order"));
        if (record.time_us > latestCapturedTime_us)
            return bad(
                m_name, m_at,
                Words::tr("a record %1 s after the first").arg(1e-6 * static_cast<double>(record.time_us)),
                Words::tr("expected a session of less than a year"));
    }
    const QByteArray bytes = m_part->read(length);
    if (head.size() < captureRecordHead || bytes.size() < length) {
        m_left = head.size() + bytes.size();
        return std::optional<CaptureRecord>();
    }
    m_lastTime = record.time_us;
    m_at += captureRecordHead + length;
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.constData());
    record.bytes.assign(first, first + length);
    return record;
}

} // namespace gripscope
