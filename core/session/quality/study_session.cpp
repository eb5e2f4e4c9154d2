// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_session.h"

#include "core/base/words.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/quality/plan/plan_json.h"
#include "core/quality/plan/plan_words.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/session/tasks/pool.h"

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> studyUsage(const Finding& why)
{
    return failure(ErrorCode::Usage, {why});
}

} // namespace

struct StudySession::Private {
    Private(ConnectSession& session, LibraryService& library)
        : connection(session), service(library), job(session)
    {
    }

    ConnectSession& connection;
    LibraryService& service;
    SqueezeJob job;
    IdentificationOptions options;
    QString operatorName;
    QMap<QString, Recipe> partRecipes;

    State state = State::Idle;
    std::optional<KeptStudy> study;
    std::size_t row = 0; // being squeezed
    Recording recording;
    Pending<Identification> identifying;
    PendingCall answer;
    Pending<Expected<StudyResult>> evaluating;
    std::optional<Expected<StudyResult>> result;
    Findings refusal;
    std::optional<Error> error;

    /// `then` is called with what the library answers; its error is told, and the state is `otherwise` then.
    template <typename T>
    void ask(std::function<Expected<T>(Library&)> work, State otherwise, std::function<void(T)> then)
    {
        state = State::Storing;
        error.reset();
        answer = PendingCall(service.run<T>(std::move(work)),
                             [this, otherwise, then = std::move(then)](Expected<T> answered) {
                                 if (answered)
                                     return then(std::move(*answered));
                                 error = answered.error();
                                 state = otherwise;
                             });
    }

    [[nodiscard]] Expected<void> waiting() const;
    [[nodiscard]] Expected<std::size_t> rowToDo() const;
    [[nodiscard]] Expected<void> sameGripper() const;
    [[nodiscard]] QString personAt(std::size_t planRow) const;
    [[nodiscard]] NewStudyMeasurement attemptAt(std::size_t planRow, AttemptOutcome outcome) const;
    void take(KeptStudy kept);
    void load(const QString& studyId);
    void store(NewStudyMeasurement measured);
    void end(StudyState how, const QString& reason);
    void followSqueeze();
    void followIdentification();
};

Expected<void> StudySession::Private::waiting() const
{
    if (state == State::Waiting)
        return {};
    return studyUsage(state == State::Idle || state == State::Ended
                          ? Words::say("No study is under way. Begin one, or go on with one.")
                          : Words::say("The last squeeze is still being worked on."));
}

Expected<std::size_t> StudySession::Private::rowToDo() const
{
    RETURN_IF_ERROR(waiting());
    if (const std::optional<std::size_t> next = study->progress().next)
        return *next;
    return studyUsage(Words::say("All squeezes of the study are through. Finish it."));
}

Expected<void> StudySession::Private::sameGripper() const
{
    // A plan with stations goes from gripper to gripper.
    const QString begun = study->record.study.gripperSerial;
    const QString here = connection.identity().serial;
    if (!study->plan.design.stations.isEmpty() || begun.isEmpty() || begun == here)
        return {};
    return studyUsage(Words::say("The study was begun with gripper %1, and %2 is connected. Connect the "
                                 "first one, or begin a study of its own.")
                          .arg(begun, here.isEmpty() ? Finding(u"-") : Finding(here)));
}

QString StudySession::Private::personAt(std::size_t planRow) const
{
    const QString planned = study->plan.operatorName(planRow);
    return planned.isEmpty() ? operatorName : planned;
}

NewStudyMeasurement StudySession::Private::attemptAt(std::size_t planRow, AttemptOutcome outcome) const
{
    NewStudyMeasurement attempt;
    attempt.studyId = study->record.id;
    attempt.row = qint64(planRow);
    attempt.outcome = toString(outcome);
    attempt.gripperSerial = connection.identity().serial;
    attempt.operatorName = personAt(planRow);
    return attempt;
}

void StudySession::Private::take(KeptStudy kept)
{
    study = std::move(kept);
    refusal.clear();
    evaluating.forget(); // of the study before
    result.reset();
    state = study->record.state == StudyState::Open ? State::Waiting : State::Ended;
    if (study->record.state == StudyState::Finished)
        evaluating = inPool([kept = *study] { return resultOf(kept); });
}

void StudySession::Private::load(const QString& studyId)
{
    ask<KeptStudy>([studyId](Library& library) { return readStudy(library, studyId); }, State::Idle,
                   [this](KeptStudy kept) { take(std::move(kept)); });
}

void StudySession::Private::store(NewStudyMeasurement measured)
{
    ask<StudyMeasurementRecord>(
        [measured = std::move(measured)](Library& library) { return library.addStudyMeasurement(measured); },
        State::Waiting,
        [this](StudyMeasurementRecord stored) {
            const bool isInvalid = stored.measured.outcome == toString(AttemptOutcome::Invalid);
            refusal = isInvalid ? stored.measured.reasons : Findings();
            study->measurements.push_back(std::move(stored));
            state = State::Waiting;
        });
}

void StudySession::Private::end(StudyState how, const QString& reason)
{
    ask<KeptStudy>(
        [id = study->record.id, how, reason, who = operatorName](Library& library) {
            return library.endStudy(id, how, reason, who).and_then([&](const StudyRecord& ended) {
                return readStudy(library, ended.id);
            });
        },
        State::Waiting, [this](KeptStudy kept) { take(std::move(kept)); });
}

void StudySession::Private::followSqueeze()
{
    job.poll();
    if (job.state() == SqueezeJob::State::Failed) {
        error = job.error();
        state = State::Waiting;
    } else if (job.state() == SqueezeJob::State::Done) {
        recording = job.recording();
        state = State::Identifying;
        identifying =
            inPool([recording = recording, options = options] { return identify(recording, options); });
    }
}

void StudySession::Private::followIdentification()
{
    const std::optional<Identification> found = identifying.take();
    if (!found)
        return;
    NewStudyMeasurement measured = squeezeMeasured(*found, recording);
    NewStudyMeasurement attempt = attemptAt(row, AttemptOutcome::Measured);
    measured.studyId = attempt.studyId;
    measured.row = attempt.row;
    measured.gripperSerial = attempt.gripperSerial;
    measured.operatorName = attempt.operatorName;
    measured.squeeze =
        DraftSqueeze{newTimeOrderedId(), study->record.study.name, std::exchange(recording, {}),
                     connection.address(), study->plan.part(row)};
    store(std::move(measured));
}

StudySession::StudySession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
}

StudySession::~StudySession() = default;

void StudySession::setOperator(const QString& name)
{
    d->operatorName = name;
}

void StudySession::setIdentificationOptions(const IdentificationOptions& options)
{
    d->options = options;
}

void StudySession::setPartRecipes(const QMap<QString, Recipe>& recipes)
{
    d->partRecipes = recipes;
}

Expected<void> StudySession::begin(const StudyRequest& request)
{
    if (d->state != State::Idle && d->state != State::Ended)
        return studyUsage(Words::say("A study is under way. Finish or abandon it first."));
    ASSIGN_OR_RETURN(const StudyPlan plan, makePlan(request.design));
    if (const auto problem = forceProblem(request.recipe, d->connection.identity()))
        return tl::unexpected<Error>(*problem);
    NewStudy asked;
    asked.kind = toString(request.design.kind);
    asked.name = request.name;
    asked.plan = planJson(plan);
    asked.options = toJson(request.options);
    asked.recipe = request.recipe;
    asked.gripperSerial = d->connection.identity().serial;
    asked.operatorName = d->operatorName;
    d->ask<KeptStudy>(
        [asked](Library& library) {
            return library.beginStudy(asked).and_then(
                [&](const StudyRecord& begun) { return readStudy(library, begun.id); });
        },
        State::Idle, [this](KeptStudy kept) { d->take(std::move(kept)); });
    return {};
}

Expected<void> StudySession::resume(const QString& studyId)
{
    if (d->state != State::Idle && d->state != State::Ended)
        return studyUsage(Words::say("A study is under way. Finish or abandon it first."));
    d->load(studyId);
    return {};
}

Expected<void> StudySession::squeeze()
{
    ASSIGN_OR_RETURN(const std::size_t row, d->rowToDo());
    RETURN_IF_ERROR(d->sameGripper());
    const Recipe recipe = d->partRecipes.value(d->study->plan.part(row), d->study->record.study.recipe);
    d->job.setOperator(d->personAt(row));
    // Each with a seed of its own: what depended on one sequence would not show as scatter.
    const std::uint64_t seed = d->study->plan.design.seed + d->study->measurements.size() + 1;
    const bool commandable = d->connection.identity().commandable;
    RETURN_IF_ERROR(commandable ? d->job.start(recipe, seed) : d->job.listen(recipe.seconds));
    d->row = row;
    d->error.reset();
    d->state = State::Squeezing;
    return {};
}

Expected<void> StudySession::rate(const QString& rating)
{
    ASSIGN_OR_RETURN(const std::size_t row, d->rowToDo());
    if (d->study->plan.design.kind != StudyKind::Attributes || rating.trimmed().isEmpty())
        return studyUsage(Words::say("What a rater says of a part is a word of a study of attributes."));
    NewStudyMeasurement rated = d->attemptAt(row, AttemptOutcome::Measured);
    rated.rating = rating.trimmed();
    d->store(std::move(rated));
    return {};
}

Expected<void> StudySession::skip(const QString& reason)
{
    ASSIGN_OR_RETURN(const std::size_t row, d->rowToDo());
    NewStudyMeasurement skipped = d->attemptAt(row, AttemptOutcome::Skipped);
    if (!reason.trimmed().isEmpty())
        skipped.reasons = {Finding(reason.trimmed())};
    d->store(std::move(skipped));
    return {};
}

Expected<void> StudySession::undo(const QString& reason)
{
    RETURN_IF_ERROR(d->waiting());
    const std::optional<std::size_t> newest = d->study->progress().undoable;
    if (!newest)
        return studyUsage(Words::say("There is nothing to take back."));
    const QString id = d->study->measurements[*newest].id;
    using Measurements = std::vector<StudyMeasurementRecord>;
    d->ask<Measurements>(
        [id, reason, study = d->study->record.id, who = d->operatorName](Library& library) {
            return library.undoStudyMeasurement(id, reason, who).and_then([&] {
                return library.studyMeasurements(study);
            });
        },
        State::Waiting,
        [this](Measurements measurements) {
            d->study->measurements = std::move(measurements);
            d->refusal.clear();
            d->state = State::Waiting;
        });
    return {};
}

Expected<void> StudySession::finish(const QString& reason)
{
    RETURN_IF_ERROR(d->waiting());
    const std::size_t left = d->study->progress().left();
    if (left > 0 && reason.trimmed().isEmpty())
        return studyUsage(
            Words::say("%1 squeezes are left. Make them, or say why the study ends without them.").arg(left));
    d->end(StudyState::Finished, reason.trimmed());
    return {};
}

Expected<void> StudySession::abandon(const QString& reason)
{
    RETURN_IF_ERROR(d->waiting());
    d->end(StudyState::Abandoned, reason.trimmed());
    return {};
}

void StudySession::cancel()
{
    d->job.cancel();
    d->identifying.forget();
    if (d->state == State::Squeezing || d->state == State::Identifying) {
        d->error = Error{ErrorCode::Cancelled, {Words::say("The squeeze")}};
        d->state = State::Waiting;
    }
}

void StudySession::leave()
{
    if (d->state != State::Waiting && d->state != State::Ended)
        return;
    d->evaluating.forget();
    d->study.reset();
    d->refusal.clear();
    d->result.reset();
    d->error.reset();
    d->state = State::Idle;
}

bool StudySession::poll()
{
    const State before = d->state;
    bool told = false;
    if (d->state == State::Squeezing) {
        d->followSqueeze();
        told = true; // progress, at least
    } else if (d->state == State::Identifying) {
        d->followIdentification();
    } else if (d->state == State::Storing) {
        told = d->answer.poll();
    }
    if (std::optional<Expected<StudyResult>> found = d->evaluating.take()) {
        d->result = std::move(found);
        told = true;
    }
    return told || d->state != before;
}

StudySession::State StudySession::state() const
{
    return d->state;
}

bool StudySession::busy() const
{
    return d->state == State::Squeezing || d->state == State::Identifying || d->state == State::Storing;
}

double StudySession::squeezeProgress() const
{
    return d->state == State::Squeezing ? d->job.progress() : 0;
}

const std::optional<KeptStudy>& StudySession::study() const
{
    return d->study;
}

StudyProgress StudySession::progress() const
{
    return d->study ? d->study->progress() : StudyProgress();
}

std::optional<std::size_t> StudySession::nextRow() const
{
    return progress().next;
}

Finding StudySession::instruction() const
{
    const std::optional<std::size_t> next = nextRow();
    return next ? gripscope::instruction(d->study->plan, *next) : Finding();
}

std::vector<StudyMeasurementRecord> StudySession::shownMeasurements() const
{
    if (!d->study || (d->study->plan.design.blind && d->study->record.state == StudyState::Open))
        return {};
    return d->study->measurements;
}

const Findings& StudySession::refusal() const
{
    return d->refusal;
}

std::optional<Error> StudySession::lastError() const
{
    return d->error;
}

const std::optional<Expected<StudyResult>>& StudySession::result() const
{
    return d->result;
}

} // namespace gripscope
