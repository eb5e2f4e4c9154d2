// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/library_witness.h"

#include "core/base/bounded_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSaveFile>
#include <QStandardPaths>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int lockTimeout_ms = 2000; ///< the file takes milliseconds to write
constexpr auto lockSuffix = ".lock"_L1;

QJsonObject toJson(const LibraryWitness& witness, const QString& libraryFile)
{
    QJsonObject document{{u"library"_s, QFileInfo(libraryFile).absoluteFilePath()}};
    if (witness.audit) {
        document.insert(u"entries"_s, witness.audit->entries);
        document.insert(u"hash"_s, witness.audit->hash);
    }
    QJsonObject chains;
    for (const auto& [name, end] : witness.chains)
        chains.insert(
            name, QJsonObject{{u"links"_s, end.links}, {u"hash"_s, QString::fromLatin1(end.hash.toHex())}});
    if (!chains.isEmpty())
        document.insert(u"chains"_s, chains);
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
    const QFileInfo info(libraryFile);
    const QString place = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
    const QByteArray name = QCryptographicHash::hash(place.toUtf8(), QCryptographicHash::Sha256).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           u"/gripscope/audit/%1.json"_s.arg(QString::fromLatin1(name.left(32)));
}

LibraryWitness readWitness(const QString& libraryFile)
{
    LibraryWitness witness;
    const auto bytes = readBounded(witnessFile(libraryFile), megabyte);
    const QJsonObject known = bytes ? QJsonDocument::fromJson(*bytes).object() : QJsonObject();
    const AuditHead audit{known.value(u"entries"_s).toInteger(), known.value(u"hash"_s).toString()};
    if (audit.entries > 0 && !audit.hash.isEmpty())
        witness.audit = audit;
    const QJsonObject chains = known.value(u"chains"_s).toObject();
    for (auto chain = chains.begin(); chain != chains.end(); ++chain) {
        const QJsonObject end = chain.value().toObject();
        const QByteArray hash = QByteArray::fromHex(end.value(u"hash"_s).toString().toLatin1());
        const qint64 links = end.value(u"links"_s).toInteger();
        if (links > 0 && !hash.isEmpty())
            witness.chains[chain.key()] = {chain.key(), links, hash};
    }
    return witness;
}

void tellWitness(const QString& libraryFile, const LibraryWitness& news,
                 const std::function<bool(const LibraryWitness&)>& fits)
{
    const QString name = witnessFile(libraryFile);
    QDir().mkpath(QFileInfo(name).path());
    QLockFile lock(name + lockSuffix);
    if (!lock.tryLock(lockTimeout_ms))
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

PassingLibrary::~PassingLibrary()
{
    QFile::remove(witnessFile(m_file));
}

} // namespace gripscope
