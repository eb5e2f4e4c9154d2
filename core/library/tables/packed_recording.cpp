// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/packed_recording.h"

#include "core/base/words.h"
#include "core/library/packing/inflate.h"
#include "core/library/sql/digest.h"
#include "core/signal/recording/recording_limits.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As many samples as there may be with all their columns (8 bytes each, 2 of status), and facts beside them.
constexpr qint64 mostBytes = 42 * static_cast<qint64>(mostSamples) + 10'000'000;

/// Of what is in series, which is hardly ever larger than what it stands for, and never by much.
qint64 mostInflated(qint64 bytes)
{
    constexpr qint64 overhead = 1000;
    return bytes + bytes / 4 + overhead;
}

} // namespace

Expected<PackedRecording> packRecording(const Recording& recording)
{
    ASSIGN_OR_RETURN(const auto bytes, encodeRecording(recording));
    ASSIGN_OR_RETURN(const auto series, encodeInSeries(recording));
    // Read back before it is relied on: a recording cannot be squeezed again.
    const Expected<QByteArray> back = decodeRecording(series).and_then(encodeRecording);
    const bool same = back && *back == bytes;
    return PackedRecording{qint64(bytes.size()), sha256(bytes), qCompress(same ? series : bytes, 9)};
}

Expected<Recording> unpackRecording(const PackedRecording& packed, const QString& what)
{
    // Zeros pack a thousand to one, and a row can say anything.
    if (packed.bytes < 0 || packed.bytes > mostBytes)
        return failure(
            ErrorCode::StorageCorrupt,
            {what,
             Words::tr("it says that it has %1 bytes, at most %2 can be").arg(packed.bytes).arg(mostBytes)});
    const auto others =
        failure(ErrorCode::StorageCorrupt, {what, Words::tr("its bytes are not those that were stored")});
    const QByteArray found = inflated(packed.packed, mostInflated(packed.bytes));
    Expected<Recording> recording = decodeRecording(found);
    if (!recording)
        return others;
    // As it was written once where it is number by number: nothing says that this program would write the
    // same.
    const bool isPlain = found.size() == packed.bytes && sha256(found) == packed.sha256;
    if (isPlain)
        return recording;
    const auto plain = encodeRecording(*recording);
    if (!plain || plain->size() != packed.bytes || sha256(*plain) != packed.sha256)
        return others;
    return recording;
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
