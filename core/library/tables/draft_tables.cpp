// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/draft_tables.h"

#include "core/base/words.h"
#include "core/library/sql/digest.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/packed_recording.h"
#include "core/library/tables/recipe_columns.h"
#include "core/library/tables/serial.h"

#include <array>

namespace gripscope::draft_table {

using namespace Qt::StringLiterals;

namespace {

const auto kept = u"type_name, step, "_s + recipeColumns() + u", part, picture_id, pending_id, remark"_s;

struct StepName {
    EnrollmentDraft::Step step;
    const char16_t* name;
};
constexpr std::array<StepName, 3> stepNames{{{EnrollmentDraft::Step::Recipe, u"recipe"},
                                             {EnrollmentDraft::Step::Squeeze, u"squeeze"},
                                             {EnrollmentDraft::Step::Review, u"review"}}};

QString toString(EnrollmentDraft::Step step)
{
    for (const StepName& known : stepNames)
        if (known.step == step)
            return QString::fromUtf16(known.name);
    return {};
}

EnrollmentDraft::Step stepFromString(const QString& text)
{
    for (const StepName& known : stepNames)
        if (QString::fromUtf16(known.name) == text)
            return known.step;
    return EnrollmentDraft::Step::Recipe; // the earliest asks for the least to be there
}

EnrollmentDraft takeDraft(Statement& row)
{
    EnrollmentDraft draft;
    draft.name = row.takeText();
    draft.step = stepFromString(row.takeText());
    draft.recipe = takeRecipe(row);
    draft.part = row.takeText();
    draft.pictureId = row.takeText();
    draft.pendingId = row.takeText();
    draft.remark = row.takeText();
    draft.operatorName = row.takeText();
    draft.changed = row.takeUtc();
    return draft;
}

/// The key of the newest row of a draft.
QString newestOf(const QString& typeName)
{
    return u"(SELECT o.id FROM enrollment_drafts o WHERE o.type_name = %1 ORDER BY "
           "o.serial DESC, o.created_utc DESC, o.id DESC LIMIT 1)"_s.arg(typeName);
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const EnrollmentDraft& draft)
{
    Statement row(database, Words::tr("store the enrolment under way"),
                  u"INSERT INTO enrollment_drafts (id, station, created_utc, state, "_s + kept +
                      u", operator_name, serial) VALUES (?, ?, ?, 'open', ?, ?, "_s + recipePlaces() +
                      u", ?, ?, ?, ?, ?, "_s + nextSerial(u"enrollment_drafts"_s) + u')');
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(draft.name).bind(toString(draft.step));
    bindRecipe(row, draft.recipe);
    row.bind(draft.part);
    row.bindOrNull(draft.pictureId).bindOrNull(draft.pendingId).bind(draft.remark);
    return row.bind(draft.operatorName).run();
}

Expected<void> end(Database& database, const RowStamp& stamp, const QString& name, DraftEnd end,
                   const QString& operatorName)
{
    Statement row(database, Words::tr("store the enrolment under way"),
                  u"INSERT INTO enrollment_drafts (id, station, created_utc, state, "_s + kept +
                      u", operator_name, serial) SELECT ?, ?, ?, ?, "_s + kept + u", ?, "_s +
                      nextSerial(u"enrollment_drafts"_s) +
                      u" FROM enrollment_drafts d WHERE d.state = 'open' AND d.id = "_s + newestOf(u"?"_s));
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    row.bind(end == DraftEnd::Approved ? u"approved"_s : u"discarded"_s);
    return row.bind(operatorName).bind(name).run();
}

Expected<std::vector<EnrollmentDraft>> open(Database& database, const QString& name)
{
    Statement query(database, Words::tr("read the enrolments under way"),
                    u"SELECT "_s + kept +
                        u", operator_name, created_utc FROM enrollment_drafts d "
                        "WHERE d.state = 'open' AND ? IN ('', d.type_name) AND d.id = "_s +
                        newestOf(u"d.type_name"_s) + u" ORDER BY "_s + newestFirst);
    return allRows(query.bind(name), takeDraft);
}

} // namespace gripscope::draft_table

namespace gripscope::draft_squeeze_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const DraftSqueeze& squeeze)
{
    ASSIGN_OR_RETURN(const auto packed, packRecording(squeeze.recording));
    Statement row(database, Words::tr("store the squeeze"),
                  u"INSERT INTO draft_squeezes (id, station, created_utc, type_name, source, part, bytes, "
                  "sha256, packed) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(squeeze.id).bind(stamp.station).bind(stamp.utc).bind(squeeze.name);
    row.bind(squeeze.source).bind(squeeze.part);
    bindPacked(row, packed);
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
    ASSIGN_OR_RETURN(auto recording,
                     unpackRecording(packed, Words::tr("The recording of the squeeze %1").arg(id)));
    squeeze.recording = std::move(recording);
    return squeeze;
}

} // namespace gripscope::draft_squeeze_table

namespace gripscope::picture_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const PartPicture& picture)
{
    Statement row(database, Words::tr("store the picture"),
                  u"INSERT INTO pictures (id, station, created_utc, format, width, height, sha256, bytes) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(picture.id).bind(stamp.station).bind(stamp.utc).bind(picture.format);
    row.bind(picture.width).bind(picture.height).bind(sha256(picture.bytes)).bindBytes(picture.bytes);
    return row.run();
}

Expected<PartPicture> read(Database& database, const QString& id)
{
    PartPicture picture;
    QString digest;
    Statement query(database, Words::tr("read the picture"),
                    u"SELECT id, format, width, height, sha256, bytes FROM pictures WHERE id = ?"_s);
    auto done = query.bind(id).forEach([&](Statement& row) {
        picture.id = row.takeText();
        picture.format = row.takeText();
        picture.width = int(row.takeInteger());
        picture.height = int(row.takeInteger());
        digest = row.takeText();
        picture.bytes = row.takeBytes();
    });
    if (!done)
        return tl::unexpected(done.error());
    if (picture.id.isEmpty())
        return failure(ErrorCode::NotFound, {Words::tr("picture %1").arg(id)});
    if (sha256(picture.bytes) != digest)
        return failure(ErrorCode::StorageCorrupt, {Words::tr("The picture %1").arg(id),
                                                   Words::tr("its bytes are not those that were stored")});
    return picture;
}

} // namespace gripscope::picture_table
