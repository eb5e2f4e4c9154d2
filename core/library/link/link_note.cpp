// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_file.h"
#include "core/base/words.h"
#include "core/library/link/shared_link.h"
#include "core/library/sql/library_location.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr qint64 longestNote_bytes = 1'000'000; // a line a chain; a station has a few
}

QString linkNoteFile(const QString& library)
{
    return fileWithLibrary(library, u".plant"_s);
}

std::optional<LinkNote> readLinkNote(const QString& file, const QString& server)
{
    const Expected<QByteArray> bytes = readBounded(file, longestNote_bytes);
    if (!bytes)
        return {};
    const QJsonObject document = QJsonDocument::fromJson(*bytes).object();
    LinkNote note{document[u"server"_s].toString(),
                  QDateTime::fromString(document[u"last_reached_utc"_s].toString(), Qt::ISODateWithMs),
                  {}};
    if (note.server != server)
        return {};
    const QJsonObject delivered = document[u"delivered_links"_s].toObject();
    for (auto chain = delivered.begin(); chain != delivered.end(); ++chain)
        note.delivered[chain.key()] = chain.value().toInteger();
    return note;
}

Expected<void> writeLinkNote(const QString& file, const LinkNote& note)
{
    QJsonObject delivered;
    for (const auto& [chain, links] : note.delivered)
        delivered.insert(chain, links);
    const QJsonObject document{{u"server"_s, note.server},
                               {u"last_reached_utc"_s, note.lastReached.toUTC().toString(Qt::ISODateWithMs)},
                               {u"delivered_links"_s, delivered}};
    QSaveFile to(file);
    const QByteArray bytes = QJsonDocument(document).toJson();
    if (!to.open(QIODevice::WriteOnly) || to.write(bytes) != bytes.size() || !to.commit())
        return failure(ErrorCode::StorageFailed,
                       {Words::tr("note how far the server is"), file + u": "_s + to.errorString()});
    return {};
}

} // namespace gripscope
