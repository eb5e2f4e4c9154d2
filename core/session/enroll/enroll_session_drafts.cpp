// SPDX-License-Identifier: GPL-3.0-or-later
// What the library is told of an enrolment that is under way, and going on with it later.
#include "core/library/sql/time_ordered_id.h"
#include "core/session/enroll/enroll_session_private.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

EnrollmentDraft::Step draftStep(EnrollSession::Step step)
{
    switch (step) {
    case EnrollSession::Step::Name:
    case EnrollSession::Step::Recipe:
        return EnrollmentDraft::Step::Recipe;
    case EnrollSession::Step::Squeeze:
        return EnrollmentDraft::Step::Squeeze;
    case EnrollSession::Step::Review:
    case EnrollSession::Step::Approved:
        break;
    }
    return EnrollmentDraft::Step::Review;
}

/// A draft that is there under this name is gone on with; all it gets is the picture, where one was chosen.
Expected<void> beginDraft(Library& library, const EnrollmentDraft& draft)
{
    ASSIGN_OR_RETURN(const std::optional<EnrollmentDraft> known, library.draft(draft.name));
    if (!known)
        return library.saveDraft(draft);
    if (draft.pictureId.isEmpty() || draft.pictureId == known->pictureId)
        return {};
    EnrollmentDraft withPicture = *known;
    withPicture.pictureId = draft.pictureId;
    return library.saveDraft(withPicture);
}

/// Of a name that was changed before anything was squeezed under it.
Expected<void> endEmptyDraft(Library& library, const QString& name, const QString& operatorName)
{
    const Expected<std::optional<EnrollmentDraft>> draft = library.draft(name);
    const Expected<std::optional<TypeRecord>> type = library.findType(name);
    if (!draft || !type)
        return tl::unexpected<Error>(draft ? type.error() : draft.error());
    const bool squeezed = *type && !(*type)->approved && (*type)->squeezes > 0;
    const bool empty = *draft && (*draft)->step == EnrollmentDraft::Step::Recipe &&
                       (*draft)->pendingId.isEmpty() && !squeezed;
    return empty ? library.endDraft(name, DraftEnd::Discarded, operatorName) : Expected<void>();
}

} // namespace

QString EnrollSession::Private::keptDraftId(const EnrollSqueeze& squeeze) const
{
    return keepsDrafts ? squeeze.draftId : QString();
}

EnrollmentDraft EnrollSession::Private::decidedDraft(const QString& remark) const
{
    EnrollmentDraft draft;
    draft.name = typeName;
    draft.recipe = recipe;
    draft.step = draftStep(step);
    draft.part = part;
    draft.pictureId = picture ? picture->id : QString();
    draft.operatorName = operatorName;
    draft.remark = remark;
    return draft;
}

EnrollmentDraft EnrollSession::Private::draft() const
{
    EnrollmentDraft draft = decidedDraft({});
    if (activity == Activity::Identifying)
        draft.pendingId = keptDraftId(measured);
    else if (activity == Activity::Deciding && !squeezes.empty())
        draft.pendingId = keptDraftId(squeezes.back());
    return draft;
}

void EnrollSession::Private::keepDraft(const QString& remark)
{
    if (!keepsDrafts || typeName.isEmpty())
        return;
    EnrollmentDraft now = draft();
    now.remark = remark;
    writes.add([now](Library& library) { return library.saveDraft(now); });
}

void EnrollSession::Private::keepNewDraft()
{
    if (!keepsDrafts)
        return;
    const QString before = draftName == typeName ? QString() : draftName;
    draftName = typeName;
    writes.add([before, now = draft()](Library& library) {
        return library.atOnce([&]() -> Expected<void> {
            RETURN_IF_ERROR(endEmptyDraft(library, before, now.operatorName));
            return beginDraft(library, now);
        });
    });
}

void EnrollSession::Private::keepMeasured()
{
    if (!keepsDrafts)
        return;
    const DraftSqueeze squeeze{measured.draftId, typeName, measured.recording, measured.source,
                               measured.part};
    EnrollmentDraft now = draft();
    now.remark = u"squeeze"_qs;
    writes.add([squeeze, now](Library& library) {
        return library.atOnce([&]() -> Expected<void> {
            RETURN_IF_ERROR(library.addDraftSqueeze(squeeze));
            return library.saveDraft(now);
        });
    });
}

void EnrollSession::Private::load(bool whereItStopped)
{
    ask<StoredEnrollment>([name = typeName, drafts = keepsDrafts](
                              Library& library) { return findStoredEnrollment(library, name, drafts); },
                          [this, whereItStopped](Expected<StoredEnrollment> found) {
                              if (found)
                                  return resume(std::move(*found), whereItStopped);
                              if (whereItStopped) {
                                  typeName.clear();
                                  draftName.clear();
                              }
                              fail(found.error(), Activity::Waiting);
                          });
}

void EnrollSession::Private::takePicture(const StoredEnrollment& stored)
{
    if (!pictureChosen) {
        picture = stored.picture;
        return;
    }
    if (!type || !keepsDrafts)
        return;
    writes.add([typeId = type->id, pictureId = picture ? picture->id : QString(), who = operatorName](
                   Library& library) { return library.setTypePicture(typeId, pictureId, who); });
    pictureChosen = false; // and stored
}

void EnrollSession::Private::resume(StoredEnrollment stored, bool whereItStopped)
{
    activity = Activity::Waiting;
    type = stored.stored.type;
    forgetActs();
    squeezes.clear();
    for (const GraspRecord& grasp : stored.stored.grasps)
        if (grasp.accepted)
            squeezes.push_back(enrolledSqueeze(grasp));
    takePicture(stored);
    EnrollmentDraft::Step reached = EnrollmentDraft::Step::Squeeze;
    if (stored.draft && whereItStopped) {
        recipe = stored.draft->recipe;
        part = stored.draft->part;
        reached = stored.draft->step;
    }
    if (type)
        recipe = type->recipe;
    step = reached == EnrollmentDraft::Step::Recipe ? Step::Recipe : Step::Squeeze;
    if (stored.pending && step == Step::Squeeze) {
        EnrollSqueeze squeeze;
        squeeze.recording = std::move(stored.pending->recording);
        squeeze.source = stored.pending->source;
        squeeze.part = stored.pending->part;
        squeeze.draftId = stored.pending->id;
        identify(std::move(squeeze));
    } else if (reached == EnrollmentDraft::Step::Review &&
               squeezes.size() >= static_cast<std::size_t>(leastSqueezes)) {
        step = Step::Review;
    }
    if (!whereItStopped)
        keepDraft(u"recipe"_qs);
}

void EnrollSession::keepDrafts(bool keep)
{
    d->keepsDrafts = keep;
}

Expected<void> EnrollSession::resumeDraft(const QString& name)
{
    RETURN_IF_ERROR(d->waitingIn(Step::Name));
    d->typeName = d->draftName = name;
    d->pictureChosen = false;
    d->load(true);
    return {};
}

void EnrollSession::setPicture(std::optional<PartPicture> picture)
{
    if (picture && picture->id.isEmpty())
        picture->id = newTimeOrderedId();
    d->picture = std::move(picture);
    d->pictureChosen = true;
    if (!d->keepsDrafts)
        return;
    std::optional<EnrollmentDraft> draft;
    if (d->step != Step::Name && d->step != Step::Approved) {
        draft = d->draft();
        draft->remark = u"picture"_qs;
    }
    d->writes.add([picture = d->picture, draft, typeId = d->type ? d->type->id : QString(),
                   who = d->operatorName](Library& library) {
        return library.atOnce([&]() -> Expected<void> {
            Expected<void> done = picture ? library.addPicture(*picture) : Expected<void>();
            if (done && draft)
                done = library.saveDraft(*draft);
            if (done && !typeId.isEmpty())
                done = library.setTypePicture(typeId, picture ? picture->id : QString(), who);
            return done;
        });
    });
}

const std::optional<PartPicture>& EnrollSession::picture() const
{
    return d->picture;
}

} // namespace gripscope
