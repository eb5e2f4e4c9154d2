// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/backup/library_swap.h"

#include "core/base/brief_lock.h"

#include <QFile>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A log whose library is gone would be played into the one that takes its name. It is kept beside it.
bool setForeignLogAside(const QString& library)
{
    for (const QString& part : {u"-wal"_s, u"-shm"_s, u"-journal"_s}) {
        if (!QFile::exists(library + part))
            continue;
        QString kept = library + u".before"_s + part;
        for (int again = 2; QFile::exists(kept); ++again)
            kept = library + u".before-%1"_s.arg(again) + part;
        if (!QFile::rename(library + part, kept))
            return false;
    }
    return true;
}

} // namespace

QString nextInPlace(const QString& library)
{
    return library + u".restored"_s;
}

bool finishSwap(const QString& library)
{
    const QString next = nextInPlace(library);
    if (QFile::exists(library) || !QFile::exists(next))
        return QFile::exists(library);
    // Two programs that start at once do it once: the log of the one that was quicker is the library's own.
    BriefLock lock(next + u".lock"_s);
    if (!lock.take() || QFile::exists(library))
        return QFile::exists(library);
    return setForeignLogAside(library) && QFile::rename(next, library);
}

} // namespace gripscope
