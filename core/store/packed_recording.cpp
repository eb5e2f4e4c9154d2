// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/packed_recording.h"

#include "core/store/digest.h"
#include "core/store/recording_codec.h"
#include "core/words.h"

#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// qUncompress() trusts the size in its first four bytes and would reserve that much memory: compare it
/// first.
QByteArray unpack(const QByteArray& packed, qint64 bytes)
{
    if (packed.size() < 4 || qint64(qFromBigEndian<quint32>(packed.constData())) != bytes)
        return {};
    return qUncompress(packed);
}

} // namespace

Expected<PackedRecording> packRecording(const Recording& recording)
{
    const auto bytes = encodeRecording(recording);
    if (!bytes)
        return tl::unexpected(bytes.error());
    return PackedRecording{qint64(bytes->size()), sha256(*bytes), qCompress(*bytes)};
}

Expected<Recording> unpackRecording(const PackedRecording& packed, const QString& what)
{
    const QByteArray bytes = unpack(packed.packed, packed.bytes);
    if (sha256(bytes) != packed.sha256)
        return failure(ErrorCode::StorageCorrupt,
                       {what, Words::tr("its bytes are not those that were stored")});
    return decodeRecording(bytes);
}

void bindPacked(Statement& row, const PackedRecording& packed)
{
    row.bind(packed.bytes).bind(packed.sha256).bindBytes(packed.packed);
}

PackedRecording takePacked(Statement& row)
{
    PackedRecording packed;
    packed.bytes = row.takeInteger();
    packed.sha256 = row.takeText();
    packed.packed = row.takeBytes();
    return packed;
}

} // namespace gripscope
