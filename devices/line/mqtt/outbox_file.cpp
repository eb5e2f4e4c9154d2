// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/outbox_file.h"

#include "core/base/words.h"
#include "core/library/sql/synced_names.h"

#include <QFile>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 mostReadOfOutbox = qint64(64) * 1024 * 1024; ///< far above what the bound of an outbox takes

int openedAndLocked(const QByteArray& path)
{
    const int descriptor =
        ::open(path.constData(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_CREAT, 0600);
    if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        close(descriptor);
        errno = reason;
        return -1;
    }
    return descriptor;
}

bool isNamedSo(int descriptor, const QByteArray& path)
{
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && stat(path.constData(), &named) == 0 &&
           S_ISREG(opened.st_mode) && opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

bool wroteAll(int descriptor, const QByteArray& bytes, qint64 at)
{
    qint64 put = 0;
    while (put < bytes.size()) {
        const ssize_t wrote =
            pwrite(descriptor, bytes.constData() + put, static_cast<std::size_t>(bytes.size() - put),
                   static_cast<off_t>(at + put));
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote <= 0)
            return false;
        put += wrote;
    }
    return true;
}

} // namespace

Expected<std::unique_ptr<OutboxFile>> OutboxFile::open(const QString& name)
{
    const QByteArray path = QFile::encodeName(name);
    const int descriptor = openedAndLocked(path);
    if (descriptor < 0 && errno == EWOULDBLOCK)
        return nullptr;
    if (descriptor < 0)
        return failure(ErrorCode::FileUnwritable, {name, qt_error_string(errno)});
    std::unique_ptr<OutboxFile> file(new OutboxFile(name, descriptor));
    if (!isNamedSo(descriptor, path)) // no plain file, or another program just put a new one there
        return failure(ErrorCode::FileUnwritable, {name, Words::say("it is not the program's own file")});
    RETURN_IF_ERROR(file->load());
    return file;
}

OutboxFile::~OutboxFile()
{
    close(m_descriptor);
}

tl::unexpected<Error> OutboxFile::failed() const
{
    return failure(ErrorCode::FileUnwritable, {m_name, qt_error_string(errno)});
}

Expected<void> OutboxFile::load()
{
    QFile reader;
    if (!reader.open(m_descriptor, QIODevice::ReadOnly, QFileDevice::DontCloseHandle))
        return failure(ErrorCode::FileUnreadable, {m_name, reader.errorString()});
    const QByteArray bytes = reader.read(mostReadOfOutbox);
    qsizetype end = 0;
    m_contents = readOutbox(bytes, end);
    if (m_contents.damaged || end == 0)
        return compact(); // a new file, or all that can be read of a damaged one
    m_size = end;
    if (ftruncate(m_descriptor, static_cast<off_t>(end)) != 0)
        return failed();
    m_needed = outboxHead().size();
    for (const Waiting& one : m_contents.waiting)
        m_needed += packedSize(one.bytes);
    return compactIfItPays();
}

Expected<void> OutboxFile::append(const QByteArray& record, bool now)
{
    if (!wroteAll(m_descriptor, record, m_size) || (now && fdatasync(m_descriptor) != 0))
        return failed(); // what stands there is written over by the next
    m_size += record.size();
    return {};
}

Expected<std::uint64_t> OutboxFile::add(const QByteArray& bytes)
{
    if (bytes.size() > longestRecord)
        return failure(ErrorCode::FileUnwritable, {m_name, Words::say("one result is too long")});
    const std::uint64_t sequence = m_contents.next;
    RETURN_IF_ERROR(append(packed({OutboxKind::Result, sequence, bytes}), true));
    ++m_contents.next;
    m_contents.waiting.push_back({sequence, bytes});
    m_needed += packedSize(bytes);
    return sequence;
}

Expected<void> OutboxFile::skip()
{
    RETURN_IF_ERROR(append(packed({OutboxKind::Next, m_contents.next + 1, {}}), false));
    ++m_contents.next;
    return compactIfItPays();
}

Expected<void> OutboxFile::acknowledge(std::uint64_t sequence)
{
    // Not waited for: one that comes back after a power cut is sent twice, and told by its sequence.
    RETURN_IF_ERROR(append(packed({OutboxKind::Acknowledged, sequence, {}}), false));
    while (!m_contents.waiting.empty() && m_contents.waiting.front().sequence <= sequence) {
        m_needed -= packedSize(m_contents.waiting.front().bytes);
        m_contents.waiting.pop_front();
    }
    return compactIfItPays();
}

Expected<std::uint8_t> OutboxFile::nextBirth()
{
    const auto birth = static_cast<std::uint8_t>(m_contents.birth + 1); // 255 is followed by 0
    RETURN_IF_ERROR(append(packed({OutboxKind::Birth, birth, {}}), true));
    m_contents.birth = birth;
    RETURN_IF_ERROR(compactIfItPays());
    return birth;
}

Expected<void> OutboxFile::compactIfItPays()
{
    return m_size > leastCompacted && m_size > 2 * m_needed ? compact() : Expected<void>();
}

Expected<void> OutboxFile::compact()
{
    QByteArray bytes = outboxHead();
    bytes += packed({OutboxKind::Birth, m_contents.birth, {}});
    for (const Waiting& one : m_contents.waiting)
        bytes += packed({OutboxKind::Result, one.sequence, one.bytes});
    bytes += packed({OutboxKind::Next, m_contents.next, {}});
    const QString made = m_name + u".new"_s;
    const QByteArray path = QFile::encodeName(made);
    unlink(path.constData()); // of a program that was killed; who has the lock of the file itself may
    const int descriptor = openedAndLocked(path);
    if (descriptor < 0)
        return failure(ErrorCode::FileUnwritable, {made, qt_error_string(errno)});
    if (!wroteAll(descriptor, bytes, 0) || fdatasync(descriptor) != 0 ||
        rename(path.constData(), QFile::encodeName(m_name).constData()) != 0) {
        const tl::unexpected<Error> why = failed();
        close(descriptor);
        return why;
    }
    syncNames(m_name);
    close(m_descriptor);
    m_descriptor = descriptor;
    m_size = m_needed = bytes.size();
    return {};
}

} // namespace gripscope
