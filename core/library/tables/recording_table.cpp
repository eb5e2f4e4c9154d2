// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/recording_table.h"

#include "core/base/words.h"
#include "core/library/tables/packed_recording.h"

namespace gripscope::recording_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const Recording& recording)
{
    ASSIGN_OR_RETURN(const auto packed, packRecording(recording));
    Statement row(
        database, Words::tr("store the recording"),
        u"INSERT INTO recordings (id, station, created_utc, grasp_id, samples, bytes, sha256, packed) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(qint64(recording.size()));
    bindPacked(row, packed);
    return row.run();
}

Expected<Recording> read(Database& database, const QString& graspId)
{
    std::optional<PackedRecording> packed;
    Statement query(database, Words::tr("read the recording"),
                    u"SELECT bytes, sha256, packed FROM recordings WHERE grasp_id = ?"_s);
    auto done = query.bind(graspId).forEach([&](Statement& row) { packed = takePacked(row); });
    if (!done)
        return tl::unexpected(done.error());
    if (!packed)
        return failure(ErrorCode::NotFound, {Words::tr("recording of the squeeze %1").arg(graspId)});
    return unpackRecording(*packed, Words::tr("The recording of the squeeze %1").arg(graspId));
}

} // namespace gripscope::recording_table
