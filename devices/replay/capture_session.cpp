// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_session.h"

#include "core/words.h"
#include "devices/replay/capture_folder.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLoggingCategory>
#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

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
    Expected<std::unique_ptr<CapturePart>> part =
        CapturePart::create(m_destination.file, CapturePart::Existing::Replace);
    if (!part)
        return tl::unexpected<Error>(part.error());
    m_part = std::move(*part);
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
        if (const Expected<void> closed = closePart(); !closed)
            return closed;
        // The first part gets its features as they come, unless they were lost.
        const QByteArray features = m_records > 0 || m_lostAny ? buffer.features(time_us) : QByteArray();
        if (const Expected<void> begun = beginPart(features, time_us); !begun)
            return begun;
    }
    if (!m_part)
        return failure(ErrorCode::FileUnwritable, {m_destination.file, Words::tr("it is closed")});
    QByteArray before;
    if (m_part->size() == 0)
        before += captureHeader() + sessionNote(time_us);
    if (m_untold > 0)
        before += note(time_us, u"dropped\nrecords: %1\n"_s.arg(m_untold));
    if (const Expected<void> told = m_part->add(before.constData(), before.size()); !told)
        return told;
    m_untold = 0;
    const auto* bytes = reinterpret_cast<const char*>(chunk.bytes.data());
    if (const Expected<void> added = m_part->add(bytes, static_cast<qint64>(chunk.bytes.size())); !added)
        return added;
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
    if (const auto pruned = folder.prune(room); !pruned)
        return tl::unexpected<Error>(pruned.error());
    const QString name = u"%1.part%2.gscap"_s.arg(m_session).arg(m_parts + 1, 4, 10, QLatin1Char('0'));
    Expected<std::unique_ptr<CapturePart>> part =
        CapturePart::create(folder.filePath(name), CapturePart::Existing::Refuse);
    if (!part)
        return tl::unexpected<Error>(part.error());
    m_part = std::move(*part);
    ++m_parts;
    m_partBegan = Clock::now();
    m_partSqueezes = 0;
    const QByteArray head = captureHeader() + sessionNote(time_us) + features;
    return m_part->add(head.constData(), head.size());
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
