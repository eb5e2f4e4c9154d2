// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/recording_table.h"

#include "core/store/recording_codec.h"
#include "core/words.h"

#include <QCryptographicHash>
#include <QtEndian>

namespace gripscope::recording_table {

using namespace Qt::StringLiterals;

namespace {

QString sha256(const QByteArray& bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

/// qUncompress() trusts the size in its first four bytes and would reserve that much memory: compare it
/// first.
QByteArray unpack(const QByteArray& packed, qint64 bytes)
{
    if (packed.size() < 4 || qint64(qFromBigEndian<quint32>(packed.constData())) != bytes)
        return {};
    return qUncompress(packed);
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const Recording& recording)
{
    const auto bytes = encodeRecording(recording);
    if (!bytes)
        return tl::unexpected(bytes.error());
    Statement row(
        database, Words::tr("store the recording"),
        u"INSERT INTO recordings (id, station, created_utc, grasp_id, samples, bytes, sha256, packed) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(qint64(recording.size()));
    return row.bind(qint64(bytes->size())).bind(sha256(*bytes)).bindBytes(qCompress(*bytes)).run();
}

Expected<Recording> read(Database& database, const QString& graspId)
{
    bool found = false;
    qint64 size = 0;
    QString digest;
    QByteArray packed;
    Statement query(database, Words::tr("read the recording"),
                    u"SELECT bytes, sha256, packed FROM recordings WHERE grasp_id = ?"_s);
    auto done = query.bind(graspId).forEach([&](Statement& row) {
        found = true;
        size = row.takeInteger();
        digest = row.takeText();
        packed = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    if (!found)
        return failure(ErrorCode::NotFound, {Words::tr("recording of the squeeze %1").arg(graspId)});
    const QByteArray bytes = unpack(packed, size);
    if (sha256(bytes) != digest)
        return failure(ErrorCode::StorageCorrupt, {Words::tr("The recording of the squeeze %1").arg(graspId),
                                                   Words::tr("its bytes are not those that were stored")});
    return decodeRecording(bytes);
}

} // namespace gripscope::recording_table
