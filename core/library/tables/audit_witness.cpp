// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/audit_witness.h"

#include "core/library/tables/audit_table.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>

namespace gripscope {

using namespace Qt::StringLiterals;

QString witnessFile(const QString& libraryFile)
{
    const QFileInfo info(libraryFile);
    const QString place = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
    const QByteArray name = QCryptographicHash::hash(place.toUtf8(), QCryptographicHash::Sha256).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           u"/gripscope/audit/%1.json"_s.arg(QString::fromLatin1(name.left(32)));
}

std::optional<AuditHead> readWitness(const QString& libraryFile)
{
    QFile file(witnessFile(libraryFile));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject known = QJsonDocument::fromJson(file.readAll()).object();
    const AuditHead head{known.value(u"entries"_s).toInteger(), known.value(u"hash"_s).toString()};
    return head.entries > 0 && !head.hash.isEmpty() ? std::optional(head) : std::nullopt;
}

void tellWitness(Database& database)
{
    const AuditHead head = *database.newAuditHead();
    if (const auto known = readWitness(database.file())) {
        const auto there = audit_table::hashOf(database, known->entries);
        if (!there || *there != known->hash)
            return;
    }
    const QString name = witnessFile(database.file());
    QDir().mkpath(QFileInfo(name).path());
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly))
        return;
    file.write(QJsonDocument(QJsonObject{{u"library"_s, QFileInfo(database.file()).absoluteFilePath()},
                                         {u"entries"_s, head.entries},
                                         {u"hash"_s, head.hash}})
                   .toJson());
    static_cast<void>(file.commit());
}

PassingLibrary::~PassingLibrary()
{
    QFile::remove(witnessFile(m_file));
}

} // namespace gripscope
