// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_folder.h"

#include "core/base/bounded_file.h"
#include "core/base/brief_lock.h"
#include "core/base/words.h"
#include "devices/replay/capture_reader.h"

#include <QCryptographicHash>
#include <QDir>
#include <QRegularExpression>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>
#include <map>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QString listName = u"SHA256SUMS"_s;
constexpr qint64 largestList = 16 * megabyte; ///< of a hundred thousand parts

tl::unexpected<Error> cannotList(const QString& reason)
{
    return failure(ErrorCode::StorageFailed, {Words::tr("list the kept captures"), reason});
}

struct Listed {
    QString hash;
    std::optional<qint64> squeezes;
};

/// What the list says of each name.
std::map<QString, Listed> readList(const QString& file)
{
    static const QRegularExpression comment(u"^# (\\S+): (\\d+) squeezes$"_s);
    static const QRegularExpression entry(u"^([0-9a-f]{64})  (\\S+)$"_s);
    std::map<QString, Listed> listed;
    const Expected<QByteArray> text = readBounded(file, largestList);
    if (!text)
        return listed;
    for (const QString& line : QString::fromUtf8(*text).split(u'\n')) {
        if (const auto match = comment.match(line); match.hasMatch())
            listed[match.captured(1)].squeezes = match.captured(2).toLongLong();
        if (const auto match = entry.match(line); match.hasMatch())
            listed[match.captured(2)].hash = match.captured(1);
    }
    return listed;
}

QByteArray listLines(const CaptureFolder::Part& part)
{
    return u"# %1: %2 squeezes\n%3  %1\n"_s.arg(part.name)
        .arg(part.squeezes.value_or(0))
        .arg(part.hash)
        .toUtf8();
}

/// Whole records of one part and what is wrong with the rest, in words.
CaptureFolder::Checked checkRecords(CaptureFolder::Checked checked, const QString& file)
{
    using Condition = CaptureFolder::Condition;
    Expected<CaptureReader> reader = CaptureReader::openPart(file);
    checked.condition = Condition::Unreadable;
    if (!reader) {
        checked.words = reader.error().describe();
        return checked;
    }
    for (qint64 records = 0;; ++records) {
        const Expected<std::optional<CaptureRecord>> record = reader->next();
        if (!record) {
            checked.words = record.error().describe();
            return checked;
        }
        if (*record)
            continue;
        checked.condition = Condition::NotClosed;
        checked.words = Words::tr("not closed: it is being written, or its program ended; %1 whole records, "
                                  "%2 bytes behind them")
                            .arg(records)
                            .arg(reader->bytesLeft());
        return checked;
    }
}

} // namespace

QString CaptureFolder::defaultPath()
{
    const QString named = qEnvironmentVariable("GRIPSCOPE_CAPTURES");
    return named.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                                 u"/gripscope/captures"_s
                           : named;
}

QString CaptureFolder::filePath(const QString& name) const
{
    return QDir(m_path).filePath(name);
}

std::vector<CaptureFolder::Part> CaptureFolder::parts() const
{
    const std::map<QString, Listed> listed = readList(filePath(listName));
    std::vector<Part> parts;
    for (const QFileInfo& file : QDir(m_path).entryInfoList({u"*.part*.gscap"_s}, QDir::Files, QDir::Name)) {
        Part part{file.fileName(), file.size(), {}, {}};
        if (const auto found = listed.find(part.name); found != listed.end()) {
            part.hash = found->second.hash;
            part.squeezes = found->second.squeezes;
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

CaptureFolder::Checked CaptureFolder::check(const Part& part) const
{
    Checked checked{part, Condition::Whole, u"whole"_s};
    if (!part.closed())
        return checkRecords(std::move(checked), filePath(part.name));
    QFile in(filePath(part.name));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const Expected<void> opened = openRegular(in);
    if (!opened || !hash.addData(&in)) {
        checked.condition = Condition::Unreadable;
        checked.words =
            (opened ? Error{ErrorCode::FileUnreadable, {in.fileName(), in.errorString()}} : opened.error())
                .describe();
    } else if (QString::fromLatin1(hash.result().toHex()) != part.hash) {
        checked.condition = Condition::Changed;
        checked.words = Words::tr("changed since it was closed: its SHA-256 is not the one listed");
    }
    return checked;
}

Expected<void> CaptureFolder::list(const Part& closed) const
{
    BriefLock lock(filePath(u"captures.lock"_s));
    if (!lock.take())
        return cannotList(Words::tr("another program holds %1").arg(filePath(u"captures.lock"_s)));
    QFile out(filePath(listName));
    const QByteArray lines = listLines(closed);
    if (!out.open(QIODevice::WriteOnly | QIODevice::Append) || out.write(lines) != lines.size() ||
        !out.flush())
        return cannotList(out.errorString());
    return {};
}

CaptureFolder::Pruned CaptureFolder::prune(qint64 most, const QString& keep) const
{
    BriefLock lock(filePath(u"captures.lock"_s));
    if (!lock.take())
        return {{},
                cannotList(Words::tr("another program holds %1").arg(filePath(u"captures.lock"_s))).value()};
    std::vector<Part> known = parts();
    qint64 total = 0;
    for (const Part& part : known)
        total += part.bytes;
    std::stable_partition(known.begin(), known.end(), [](const Part& part) { return part.squeezes == 0; });
    Pruned pruned;
    for (const Part& part : known) {
        if (total <= most)
            break;
        if (part.name == keep)
            continue;
        if (!QFile::remove(filePath(part.name))) {
            pruned.problem = Error{
                ErrorCode::FileUnwritable,
                {filePath(part.name), Words::tr("it cannot be removed to make room for newer captures")}};
            break;
        }
        total -= part.bytes;
        pruned.removed.push_back(part);
    }
    // What went is listed no longer, whatever else happened.
    if (!pruned.removed.empty())
        if (const auto rewritten = rewriteList(pruned.removed); !rewritten && !pruned.problem)
            pruned.problem = rewritten.error();
    return pruned;
}

Expected<void> CaptureFolder::rewriteList(const std::vector<Part>& removed) const
{
    std::map<QString, Listed> listed = readList(filePath(listName));
    for (const Part& part : removed)
        listed.erase(part.name);
    QSaveFile out(filePath(listName));
    QByteArray lines;
    for (const auto& entry : listed)
        if (!entry.second.hash.isEmpty())
            lines += listLines({entry.first, 0, entry.second.hash, entry.second.squeezes});
    if (!out.open(QIODevice::WriteOnly) || out.write(lines) != lines.size() || !out.commit())
        return cannotList(out.errorString());
    return {};
}

} // namespace gripscope
