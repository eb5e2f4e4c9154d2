// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_session.h"

#include "core/base/words.h"
#include "devices/replay/capture_folder.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLoggingCategory>
#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<std::unique_ptr<CapturePart>> CapturePart::create(const QString& file, Existing existing)
{
    auto part = std::unique_ptr<CapturePart>(new CapturePart(file));
    const QIODevice::OpenMode mode =
        QIODevice::WriteOnly | QIODevice::Unbuffered |
        (existing == Existing::Refuse ? QIODevice::NewOnly : QIODevice::Truncate);
    if (!part->m_file.open(mode))
        return failure(ErrorCode::FileUnwritable, {file, part->m_file.errorString()});
    return part;
}

Expected<void> CapturePart::add(const char* bytes, qint64 size)
{
    qint64 done = 0;
    while (done < size) {
        const qint64 written = m_file.write(bytes + done, size - done);
        if (written <= 0) {
            const QString reason = m_file.errorString();
            if (!m_file.isSequential() && m_file.resize(m_size))
                m_file.seek(m_size);
            return failure(ErrorCode::FileUnwritable, {m_file.fileName(), reason});
        }
        done += written;
    }
    m_hash.addData(QByteArrayView(bytes, size));
    m_size += size;
    return {};
}

Expected<QString> CapturePart::close()
{
    m_file.close();
    if (m_file.error() != QFileDevice::NoError && !m_file.exists())
        return failure(ErrorCode::FileUnwritable, {m_file.fileName(), m_file.errorString()});
    return QString::fromLatin1(m_hash.result().toHex());
}

namespace {

Q_LOGGING_CATEGORY(logCapture, "gripscope.devices.capture")
constexpr std::chrono::milliseconds period{200}; ///< at most so much is lost when the program dies
constexpr std::chrono::seconds retryAfter{1};

QByteArray note(std::uint64_t time_us, const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    return encodeRecord(
        time_us, CaptureKind::Note,
        {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
}

std::uint64_t firstTime(const CaptureBuffer::Chunk& chunk)
{
    return qFromLittleEndian<quint64>(chunk.bytes.data());
}

} // namespace

CaptureSession::CaptureSession(CaptureDestination destination, QString session,
                               std::shared_ptr<CaptureMonitor> monitor)
    : m_destination(std::move(destination)), m_monitor(std::move(monitor)), m_session(std::move(session))
{
    m_monitor->begin(m_session);
}

Expected<void> CaptureSession::createFile()
{
    ASSIGN_OR_RETURN(std::unique_ptr<CapturePart> part,
                     CapturePart::create(m_destination.file, CapturePart::Existing::Replace));
    m_part = std::move(part);
    return {};
}

void CaptureSession::run(CaptureBuffer& buffer)
{
    Chunk chunk;
    while (buffer.take(chunk, period)) {
        keep(chunk, buffer);
        m_monitor->written(m_records, m_problem);
    }
    if (const Expected<void> closed = closePart(); !closed)
        meet(closed.error());
    m_monitor->written(m_records, m_problem);
}

void CaptureSession::meet(const Error& problem)
{
    if (!m_problem)
        qCWarning(logCapture, "raw reports are not kept: %s", qUtf8Printable(problem.describe()));
    m_problem = problem;
    m_notBefore = Clock::now() + retryAfter;
}

void CaptureSession::keep(const Chunk& chunk, const CaptureBuffer& buffer)
{
    const bool waiting = m_problem && Clock::now() < m_notBefore;
    const Expected<void> written = waiting || chunk.records == 0 ? Expected<void>() : write(chunk, buffer);
    if (!written)
        meet(written.error());
    else if (!waiting)
        m_problem.reset();
    if (waiting || !written) {
        m_monitor->dropped(chunk.records);
        m_untold += chunk.records;
        m_lostAny = true;
    }
    m_untold += chunk.droppedRecords; // those came behind the chunk
}

Expected<void> CaptureSession::write(const Chunk& chunk, const CaptureBuffer& buffer)
{
    const std::uint64_t time_us = firstTime(chunk);
    if (inFolder() && partIsDue()) {
        RETURN_IF_ERROR(closePart());
        // The first part gets its features as they come, unless they were lost.
        const QByteArray features = m_records > 0 || m_lostAny ? buffer.features(time_us) : QByteArray();
        RETURN_IF_ERROR(beginPart(features, time_us));
    }
    if (!m_part)
        return failure(ErrorCode::FileUnwritable, {m_destination.file, Words::tr("it is closed")});
    QByteArray before;
    if (m_part->size() == 0)
        before += captureHeader() + sessionNote(time_us);
    if (m_untold > 0)
        before += note(time_us, u"dropped\nrecords: %1\n"_s.arg(m_untold));
    RETURN_IF_ERROR(m_part->add(before.constData(), before.size()));
    m_untold = 0;
    const auto* bytes = reinterpret_cast<const char*>(chunk.bytes.data());
    RETURN_IF_ERROR(m_part->add(bytes, static_cast<qint64>(chunk.bytes.size())));
    m_records += chunk.records;
    m_partSqueezes += static_cast<qint64>(chunk.squeezes);
    return {};
}

bool CaptureSession::partIsDue() const
{
    return !m_part || !QFile::exists(m_part->file()) || m_part->size() >= m_destination.limits.partBytes ||
           Clock::now() - m_partBegan >= m_destination.limits.partTime;
}

Expected<void> CaptureSession::beginPart(const QByteArray& features, std::uint64_t time_us)
{
    const CaptureFolder folder(m_destination.folder);
    if (!QDir().mkpath(folder.path()))
        return failure(ErrorCode::FileUnwritable, {folder.path(), Words::tr("the folder cannot be made")});
    const qint64 room = m_destination.limits.totalBytes - m_destination.limits.partBytes;
    const CaptureFolder::Pruned pruned = folder.prune(room);
    tellPruning(pruned.removed); // also of those that went before it ended
    RETURN_IF_ERROR(pruned.problem);
    const QString name = u"%1.part%2.gscap"_s.arg(m_session).arg(m_parts + 1, 4, 10, QLatin1Char('0'));
    ASSIGN_OR_RETURN(std::unique_ptr<CapturePart> part,
                     CapturePart::create(folder.filePath(name), CapturePart::Existing::Refuse));
    m_part = std::move(part);
    ++m_parts;
    m_partBegan = Clock::now();
    m_partSqueezes = 0;
    const QByteArray head = captureHeader() + sessionNote(time_us) + features;
    return m_part->add(head.constData(), head.size());
}

void CaptureSession::tellPruning(const std::vector<CaptureFolder::Part>& removed)
{
    if (removed.empty())
        return;
    CapturePruning pruning{m_destination.folder, {}, 0, 0};
    for (const CaptureFolder::Part& part : removed) {
        pruning.parts << part.name;
        pruning.bytes += part.bytes;
        pruning.squeezes += part.squeezes.value_or(0);
    }
    m_monitor->pruned(pruning);
}

QByteArray CaptureSession::sessionNote(std::uint64_t time_us) const
{
    return note(time_us, u"session\nname: %1\npart: %2\naddress: %3\nwritten_utc: %4\nprogram: %5\n"_s.arg(
                             m_session, QString::number(std::max(1, m_parts)), m_destination.address,
                             QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs),
                             u"gripscope "_s + QCoreApplication::applicationVersion()));
}

Expected<void> CaptureSession::closePart()
{
    if (!m_part)
        return {};
    const std::unique_ptr<CapturePart> part = std::move(m_part);
    const qint64 bytes = part->size();
    const Expected<QString> hash = part->close();
    if (!hash || !inFolder())
        return hash.map([](const QString&) {});
    if (!QFile::exists(part->file()))
        return failure(ErrorCode::FileUnwritable,
                       {part->file(), Words::tr("it was removed while it was written")});
    return CaptureFolder(m_destination.folder)
        .list({QFileInfo(part->file()).fileName(), bytes, *hash, m_partSqueezes});
}

} // namespace gripscope
