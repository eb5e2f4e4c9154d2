// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_writer.h"

#include "core/base/words.h"
#include "devices/replay/capture_folder.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QLoggingCategory>
#include <QRandomGenerator>
#include <QtEndian>

#include <algorithm>

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

/// A file that a capture is written to, with its SHA-256 as it grows. Bytes are added whole or not at all.
class CapturePart {
public:
    enum class Existing { Replace, Refuse };
    /// FileUnwritable.
    [[nodiscard]] static Expected<std::unique_ptr<CapturePart>> create(const QString& file,
                                                                       Existing existing);

    /// FileUnwritable: nothing of them is in the file then, as far as the system allows it to be taken back.
    [[nodiscard]] Expected<void> add(const char* bytes, qint64 size);
    /// Closes the file; its SHA-256 in hexadecimal.
    [[nodiscard]] Expected<QString> close();

    [[nodiscard]] qint64 size() const { return m_size; }
    [[nodiscard]] QString file() const { return m_file.fileName(); }

private:
    explicit CapturePart(const QString& file) : m_file(file), m_hash(QCryptographicHash::Sha256) {}

    QFile m_file;
    QCryptographicHash m_hash;
    qint64 m_size = 0;
};

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

/// One session on its way into its files: opens parts, closes and lists them, makes room for them. The
/// writing thread's own.
class CaptureSession {
public:
    CaptureSession(CaptureDestination destination, QString session, std::shared_ptr<CaptureMonitor> monitor);

    /// The first file of a session that has one file only.
    [[nodiscard]] Expected<void> createFile();
    /// Takes what `buffer` gets until it is finished.
    void run(CaptureBuffer& buffer);

private:
    using Clock = std::chrono::steady_clock;
    using Chunk = CaptureBuffer::Chunk;

    void keep(const Chunk& chunk, const CaptureBuffer& buffer);
    [[nodiscard]] Expected<void> write(const Chunk& chunk, const CaptureBuffer& buffer);
    [[nodiscard]] Expected<void> beginPart(const QByteArray& features, std::uint64_t time_us);
    void tellPruning(const std::vector<CaptureFolder::Part>& removed);
    [[nodiscard]] Expected<void> closePart();
    [[nodiscard]] bool partIsDue() const;
    [[nodiscard]] QByteArray sessionNote(std::uint64_t time_us) const;
    [[nodiscard]] bool inFolder() const { return !m_destination.folder.isEmpty(); }
    void meet(const Error& problem);

    const CaptureDestination m_destination;
    const std::shared_ptr<CaptureMonitor> m_monitor;
    const QString m_session;
    std::uint64_t m_records = 0; ///< in files
    bool m_lostAny = false;
    std::optional<Error> m_problem;
    std::unique_ptr<CapturePart> m_part;
    int m_parts = 0;
    Clock::time_point m_partBegan;
    qint64 m_partSqueezes = 0;
    std::uint64_t m_untold = 0;    ///< dropped records that the capture does not tell of yet
    Clock::time_point m_notBefore; ///< when a disk that failed is tried again
};

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

/// In order of time, and no other's.
QString newSessionName()
{
    return QDateTime::currentDateTimeUtc().toString(u"yyyyMMddThhmmsszzzZ"_s) +
           u"-%1"_s.arg(QRandomGenerator::global()->bounded(0x10000), 4, 16, QLatin1Char('0'));
}

} // namespace

Expected<std::unique_ptr<CaptureWriter>> CaptureWriter::create(const CaptureDestination& destination,
                                                               std::shared_ptr<CaptureMonitor> monitor)
{
    const QString session = destination.folder.isEmpty() ? QString() : newSessionName();
    if (!monitor)
        monitor = std::make_shared<CaptureMonitor>();
    auto writing = std::make_shared<CaptureSession>(destination, session, monitor);
    if (!destination.file.isEmpty())
        RETURN_IF_ERROR(writing->createFile());
    auto buffer = std::make_shared<CaptureBuffer>(destination.limits.bufferBytes, std::move(monitor));
    return std::unique_ptr<CaptureWriter>(
        new CaptureWriter(buffer, session, BoundedThread([writing, buffer] { writing->run(*buffer); })));
}

CaptureWriter::CaptureWriter(std::shared_ptr<CaptureBuffer> buffer, QString session, BoundedThread thread)
    : m_buffer(std::move(buffer)), m_session(std::move(session)), m_thread(std::move(thread))
{
}

CaptureWriter::~CaptureWriter()
{
    m_buffer->finish();
}

void CaptureWriter::add(CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    m_buffer->add(kind, bytes);
}

bool CaptureWriter::finishBy(std::chrono::steady_clock::time_point deadline)
{
    m_buffer->finish();
    return m_thread.finishBy(deadline);
}

} // namespace gripscope
