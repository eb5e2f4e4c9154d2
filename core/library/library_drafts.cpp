// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/library_private.h"
#include "core/library/tables/draft_tables.h"
#include "core/library/tables/type_tables.h"
#include "core/library/tables/type_writer.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// With the number of squeezes that its type has by now.
Expected<std::vector<EnrollmentDraft>> openDrafts(Database& database, const QString& name)
{
    auto drafts = draft_table::open(database, name);
    if (!drafts)
        return drafts;
    for (EnrollmentDraft& draft : *drafts) {
        ASSIGN_OR_RETURN(const auto type, type_table::findByName(database, draft.name));
        draft.squeezes = type ? type->squeezes : 0;
    }
    return drafts;
}

} // namespace

Expected<void> Library::saveDraft(const EnrollmentDraft& draft)
{
    if (draft.name.trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("An enrolment needs the name of its type.")});
    return d->write<void>(Words::tr("store the enrolment under way"),
                          [&] { return draft_table::insert(*d->database, RowStamp::now(), draft); });
}

Expected<void> Library::endDraft(const QString& name, DraftEnd end, const QString& operatorName)
{
    return d->write<void>(Words::tr("end the enrolment"), [&] {
        return draft_table::end(*d->database, RowStamp::now(), name, end, operatorName);
    });
}

Expected<std::vector<EnrollmentDraft>> Library::drafts() const
{
    return openDrafts(*d->database, {});
}

Expected<std::optional<EnrollmentDraft>> Library::draft(const QString& name) const
{
    if (name.isEmpty())
        return std::optional<EnrollmentDraft>();
    ASSIGN_OR_RETURN(auto drafts, openDrafts(*d->database, name));
    return drafts.empty() ? std::nullopt : std::optional(std::move(drafts.front()));
}

Expected<void> Library::addDraftSqueeze(const DraftSqueeze& squeeze)
{
    return d->write<void>(Words::tr("store the squeeze"), [&] {
        return draft_squeeze_table::insert(*d->database, RowStamp::now(), squeeze);
    });
}

Expected<DraftSqueeze> Library::draftSqueeze(const QString& id) const
{
    return draft_squeeze_table::read(*d->database, id);
}

Expected<void> Library::addPicture(const PartPicture& picture)
{
    if ((picture.format != "png"_L1 && picture.format != "jpeg"_L1) || picture.bytes.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("A picture of a part is PNG or JPEG.")});
    return d->write<void>(Words::tr("store the picture"),
                          [&] { return picture_table::insert(*d->database, RowStamp::now(), picture); });
}

Expected<PartPicture> Library::picture(const QString& pictureId) const
{
    return picture_table::read(*d->database, pictureId);
}

Expected<void> Library::setTypePicture(const QString& typeId, const QString& pictureId,
                                       const QString& operatorName)
{
    return d->write<void>(Words::tr("store the type's picture"), [&]() -> Expected<void> {
        RETURN_IF_ERROR(requireType(*d->database, typeId));
        return type_picture_table::insert(*d->database, RowStamp::now(), typeId, pictureId, operatorName);
    });
}

Expected<std::optional<PartPicture>> Library::typePicture(const QString& typeId) const
{
    ASSIGN_OR_RETURN(const auto pictureId, type_picture_table::inForce(*d->database, typeId));
    if (pictureId.isEmpty())
        return std::optional<PartPicture>();
    ASSIGN_OR_RETURN(auto picture, picture_table::read(*d->database, pictureId));
    return std::optional(std::move(picture));
}

} // namespace gripscope
