// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/packed_recording.h"

#include "core/base/words.h"
#include "core/library/sql/digest.h"
#include "core/signal/recording/recording_limits.h"

#include <QtEndian>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As many samples as there may be with all their columns (8 bytes each, 2 of status), and facts beside them.
constexpr qint64 mostBytes = 42 * static_cast<qint64>(mostSamples) + 10'000'000;

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
    ASSIGN_OR_RETURN(const auto bytes, encodeRecording(recording));
    return PackedRecording{qint64(bytes.size()), sha256(bytes), qCompress(bytes)};
}

Expected<Recording> unpackRecording(const PackedRecording& packed, const QString& what)
{
    // Zeros pack a thousand to one, and a row can say anything.
    if (packed.bytes < 0 || packed.bytes > mostBytes)
        return failure(
            ErrorCode::StorageCorrupt,
            {what,
             Words::tr("it says that it has %1 bytes, at most %2 can be").arg(packed.bytes).arg(mostBytes)});
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
