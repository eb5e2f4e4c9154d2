// SPDX-License-Identifier: GPL-3.0-or-later
// What is decided on the squeezes of an enrolment, and taking it back.
#include "core/base/words.h"
#include "core/session/enroll/enroll_session_private.h"
#include "core/session/squeeze/comparable_units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

using Decision = EnrollSqueeze::Decision;

void EnrollSession::Private::remember(Done what)
{
    // The same once more is what redo() would have done: the rest can still be done again.
    if (!undone.empty() && undone.back().act == what.act)
        undone.pop_back();
    else
        undone.clear();
    done.push_back(std::move(what));
}

void EnrollSession::Private::forgetActs()
{
    done.clear();
    undone.clear();
}

/// After the library has it.
void EnrollSession::Private::changeSqueeze(std::size_t index, Decision decision, const QString& reason,
                                           Done what)
{
    squeezes[index].decision = decision;
    squeezes[index].reason = reason;
    activity = decision == Decision::Pending ? Activity::Deciding : Activity::Waiting;
    remember(std::move(what));
}

Expected<void> EnrollSession::accept()
{
    const EnrollSqueeze* squeeze = d->pending();
    if (!squeeze)
        return notNow(Words::tr("There is no squeeze to decide on."));
    if (!squeeze->reason.isEmpty())
        return notNow(
            Words::tr("This measurement is not valid and cannot be enrolled: %1").arg(squeeze->reason));
    if (d->type) {
        RETURN_IF_ERROR(parameterFactor(squeeze->recording.forceUnit, squeeze->recording.positionUnit,
                                        d->type->forceUnit, d->type->positionUnit));
    }
    SqueezeToStore store;
    store.name = d->typeName;
    store.recipe = d->recipe;
    store.grasp = makeGrasp(squeeze->recording, squeeze->identification, squeeze->source, d->operatorName);
    store.grasp.part = squeeze->part;
    store.grasp.draftSqueezeId = d->keptDraftId(*squeeze);
    store.graspId = squeeze->graspId;
    if (d->keepsDrafts)
        store.draft = d->decidedDraft(u"accept"_qs);
    d->ask<StoredSqueeze>(
        [store](Library& library) { return storeSqueeze(library, store); },
        [this](Expected<StoredSqueeze> stored) {
            if (!stored)
                return d->fail(stored.error(), Activity::Deciding);
            d->type = stored->type;
            const std::size_t index = d->squeezes.size() - 1;
            d->squeezes[index].graspId = stored->graspId;
            d->changeSqueeze(index, Decision::Accepted, {}, {{Act::Kind::Accept, static_cast<int>(index)}});
        });
    return {};
}

Expected<void> EnrollSession::reject(const QString& reason)
{
    EnrollSqueeze* squeeze = d->pending();
    if (!squeeze)
        return notNow(Words::tr("There is no squeeze to decide on."));
    squeeze->decision = Decision::Rejected;
    Private::Done rejected{{Act::Kind::Reject, static_cast<int>(d->squeezes.size()) - 1}, squeeze->reason};
    if (!reason.trimmed().isEmpty())
        squeeze->reason = reason.trimmed();
    d->activity = Activity::Waiting;
    d->keepDraft(u"reject: "_qs + squeeze->reason);
    d->remember(std::move(rejected));
    return {};
}

Expected<void> EnrollSession::drop(int index, const QString& reason)
{
    const bool there = index >= 0 && static_cast<std::size_t>(index) < d->squeezes.size();
    if (!there || d->squeezes[static_cast<std::size_t>(index)].decision != Decision::Accepted)
        return notNow(Words::tr("Only an accepted squeeze can be dropped."));
    RETURN_IF_ERROR(d->waitingIn(d->step == Step::Review ? Step::Review : Step::Squeeze));
    const auto position = static_cast<std::size_t>(index);
    d->ask<void>([id = d->squeezes[position].graspId, reason,
                  who = d->operatorName](Library& library) { return library.dropGrasp(id, reason, who); },
                 [this, position, reason](Expected<void> dropped) {
                     if (!dropped)
                         return d->fail(dropped.error(), Activity::Waiting);
                     d->changeSqueeze(position, Decision::Rejected, reason,
                                      {{Act::Kind::Drop, static_cast<int>(position)}, reason});
                 });
    return {};
}

std::optional<EnrollSession::Act> EnrollSession::undoable() const
{
    const bool busy = d->activity != Activity::Waiting && d->activity != Activity::Deciding;
    if (busy)
        return std::nullopt;
    switch (d->step) {
    case Step::Recipe:
        return Act{Act::Kind::Name};
    case Step::Review:
        return Act{Act::Kind::Review};
    case Step::Squeeze:
        if (!d->done.empty())
            return d->done.back().act;
        if (d->activity == Activity::Waiting)
            return Act{Act::Kind::Recipe};
        break;
    case Step::Name:
    case Step::Approved:
        break;
    }
    return std::nullopt;
}

std::optional<EnrollSession::Act> EnrollSession::redoable() const
{
    const bool busy = d->activity != Activity::Waiting && d->activity != Activity::Deciding;
    if (busy || d->step != Step::Squeeze || d->undone.empty())
        return std::nullopt;
    return d->undone.back().act;
}

Expected<void> EnrollSession::undo()
{
    const std::optional<Act> act = undoable();
    if (!act)
        return notNow(Words::tr("There is nothing to undo now."));
    switch (act->kind) {
    case Act::Kind::Name:
    case Act::Kind::Review:
        return back();
    case Act::Kind::Recipe:
        d->step = Step::Recipe;
        d->keepDraft(u"back"_qs);
        return {};
    case Act::Kind::Squeeze:
        d->takeSqueezeBack();
        return {};
    case Act::Kind::Reject:
        d->reopenRejected();
        return {};
    case Act::Kind::Accept:
        d->reopenAccepted();
        return {};
    case Act::Kind::Drop:
        d->putBackDropped();
        return {};
    }
    return {};
}

Expected<void> EnrollSession::redo()
{
    const std::optional<Act> act = redoable();
    if (!act)
        return notNow(Words::tr("There is nothing to do again now."));
    switch (act->kind) {
    case Act::Kind::Squeeze:
        d->bringSqueezeAgain();
        return {};
    case Act::Kind::Accept:
        return accept();
    case Act::Kind::Reject:
        return reject(QString(d->undone.back().reason));
    case Act::Kind::Drop:
        return drop(act->squeeze, QString(d->undone.back().reason));
    case Act::Kind::Name:
    case Act::Kind::Recipe:
    case Act::Kind::Review:
        break;
    }
    return {};
}

void EnrollSession::Private::takeSqueezeBack()
{
    Done taken = std::move(done.back());
    done.pop_back();
    taken.squeeze = std::move(squeezes.back());
    squeezes.pop_back();
    activity = Activity::Waiting;
    undone.push_back(std::move(taken));
    keepDraft(u"taken back"_qs);
}

void EnrollSession::Private::bringSqueezeAgain()
{
    Done taken = std::move(undone.back());
    undone.pop_back();
    squeezes.push_back(std::move(taken.squeeze));
    taken.squeeze = {};
    done.push_back(std::move(taken));
    activity = Activity::Deciding;
    keepDraft(u"brought again"_qs);
}

void EnrollSession::Private::reopenRejected()
{
    Done rejected = std::move(done.back());
    done.pop_back();
    EnrollSqueeze& squeeze = squeezes.back();
    std::swap(squeeze.reason, rejected.reason); // what it was advised before; and why it was rejected
    squeeze.decision = Decision::Pending;
    activity = Activity::Deciding;
    undone.push_back(std::move(rejected));
    keepDraft(u"rejection undone"_qs);
}

void EnrollSession::Private::reopenAccepted()
{
    EnrollmentDraft reopened = decidedDraft(u"acceptance undone"_qs);
    reopened.pendingId = keptDraftId(squeezes.back());
    ask<void>(
        [id = squeezes.back().graspId, who = operatorName, reopened, drafts = keepsDrafts](Library& library) {
            return library.atOnce([&]() -> Expected<void> {
                if (Expected<void> out = library.dropGrasp(id, Words::tr("taken back"), who); !out || !drafts)
                    return out;
                return library.saveDraft(reopened);
            });
        },
        [this](Expected<void> out) {
            if (!out)
                return fail(out.error(), Activity::Waiting);
            squeezes.back().decision = Decision::Pending;
            activity = Activity::Deciding;
            undone.push_back(std::move(done.back()));
            done.pop_back();
        });
}

void EnrollSession::Private::putBackDropped()
{
    const auto index = static_cast<std::size_t>(done.back().act.squeeze);
    ask<void>([id = squeezes[index].graspId,
               who = operatorName](Library& library) { return library.undropGrasp(id, who); },
              [this, index](Expected<void> back) {
                  if (!back)
                      return fail(back.error(), Activity::Waiting);
                  squeezes[index].decision = Decision::Accepted;
                  squeezes[index].reason.clear();
                  activity = Activity::Waiting;
                  undone.push_back(std::move(done.back()));
                  done.pop_back();
              });
}

} // namespace gripscope
