// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/enroll_session.h"

#include "core/base/words.h"
#include "core/identification/identification.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/session/enroll/enroll_session_private.h"
#include "core/session/squeeze/hold_history.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Decision = EnrollSqueeze::Decision;

QString tooFew(int accepted)
{
    return Words::tr("A type needs at least %1 accepted squeezes; there are %2.")
        .arg(EnrollSession::leastSqueezes)
        .arg(accepted);
}

} // namespace

tl::unexpected<Error> notNow(const QString& why)
{
    return failure(ErrorCode::Usage, {why});
}

Expected<void> EnrollSession::Private::waitingIn(Step wanted) const
{
    if (step != wanted)
        return notNow(Words::tr("This is not the step for it."));
    switch (activity) {
    case Activity::Waiting:
        return {};
    case Activity::Deciding:
        return notNow(Words::tr("Accept or reject the last squeeze first."));
    case Activity::Squeezing:
    case Activity::Identifying:
    case Activity::Storing:
        break;
    }
    return notNow(Words::tr("The last squeeze is still being worked on."));
}

EnrollSqueeze* EnrollSession::Private::pending()
{
    const bool there = activity == Activity::Deciding && !squeezes.empty();
    return there && squeezes.back().decision == Decision::Pending ? &squeezes.back() : nullptr;
}

void EnrollSession::Private::fail(const Error& reason, Activity next)
{
    error = reason;
    activity = next;
}

void EnrollSession::Private::identify(EnrollSqueeze squeeze)
{
    measured = std::move(squeeze);
    activity = Activity::Identifying;
    HoldHistory history;
    for (const EnrollSqueeze& earlier : squeezes)
        if (earlier.decision == Decision::Accepted)
            history.add(earlier.recording, earlier.identification);
    IdentificationOptions withEarlier = options;
    withEarlier.earlierHold = history.before(measured.recording, options);
    task = inPool([recording = measured.recording, options = withEarlier] {
        return gripscope::identify(recording, options);
    });
}

void EnrollSession::Private::identified(Identification identification)
{
    measured.determined =
        determinedQuantities(identification, measured.recording.forceUnit, measured.recording.positionUnit);
    measured.reason = whyNotEnrolled(identification, measured.determined);
    measured.identification = std::move(identification);
    const bool copy = std::ranges::any_of(squeezes, [this](const EnrollSqueeze& earlier) {
        return earlier.decision == Decision::Accepted && sameMeasurement(earlier, measured);
    });
    if (copy && measured.reason.isEmpty())
        measured.reason =
            Words::tr("It is a recording that this type has already; a copy says nothing of how "
                      "its squeezes differ.");
    squeezes.push_back(std::move(measured));
    measured = {};
    activity = Activity::Deciding;
    undone.clear();
    done.push_back({{Act::Kind::Squeeze, static_cast<int>(squeezes.size()) - 1}});
}

EnrollSession::EnrollSession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
}

EnrollSession::~EnrollSession() = default;

void EnrollSession::setOperator(const QString& name)
{
    d->operatorName = name;
    d->job.setOperator(name);
}

Expected<void> EnrollSession::setName(const QString& name)
{
    RETURN_IF_ERROR(d->waitingIn(Step::Name));
    if (name.trimmed().isEmpty())
        return notNow(Words::tr("The type needs a name."));
    d->typeName = name.trimmed();
    d->step = Step::Recipe;
    d->keepNewDraft();
    return {};
}

Expected<void> EnrollSession::setRecipe(const Recipe& recipe)
{
    RETURN_IF_ERROR(d->waitingIn(Step::Recipe));
    RETURN_IF_ERROR(recipeError(recipe));
    d->recipe = recipe;
    d->load(false);
    return {};
}

void EnrollSession::setPart(const QString& part)
{
    d->part = part.trimmed();
}

QString EnrollSession::part() const
{
    return d->part;
}

Expected<void> EnrollSession::squeeze()
{
    RETURN_IF_ERROR(d->waitingIn(Step::Squeeze));
    const bool commandable = d->connection.identity().commandable;
    const Expected<void> started =
        commandable ? d->job.start(d->recipe, d->squeezes.size() + 1) : d->job.listen(d->recipe.seconds);
    if (!started)
        return started;
    d->error.reset();
    d->activity = Activity::Squeezing;
    return {};
}

Expected<void> EnrollSession::addRecording(Recording recording, const QString& source)
{
    RETURN_IF_ERROR(d->waitingIn(Step::Squeeze));
    EnrollSqueeze squeeze;
    squeeze.recording = std::move(recording);
    squeeze.source = source;
    squeeze.part = d->part;
    squeeze.draftId = newTimeOrderedId();
    d->error.reset();
    d->identify(std::move(squeeze));
    d->keepMeasured();
    return {};
}

Expected<void> EnrollSession::review()
{
    RETURN_IF_ERROR(d->waitingIn(Step::Squeeze));
    if (acceptedCount() < leastSqueezes)
        return notNow(tooFew(acceptedCount()));
    d->step = Step::Review;
    d->keepDraft(u"review"_qs);
    return {};
}

Expected<void> EnrollSession::back()
{
    const bool fromReview = d->step == Step::Review;
    RETURN_IF_ERROR(d->waitingIn(fromReview ? Step::Review : Step::Recipe));
    d->step = fromReview ? Step::Squeeze : Step::Name;
    d->keepDraft(u"back"_qs);
    return {};
}

Expected<void> EnrollSession::approve(const QString& reason)
{
    RETURN_IF_ERROR(d->waitingIn(Step::Review));
    if (acceptedCount() < leastSqueezes || !d->type)
        return notNow(tooFew(acceptedCount()));
    d->ask<void>(
        [id = d->type->id, who = d->operatorName, name = d->typeName, reason,
         drafts = d->keepsDrafts](Library& library) {
            return library.atOnce([&]() -> Expected<void> {
                if (Expected<void> approved = library.approveType(id, who, reason); !approved || !drafts)
                    return approved;
                return library.endDraft(name, DraftEnd::Approved, who);
            });
        },
        [this](Expected<void> approved) {
            if (!approved)
                return d->fail(approved.error(), Activity::Waiting);
            d->step = Step::Approved;
            d->activity = Activity::Waiting;
            d->forgetActs();
        });
    return {};
}

void EnrollSession::restart()
{
    d->job.cancel();
    d->task.forget();
    d->answer = {};
    d->step = Step::Name;
    d->activity = Activity::Waiting;
    d->typeName.clear();
    d->draftName.clear();
    d->part.clear();
    d->type.reset();
    d->recipe = recipeOfNewTypes();
    d->picture.reset();
    d->pictureChosen = false;
    d->squeezes.clear();
    d->error.reset();
    d->forgetActs();
}

bool EnrollSession::poll()
{
    const std::optional<Error> unwritten = d->writes.poll();
    if (unwritten)
        d->error = unwritten;
    switch (d->activity) {
    case Activity::Squeezing:
        d->job.poll();
        if (d->job.state() == SqueezeJob::State::Done) {
            d->activity = Activity::Waiting;
            (void)addRecording(d->job.recording(), d->connection.address());
        } else if (d->job.state() == SqueezeJob::State::Failed) {
            d->fail(*d->job.error(), Activity::Waiting);
        }
        return true; // progress, at least
    case Activity::Identifying:
        if (d->writes.busy()) // what is shown for a decision is kept
            return unwritten.has_value();
        if (std::optional<Identification> identification = d->task.take()) {
            d->identified(std::move(*identification));
            return true;
        }
        break;
    case Activity::Storing:
        return d->answer.poll() || unwritten;
    case Activity::Waiting:
    case Activity::Deciding:
        break;
    }
    return unwritten.has_value();
}

EnrollSession::Step EnrollSession::step() const
{
    return d->step;
}

EnrollSession::Activity EnrollSession::activity() const
{
    return d->activity;
}

QString EnrollSession::typeName() const
{
    return d->typeName;
}

const Recipe& EnrollSession::recipe() const
{
    return d->recipe;
}

const std::vector<EnrollSqueeze>& EnrollSession::squeezes() const
{
    return d->squeezes;
}

int EnrollSession::acceptedCount() const
{
    return static_cast<int>(
        std::count_if(d->squeezes.begin(), d->squeezes.end(),
                      [](const EnrollSqueeze& squeeze) { return squeeze.decision == Decision::Accepted; }));
}

double EnrollSession::progress() const
{
    return d->activity == Activity::Squeezing ? d->job.progress() : 0;
}

std::optional<Error> EnrollSession::lastError() const
{
    return d->error;
}

void EnrollSession::setIdentificationOptions(const IdentificationOptions& options)
{
    d->options = options;
}

} // namespace gripscope
