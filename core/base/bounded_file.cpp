// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_file.h"

#include "core/base/words.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>

namespace gripscope {

namespace {

Finding tooLarge(qint64 most)
{
    return Words::say("it is larger than %1 MB").arg(static_cast<double>(most) / megabyte);
}

} // namespace

Expected<void> openRegular(QFile& file)
{
    const QFileInfo info(file.fileName());
    const auto unreadable = [&](const Finding& reason) {
        return failure(ErrorCode::FileUnreadable, {file.fileName(), reason});
    };
    if (info.isDir())
        return unreadable(Words::say("it is a folder"));
    // Opening a pipe would wait for somebody to write into it, and a device may never end.
    if (info.exists() && !info.isFile())
        return unreadable(Words::say("it is a pipe or a device and not a file"));
    if (!file.open(QIODevice::ReadOnly))
        return unreadable(file.errorString());
    return {};
}

Expected<QByteArray> readBounded(const QString& file, qint64 most)
{
    QFile in(file);
    RETURN_IF_ERROR(openRegular(in));
    if (in.size() > most)
        return failure(ErrorCode::FileUnreadable, {file, tooLarge(most)});
    // Its size is not always known in front (/proc), and it may grow meanwhile.
    constexpr qint64 piece = 65536;
    QByteArray bytes;
    bytes.reserve(in.size());
    while (bytes.size() <= most) {
        const QByteArray next = in.read(std::min(piece, most + 1 - bytes.size()));
        if (next.isEmpty())
            break;
        bytes += next;
    }
    if (in.error() != QFileDevice::NoError)
        return failure(ErrorCode::FileUnreadable, {file, in.errorString()});
    if (bytes.size() > most)
        return failure(ErrorCode::FileUnreadable, {file, tooLarge(most)});
    return bytes;
}

Expected<void> writeWhole(const QString& file, const QByteArray& bytes)
{
    QSaveFile output(file);
    if (!output.open(QIODevice::WriteOnly) || output.write(bytes) != bytes.size() || !output.commit())
        return failure(ErrorCode::FileUnwritable, {file, output.errorString()});
    return {};
}

} // namespace gripscope
