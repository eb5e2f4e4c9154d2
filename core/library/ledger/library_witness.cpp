// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/library_witness.h"

#include "core/base/bounded_file.h"
#include "core/base/brief_lock.h"
#include "core/base/words.h"
#include "core/library/sql/library_location.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr auto lockSuffix = ".lock"_L1;

QJsonObject toJson(const ChainEnd& end)
{
    return {{u"links"_s, end.links}, {u"hash"_s, QString::fromLatin1(end.hash.toHex())}};
}

/// What both the library and a backup end with.
void putEnds(QJsonObject& document, const std::optional<AuditHead>& audit,
             const std::map<QString, ChainEnd>& ends)
{
    if (audit) {
        document.insert(u"entries"_s, audit->entries);
        document.insert(u"hash"_s, audit->hash);
    }
    QJsonObject chains;
    for (const auto& [name, end] : ends)
        chains.insert(name, toJson(end));
    if (!chains.isEmpty())
        document.insert(u"chains"_s, chains);
}

std::optional<AuditHead> auditFrom(const QJsonObject& document)
{
    const AuditHead audit{document.value(u"entries"_s).toInteger(), document.value(u"hash"_s).toString()};
    return audit.entries > 0 && !audit.hash.isEmpty() ? std::optional(audit) : std::nullopt;
}

std::map<QString, ChainEnd> chainsFrom(const QJsonObject& document)
{
    std::map<QString, ChainEnd> ends;
    const QJsonObject chains = document.value(u"chains"_s).toObject();
    for (auto chain = chains.begin(); chain != chains.end(); ++chain) {
        const QJsonObject end = chain.value().toObject();
        const QByteArray hash = QByteArray::fromHex(end.value(u"hash"_s).toString().toLatin1());
        const qint64 links = end.value(u"links"_s).toInteger();
        if (links > 0 && !hash.isEmpty())
            ends[chain.key()] = {chain.key(), links, hash};
    }
    return ends;
}

/// The same for all names of one library; of a server without who connects, and how.
QString placeOf(const QString& library)
{
    if (const auto location = LibraryLocation::parse(library); !location)
        return withoutPassword(library);
    else if (location->server())
        return location->key();
    const QFileInfo info(library);
    return info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
}

QJsonObject toJson(const LibraryWitness& witness, const QString& library)
{
    QJsonObject document{{u"library"_s, LibraryLocation::isOnServer(library)
                                            ? placeOf(library)
                                            : QFileInfo(library).absoluteFilePath()}};
    putEnds(document, witness.audit, witness.chains);
    if (witness.announced) {
        QJsonObject announced{{u"told_by"_s, witness.announced->told.chain}};
        putEnds(announced, witness.announced->audit, witness.announced->chains);
        document.insert(u"restore"_s, announced);
    }
    return document;
}

bool write(const QString& name, const QJsonObject& document)
{
    QSaveFile file(name);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(document).toJson()) > 0 &&
           file.commit();
}

} // namespace

QString witnessFile(const QString& libraryFile)
{
    const QByteArray name =
        QCryptographicHash::hash(placeOf(libraryFile).toUtf8(), QCryptographicHash::Sha256).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           u"/gripscope/audit/%1.json"_s.arg(QString::fromLatin1(name.left(32)));
}

LibraryWitness readWitness(const QString& libraryFile)
{
    LibraryWitness witness;
    const auto bytes = readBounded(witnessFile(libraryFile), megabyte);
    const QJsonObject known = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    witness.audit = auditFrom(known);
    witness.chains = chainsFrom(known);
    const QJsonObject announced = known.value(u"restore"_s).toObject();
    AnnouncedRestore restore{{}, chainsFrom(announced), auditFrom(announced)};
    const auto told = restore.chains.find(announced.value(u"told_by"_s).toString());
    if (told != restore.chains.end()) {
        restore.told = told->second;
        witness.announced = std::move(restore);
    }
    return witness;
}

void settleRestore(LibraryWitness& witness, const LinkHash& hashOf)
{
    if (!witness.announced)
        return;
    const ChainEnd& told = witness.announced->told;
    if (hashOf(told.chain, told.links) != told.hash)
        return;
    witness.chains = witness.announced->chains;
    witness.audit = witness.announced->audit;
    witness.announced.reset();
}

void tellWitness(const QString& libraryFile, const LibraryWitness& news,
                 const std::function<bool(LibraryWitness&)>& fits)
{
    const QString name = witnessFile(libraryFile);
    QDir().mkpath(QFileInfo(name).path());
    BriefLock lock(name + lockSuffix);
    if (!lock.take())
        return;
    LibraryWitness known = readWitness(libraryFile);
    if (!fits(known))
        return;
    if (news.audit && (!known.audit || known.audit->entries < news.audit->entries))
        known.audit = news.audit;
    for (const auto& [chain, end] : news.chains)
        if (known.chains[chain].links < end.links)
            known.chains[chain] = end;
    static_cast<void>(write(name, toJson(known, libraryFile)));
}

Expected<void> announceRestore(const QString& libraryFile, const QString& keptAs,
                               const AnnouncedRestore& restore)
{
    const QString name = witnessFile(libraryFile);
    QDir().mkpath(QFileInfo(name).path());
    BriefLock lock(name + lockSuffix);
    if (!lock.take())
        return failure(ErrorCode::FileUnwritable, {name, Words::tr("another program keeps it locked")});
    LibraryWitness known = readWitness(libraryFile);
    known.announced.reset(); // an older one that came to nothing
    const bool kept = known.empty() || write(witnessFile(keptAs), toJson(known, keptAs));
    known.announced = restore;
    if (!kept || !write(name, toJson(known, libraryFile)))
        return failure(ErrorCode::FileUnwritable, {name, Words::tr("it cannot be written")});
    return {};
}

PassingLibrary::~PassingLibrary()
{
    QFile::remove(witnessFile(m_file));
}

} // namespace gripscope
