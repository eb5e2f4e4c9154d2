// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/draft_squeeze_table.h"

#include "core/store/packed_recording.h"
#include "core/words.h"

namespace gripscope::draft_squeeze_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const DraftSqueeze& squeeze)
{
    const auto packed = packRecording(squeeze.recording);
    if (!packed)
        return tl::unexpected(packed.error());
    Statement row(database, Words::tr("store the squeeze"),
                  u"INSERT INTO draft_squeezes (id, station, created_utc, type_name, source, part, bytes, "
                  "sha256, packed) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(squeeze.id).bind(stamp.station).bind(stamp.utc).bind(squeeze.name);
    row.bind(squeeze.source).bind(squeeze.part);
    bindPacked(row, *packed);
    return row.run();
}

Expected<DraftSqueeze> read(Database& database, const QString& id)
{
    DraftSqueeze squeeze;
    PackedRecording packed;
    Statement query(
        database, Words::tr("read the squeeze"),
        u"SELECT id, type_name, source, part, bytes, sha256, packed FROM draft_squeezes WHERE id = ?"_s);
    auto done = query.bind(id).forEach([&](Statement& row) {
        squeeze.id = row.takeText();
        squeeze.name = row.takeText();
        squeeze.source = row.takeText();
        squeeze.part = row.takeText();
        packed = takePacked(row);
    });
    if (!done)
        return tl::unexpected(done.error());
    if (squeeze.id.isEmpty())
        return failure(ErrorCode::NotFound, {Words::tr("squeeze %1 of an enrolment").arg(id)});
    auto recording = unpackRecording(packed, Words::tr("The recording of the squeeze %1").arg(id));
    if (!recording)
        return tl::unexpected(recording.error());
    squeeze.recording = std::move(*recording);
    return squeeze;
}

} // namespace gripscope::draft_squeeze_table
