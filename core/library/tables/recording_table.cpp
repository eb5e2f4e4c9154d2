// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/recording_table.h"

#include "core/base/words.h"
#include "core/library/tables/packed_recording.h"

namespace gripscope::recording_table {

using namespace Qt::StringLiterals;

namespace {

/// The squeeze of a draft has just this recording.
Expected<bool> isKept(Database& database, const QString& draftSqueezeId, const PackedRecording& packed)
{
    bool kept = false;
    if (draftSqueezeId.isEmpty())
        return kept;
    Statement query(database, Words::tr("store the recording"),
                    u"SELECT bytes FROM draft_squeezes WHERE id = ? AND bytes = ? AND sha256 = ?"_s);
    const auto done =
        query.bind(draftSqueezeId).bind(packed.bytes).bind(packed.sha256).forEach([&](Statement&) {
            kept = true;
        });
    if (!done)
        return tl::unexpected(done.error());
    return kept;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const Recording& recording, const QString& draftSqueezeId)
{
    ASSIGN_OR_RETURN(auto packed, packRecording(recording));
    ASSIGN_OR_RETURN(const bool kept, isKept(database, draftSqueezeId, packed));
    if (kept)
        packed.packed = QByteArray("");
    Statement row(
        database, Words::tr("store the recording"),
        u"INSERT INTO recordings (id, station, created_utc, grasp_id, samples, bytes, sha256, packed, "
        "draft_squeeze_id) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(qint64(recording.size()));
    bindPacked(row, packed);
    return row.bindOrNull(kept ? draftSqueezeId : QString()).run();
}

Expected<Recording> read(Database& database, const QString& graspId)
{
    std::optional<PackedRecording> packed;
    Statement query(
        database, Words::tr("read the recording"),
        u"SELECT r.bytes, r.sha256, CASE WHEN r.draft_squeeze_id IS NULL THEN r.packed ELSE (SELECT "
        "d.packed FROM draft_squeezes d WHERE d.id = r.draft_squeeze_id) END "
        "FROM recordings r WHERE r.grasp_id = ?"_s);
    auto done = query.bind(graspId).forEach([&](Statement& row) { packed = takePacked(row); });
    if (!done)
        return tl::unexpected(done.error());
    if (!packed)
        return failure(ErrorCode::NotFound, {Words::tr("recording of the squeeze %1").arg(graspId)});
    return unpackRecording(*packed, Words::tr("The recording of the squeeze %1").arg(graspId));
}

} // namespace gripscope::recording_table
