// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll_session.h"

#include "core/session/comparable_units.h"
#include "core/session/enrollment_storage.h"
#include "core/session/hold_history.h"
#include "core/session/library_answer.h"
#include "core/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Decision = EnrollSqueeze::Decision;

tl::unexpected<Error> notNow(const QString& why)
{
    return failure(ErrorCode::Usage, {why});
}

} // namespace

struct EnrollSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), library(service), job(session)
    {
    }

    ConnectSession& connection;
    LibraryService& library;
    SqueezeJob job;
    IdentificationTask task;
    LibraryAnswer answer;
    IdentificationOptions options;
    QString operatorName;

    Step step = Step::Name;
    Activity activity = Activity::Waiting;
    QString typeName;
    Recipe recipe;
    std::optional<TypeRecord> type; // once it is in the library
    std::vector<EnrollSqueeze> squeezes;
    Recording measured; // what is being identified
    QString source;
    QString part, measuredPart; // of the next squeeze, and of the one that is being identified
    std::optional<Error> error;

    [[nodiscard]] Expected<void> waitingIn(Step wanted) const;
    [[nodiscard]] EnrollSqueeze* pending();
    void identify(Recording recording, const QString& from);
    void identified(Identification identification);
    void resume(StoredType stored);
    void fail(const Error& reason, Activity next);
    template <typename T>
    void ask(std::function<Expected<T>(Library&)> work, std::function<void(Expected<T>)> done)
    {
        activity = Activity::Storing;
        error.reset();
        answer.await<T>(library.run<T>(std::move(work)), std::move(done));
    }
};

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

void EnrollSession::Private::identify(Recording recording, const QString& from)
{
    measured = recording;
    measuredPart = part;
    source = from;
    error.reset();
    activity = Activity::Identifying;
    HoldHistory history;
    for (const EnrollSqueeze& earlier : squeezes)
        if (earlier.decision == Decision::Accepted)
            history.add(earlier.recording, earlier.identification);
    IdentificationOptions withEarlier = options;
    withEarlier.earlierHold = history.before(recording, options);
    task.start(std::move(recording), withEarlier);
}

void EnrollSession::Private::identified(Identification identification)
{
    EnrollSqueeze squeeze;
    squeeze.recording = std::move(measured);
    squeeze.part = measuredPart;
    squeeze.reason = whyNotEnrolled(identification);
    squeeze.identification = std::move(identification);
    squeezes.push_back(std::move(squeeze));
    activity = Activity::Deciding;
}

void EnrollSession::Private::resume(StoredType stored)
{
    type = std::move(stored.type);
    if (type)
        recipe = type->recipe;
    squeezes.clear();
    for (const GraspRecord& grasp : stored.grasps)
        if (grasp.accepted)
            squeezes.push_back(enrolledSqueeze(grasp));
    step = Step::Squeeze;
    activity = Activity::Waiting;
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
    if (const Expected<void> may = d->waitingIn(Step::Name); !may)
        return may;
    if (name.trimmed().isEmpty())
        return notNow(Words::tr("The type needs a name."));
    d->typeName = name.trimmed();
    d->step = Step::Recipe;
    return {};
}

Expected<void> EnrollSession::setRecipe(const Recipe& recipe)
{
    if (const Expected<void> may = d->waitingIn(Step::Recipe); !may)
        return may;
    if (const std::optional<Error> error = recipeError(recipe))
        return tl::unexpected<Error>(*error);
    d->recipe = recipe;
    d->ask<StoredType>([name = d->typeName](Library& library) { return findStoredType(library, name); },
                       [this](Expected<StoredType> found) {
                           if (found)
                               d->resume(std::move(*found));
                           else
                               d->fail(found.error(), Activity::Waiting);
                       });
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
    if (const Expected<void> may = d->waitingIn(Step::Squeeze); !may)
        return may;
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
    if (const Expected<void> may = d->waitingIn(Step::Squeeze); !may)
        return may;
    d->identify(std::move(recording), source);
    return {};
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
        const Expected<double> factor =
            parameterFactor(squeeze->recording.forceUnit, squeeze->recording.positionUnit, d->type->forceUnit,
                            d->type->positionUnit);
        if (!factor)
            return tl::unexpected<Error>(factor.error());
    }
    NewGrasp grasp = makeGrasp(squeeze->recording, squeeze->identification, d->source, d->operatorName);
    grasp.part = squeeze->part;
    d->ask<StoredSqueeze>([name = d->typeName, recipe = d->recipe,
                           grasp](Library& library) { return storeSqueeze(library, name, recipe, grasp); },
                          [this](Expected<StoredSqueeze> stored) {
                              if (!stored)
                                  return d->fail(stored.error(), Activity::Deciding);
                              d->type = stored->type;
                              d->squeezes.back().graspId = stored->graspId;
                              d->squeezes.back().decision = Decision::Accepted;
                              d->activity = Activity::Waiting;
                          });
    return {};
}

Expected<void> EnrollSession::reject(const QString& reason)
{
    EnrollSqueeze* squeeze = d->pending();
    if (!squeeze)
        return notNow(Words::tr("There is no squeeze to decide on."));
    squeeze->decision = Decision::Rejected;
    if (!reason.trimmed().isEmpty())
        squeeze->reason = reason.trimmed();
    d->activity = Activity::Waiting;
    return {};
}

Expected<void> EnrollSession::drop(int index, const QString& reason)
{
    const bool there = index >= 0 && static_cast<std::size_t>(index) < d->squeezes.size();
    if (!there || d->squeezes[static_cast<std::size_t>(index)].decision != Decision::Accepted)
        return notNow(Words::tr("Only an accepted squeeze can be dropped."));
    if (const Expected<void> may = d->waitingIn(d->step == Step::Review ? Step::Review : Step::Squeeze); !may)
        return may;
    const auto position = static_cast<std::size_t>(index);
    d->ask<void>([id = d->squeezes[position].graspId, reason,
                  who = d->operatorName](Library& library) { return library.dropGrasp(id, reason, who); },
                 [this, position, reason](Expected<void> dropped) {
                     if (!dropped)
                         return d->fail(dropped.error(), Activity::Waiting);
                     d->squeezes[position].decision = Decision::Rejected;
                     d->squeezes[position].reason = reason;
                     d->activity = Activity::Waiting;
                 });
    return {};
}

Expected<void> EnrollSession::review()
{
    if (const Expected<void> may = d->waitingIn(Step::Squeeze); !may)
        return may;
    if (acceptedCount() < leastSqueezes)
        return notNow(Words::tr("A type needs at least %1 accepted squeezes; there are %2.")
                          .arg(leastSqueezes)
                          .arg(acceptedCount()));
    d->step = Step::Review;
    return {};
}

Expected<void> EnrollSession::back()
{
    const bool fromReview = d->step == Step::Review;
    if (const Expected<void> may = d->waitingIn(fromReview ? Step::Review : Step::Recipe); !may)
        return may;
    d->step = fromReview ? Step::Squeeze : Step::Name;
    return {};
}

Expected<void> EnrollSession::approve()
{
    if (const Expected<void> may = d->waitingIn(Step::Review); !may)
        return may;
    if (acceptedCount() < leastSqueezes || !d->type)
        return notNow(Words::tr("A type needs at least %1 accepted squeezes; there are %2.")
                          .arg(leastSqueezes)
                          .arg(acceptedCount()));
    d->ask<void>(
        [id = d->type->id, who = d->operatorName](Library& library) { return library.approveType(id, who); },
        [this](Expected<void> approved) {
            if (!approved)
                return d->fail(approved.error(), Activity::Waiting);
            d->step = Step::Approved;
            d->activity = Activity::Waiting;
        });
    return {};
}

void EnrollSession::restart()
{
    d->job.cancel();
    d->task.forget();
    d->answer.forget();
    d->step = Step::Name;
    d->activity = Activity::Waiting;
    d->typeName.clear();
    d->part.clear();
    d->type.reset();
    d->squeezes.clear();
    d->error.reset();
}

bool EnrollSession::poll()
{
    switch (d->activity) {
    case Activity::Squeezing:
        d->job.poll();
        if (d->job.state() == SqueezeJob::State::Done)
            d->identify(d->job.recording(), d->connection.address());
        else if (d->job.state() == SqueezeJob::State::Failed)
            d->fail(*d->job.error(), Activity::Waiting);
        return true; // progress, at least
    case Activity::Identifying:
        if (std::optional<Identification> identification = d->task.take()) {
            d->identified(std::move(*identification));
            return true;
        }
        return false;
    case Activity::Storing:
        return d->answer.poll();
    case Activity::Waiting:
    case Activity::Deciding:
        break;
    }
    return false;
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
