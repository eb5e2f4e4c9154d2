// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/spill_file.h"

#include "core/base/byte_writer.h"
#include "core/base/words.h"
#include "core/library/ledger/row_digest.h"
#include "core/library/sql/synced_names.h"
#include "core/library/sql/time_ordered_id.h"

#include <QFile>
#include <QtEndian>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView fileMagic = "GSPL";
constexpr QByteArrayView blockMagic = "GSBK";
constexpr quint32 fileVersion = 1;
constexpr qint64 firstBlock = 4096;
constexpr qint64 headBytes = 64;
constexpr qint64 digestBytes = digestSize;
constexpr qint64 checkBytes = 8;
constexpr quint32 blockWaits = 1;
constexpr quint32 blockDone = 2;
constexpr qint64 stateAt = 4, lengthAt = 8, digestAt = 16, checkAt = 48; // within the head of a block
constexpr qint64 ownerAt = 10;                                           // behind magic, version, length
constexpr int openTries = 10; ///< it may be taken away between being opened and being locked

/// Where the block behind one of so many bytes begins.
qint64 behind(qint64 place, qint64 bytes)
{
    return place + headBytes + (bytes + headBytes - 1) / headBytes * headBytes;
}

QByteArray fileHead(const QByteArray& owner)
{
    const QByteArray head = ByteWriter()
                                .plain(fileMagic)
                                .number(fileVersion)
                                .number(static_cast<quint16>(owner.size()))
                                .plain(owner)
                                .bytes();
    return head + digestOf(head);
}

/// Length and digest, the part of a head that never changes.
QByteArray checked(qint64 length, const QByteArray& digest)
{
    return ByteWriter().number(static_cast<quint64>(length)).plain(digest).bytes();
}

QByteArray blockHead(const QByteArray& bytes)
{
    const QByteArray fixed = checked(bytes.size(), digestOf(bytes));
    const QByteArray head = ByteWriter()
                                .plain(blockMagic)
                                .number(blockWaits)
                                .plain(fixed)
                                .plain(digestOf(fixed).left(checkBytes))
                                .bytes();
    return head.leftJustified(headBytes, '\0');
}

struct BlockHead {
    quint32 state = 0;
    qint64 length = 0;
    QByteArray digest;
};

/// Nothing for what blockHead() does not make.
std::optional<BlockHead> readHead(const QByteArray& head, qint64 most)
{
    if (!head.startsWith(blockMagic))
        return {};
    const auto length = qFromBigEndian<quint64>(head.constData() + lengthAt);
    if (length > static_cast<quint64>(most))
        return {};
    const BlockHead found{qFromBigEndian<quint32>(head.constData() + stateAt), static_cast<qint64>(length),
                          head.mid(digestAt, digestBytes)};
    const bool known = found.state == blockWaits || found.state == blockDone;
    const bool whole =
        head.mid(checkAt, checkBytes) == digestOf(checked(found.length, found.digest)).left(checkBytes);
    return known && whole ? std::optional(found) : std::nullopt;
}

/// The bytes of the whole file, which is small; nothing where it cannot be read.
std::optional<QByteArray> wholeFile(int descriptor)
{
    QByteArray bytes(SpillFile::size, '\0');
    qint64 got = 0;
    while (got < bytes.size()) {
        const ssize_t now = pread(descriptor, bytes.data() + got,
                                  static_cast<std::size_t>(bytes.size() - got), static_cast<off_t>(got));
        if (now < 0 && errno == EINTR)
            continue;
        if (now < 0)
            return {};
        if (now == 0)
            break;
        got += now;
    }
    bytes.truncate(got);
    return bytes;
}

/// The owner that a file's first bytes name; nothing where they are not such.
std::optional<QByteArray> ownerIn(const QByteArray& bytes)
{
    if (bytes.size() < firstBlock || !bytes.startsWith(fileMagic) ||
        qFromBigEndian<quint32>(bytes.constData() + fileMagic.size()) != fileVersion)
        return {};
    const auto length = qFromBigEndian<quint16>(bytes.constData() + ownerAt - 2);
    if (ownerAt + length + digestBytes > firstBlock)
        return {};
    const QByteArray owner = bytes.mid(ownerAt, length);
    return bytes.startsWith(fileHead(owner)) ? std::optional(owner) : std::nullopt;
}

bool onlyZeros(const QByteArray& bytes)
{
    return bytes.count('\0') == bytes.size();
}

bool sameFile(int descriptor, const QByteArray& name)
{
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && stat(name.constData(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

tl::unexpected<Error> unwritable(const QString& name, const Finding& reason)
{
    return failure(ErrorCode::FileUnwritable, {name, reason});
}

} // namespace

Expected<std::unique_ptr<SpillFile>> SpillFile::open(const QString& name, Missing missing)
{
    const QByteArray path = QFile::encodeName(name);
    const int make = missing == Missing::Make ? O_CREAT : 0;
    for (int attempt = 0; attempt < openTries; ++attempt) {
        // Without waiting, in case it is a pipe.
        const int descriptor =
            ::open(path.constData(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | make, 0600);
        if (descriptor < 0 && errno == ENOENT && make == 0)
            return nullptr;
        if (descriptor < 0)
            return unwritable(name, qt_error_string(errno));
        std::unique_ptr<SpillFile> file(new SpillFile(name, descriptor));
        struct stat found {};
        if (fstat(descriptor, &found) != 0)
            return file->failed();
        if (!S_ISREG(found.st_mode))
            return unwritable(name, Words::say("it is a pipe or a device and not a file"));
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK)
                return nullptr;
            return file->failed();
        }
        // Who had it before may have taken it away just now.
        if (sameFile(descriptor, path))
            return file;
    }
    return nullptr;
}

SpillFile::~SpillFile()
{
    int gone = 0; // what cannot be done here does no harm: the next program looks again
    if (!m_keep && m_waiting > 0)
        gone = ftruncate(m_descriptor, static_cast<off_t>(m_end + headBytes));
    else if (!m_keep && sameFile(m_descriptor, QFile::encodeName(m_name)))
        gone = unlink(QFile::encodeName(m_name).constData());
    static_cast<void>(gone);
    close(m_descriptor);
}

tl::unexpected<Error> SpillFile::failed() const
{
    return unwritable(m_name, qt_error_string(errno));
}

Expected<SpillFile::Contents> SpillFile::read() const
{
    const std::optional<QByteArray> bytes = wholeFile(m_descriptor);
    if (!bytes)
        return failure(ErrorCode::FileUnreadable, {m_name, qt_error_string(errno)});
    Contents contents;
    contents.end = firstBlock;
    if (onlyZeros(bytes->left(firstBlock + headBytes))) // a new file, or one whose first owner got no further
        return contents;
    const std::optional<QByteArray> owner = ownerIn(*bytes);
    contents.damaged = !owner;
    contents.owner = owner.value_or(QByteArray());
    while (!contents.damaged && contents.end + headBytes <= bytes->size()) {
        const QByteArray head = bytes->mid(contents.end, headBytes);
        if (onlyZeros(head))
            break;
        const auto block = readHead(head, bytes->size() - contents.end - headBytes);
        const QByteArray held = block ? bytes->mid(contents.end + headBytes, block->length) : QByteArray();
        contents.damaged = !block || digestOf(held) != block->digest;
        if (contents.damaged)
            break;
        if (block->state == blockWaits)
            contents.waiting.push_back({contents.end, held});
        contents.end = behind(contents.end, block->length);
    }
    return contents;
}

Expected<void> SpillFile::prepare(const QByteArray& owner, const Contents& contents)
{
    if (contents.waiting.empty()) // whatever stood there is no longer of use
        if (ftruncate(m_descriptor, 0) != 0)
            return failed();
    m_end = contents.waiting.empty() ? firstBlock : contents.end;
    m_waiting = contents.waiting.size();
    m_keep = false;
    if (const int problem = posix_fallocate(m_descriptor, 0, static_cast<off_t>(size)); problem != 0)
        return unwritable(m_name, qt_error_string(problem));
    RETURN_IF_ERROR(write(0, fileHead(owner), false));
    RETURN_IF_ERROR(write(m_end, QByteArray(headBytes, '\0'), true));
    syncNames(m_name); // it may be new
    return {};
}

Expected<void> SpillFile::write(qint64 at, const QByteArray& bytes, bool now)
{
    qint64 put = 0;
    while (put < bytes.size()) {
        const ssize_t wrote =
            pwrite(m_descriptor, bytes.constData() + put, static_cast<std::size_t>(bytes.size() - put),
                   static_cast<off_t>(at + put));
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote <= 0)
            return failed();
        put += wrote;
    }
    if (now && fdatasync(m_descriptor) != 0)
        return failed();
    return {};
}

qint64 SpillFile::room() const
{
    return std::max<qint64>(0, size - m_end - 3 * headBytes); // its head, its last bytes filled up, the end
}

Expected<qint64> SpillFile::add(const QByteArray& bytes)
{
    if (bytes.size() > room())
        return unwritable(m_name, Words::say("it is full"));
    const qint64 place = m_end;
    const qint64 next = behind(place, bytes.size());
    // Zeros to the end of the next head: what stood there is none.
    const QByteArray body = bytes.leftJustified(next + headBytes - place - headBytes, '\0');
    RETURN_IF_ERROR(write(place + headBytes, body, true));
    RETURN_IF_ERROR(write(place, blockHead(bytes), true));
    m_end = next;
    ++m_waiting;
    return place;
}

Expected<void> SpillFile::remove(qint64 place)
{
    // Not waited for: one that comes back after a power cut is stored by its key, which is once.
    RETURN_IF_ERROR(write(place + stateAt, ByteWriter().number(blockDone).bytes(), false));
    if (--m_waiting > 0)
        return {};
    m_end = firstBlock;
    return write(firstBlock, QByteArray(headBytes, '\0'), false);
}

void SpillFile::discard()
{
    m_keep = false;
    m_waiting = 0;
}

Expected<QString> SpillFile::setAside()
{
    const QString kept = m_name + u".kept-"_s + newTimeOrderedId();
    if (rename(QFile::encodeName(m_name).constData(), QFile::encodeName(kept).constData()) != 0)
        return failed();
    syncNames(kept);
    m_keep = true;
    return kept;
}

} // namespace gripscope
