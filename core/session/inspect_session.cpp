// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect_session.h"

#include "core/recognition/early_verdict.h"
#include "core/session/early_watch.h"
#include "core/session/enrollment_storage.h"
#include "core/session/inspection_archive.h"
#include "core/session/inspection_judge.h"
#include "core/session/squeeze_forecast.h"
#include "core/signal/units.h"
#include "core/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

double lengthOf(const Recording& recording)
{
    return recording.time_s.empty()
               ? static_cast<double>(recording.size()) * recording.sampleTime_s
               : recording.time_s.back() - recording.time_s.front() + recording.sampleTime_s;
}

} // namespace

struct InspectSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), archive(service), job(session)
    {
    }

    ConnectSession& connection;
    InspectionArchive archive;
    SqueezeJob job;
    InspectionJudge judge;
    EarlyWatch watch;
    SqueezeForecast forecast;
    int listener = 0;
    Recipe recipe;
    QString operatorName, expectedType;
    bool storeResults = true, endsEarly = true, forecasting = false;

    State state = State::Loading;
    QString source, measuredExpectedType, measuredBatch; // as they were when the squeeze began
    std::optional<EarlyEnd> measuredEarlyEnd;
    std::uint64_t squeezes = 0;
    std::optional<Result> result;
    std::optional<Error> error;

    void reload();
    [[nodiscard]] Expected<void> ready() const;
    [[nodiscard]] Recipe wantedRecipe() const;
    [[nodiscard]] std::optional<EarlyStopSetup> earlyStopSetup() const;
    void begin(State next);
    void followSqueeze();
    bool pollForecast();
    void fail(const Error& reason);
    void identify(Recording recording, const QString& from);
    void show(InspectionJudge::Judged judged);
    void keep(const VerdictOptions& rates);
    void noticeFailure(const Expected<void>& done);
};

void InspectSession::Private::reload()
{
    if (state == State::Ready)
        state = State::Loading;
    archive.load([this](const Expected<void>& done) {
        noticeFailure(done);
        if (done && state == State::Loading) {
            state = State::Ready;
            error.reset();
        }
    });
}

void InspectSession::Private::noticeFailure(const Expected<void>& done)
{
    if (!done)
        error = done.error();
}

Expected<void> InspectSession::Private::ready() const
{
    switch (state) {
    case State::Ready:
        return {};
    case State::Loading:
        return failure(ErrorCode::Usage, {Words::tr("The library is still being read.")});
    case State::Squeezing:
    case State::Judging:
        break;
    }
    return failure(ErrorCode::Usage, {Words::tr("The last squeeze is still being worked on.")});
}

Recipe InspectSession::Private::wantedRecipe() const
{
    const std::vector<TypeRecord>& types = archive.types();
    const auto type = std::find_if(types.begin(), types.end(),
                                   [this](const TypeRecord& record) { return record.name == expectedType; });
    return type == types.end() ? recipe : type->recipe;
}

void InspectSession::Private::begin(State next)
{
    state = next;
    result.reset();
    error.reset();
    watch.end();
    measuredEarlyEnd.reset();
    measuredExpectedType = expectedType;
    const std::optional<BatchRecord>& batch = archive.batch();
    measuredBatch = batch && !batch->ended ? batch->id : QString();
}

void InspectSession::Private::fail(const Error& reason)
{
    error = reason;
    state = State::Ready;
}

std::optional<EarlyStopSetup> InspectSession::Private::earlyStopSetup() const
{
    const GripperIdentity identity = connection.identity();
    if (!endsEarly || judge.transfer || !identity.commandable)
        return {};
    const Expected<ComparableTypes::Choice> choice =
        archive.comparable().modelsFor(identity.forceUnit, identity.positionUnit);
    if (!choice)
        return {};
    EarlyStopSetup setup{choice->models, choice->factor, judge.rates, {}, connection.measuringChain()};
    setup.rates.siUnits = siFactor(identity.forceUnit, identity.positionUnit).has_value();
    setup.decision.sampleTime_s = identity.sampleTime_s;
    const IdentificationOptions& options = judge.identification;
    setup.decision.hold = options.hold.value_or(identity.hold);
    setup.decision.lag_s = connection.forceLag_s();
    setup.decision.freeInitialState = options.initialState == InitialState::Free;
    setup.decision.freeOffset = options.freeOffset;
    return setup;
}

void InspectSession::Private::followSqueeze()
{
    job.poll();
    watch.poll();
    if (watch.decision())
        job.finish(inWords(*watch.decision(), static_cast<double>(watch.decision()->samples) *
                                                  connection.identity().sampleTime_s));
    if (job.state() == SqueezeJob::State::Done) {
        if (job.endedEarly())
            measuredEarlyEnd = watch.decision();
        identify(job.recording(), connection.address());
    } else if (job.state() == SqueezeJob::State::Failed) {
        fail(*job.error());
    }
}

bool InspectSession::Private::pollForecast()
{
    if (!forecasting || state != State::Ready)
        return false;
    const std::optional<EarlyStopSetup> setup =
        connection.state() == ConnectSession::State::Connected ? earlyStopSetup() : std::nullopt;
    if (setup)
        forecast.ask(*setup, wantedRecipe());
    else
        forecast.forget();
    return forecast.poll();
}

void InspectSession::Private::identify(Recording recording, const QString& from)
{
    source = from;
    if (const Expected<void> started = judge.start(std::move(recording), archive.comparable()); !started)
        return fail(started.error());
    state = State::Judging;
}

void InspectSession::Private::show(InspectionJudge::Judged judged)
{
    Result found;
    found.verdict = std::move(judged.verdict);
    found.earlyEnd = measuredEarlyEnd;
    if (found.earlyEnd)
        found.verdict =
            verdictOnEarlyEnd(std::move(found.verdict), *found.earlyEnd,
                              static_cast<double>(found.earlyEnd->samples) * judged.recording.sampleTime_s);
    found.outcome = inspectionOutcome(found.verdict.kind, found.verdict.type, measuredExpectedType);
    found.expectedType = measuredExpectedType;
    found.seconds = lengthOf(judged.recording);
    found.squeeze = squeezes;
    found.identification = std::move(judged.identification);
    found.recording = std::move(judged.recording);
    result = std::move(found);
    state = State::Ready;
    if (storeResults)
        keep(judged.rates);
}

void InspectSession::Private::keep(const VerdictOptions& rates)
{
    NewInspection inspection;
    inspection.grasp = makeGrasp(result->recording, result->identification, source, operatorName);
    inspection.verdict = result->verdict;
    inspection.rates = rates;
    inspection.expectedType = result->expectedType;
    inspection.seconds = result->seconds;
    inspection.batchId = measuredBatch;
    archive.keep(inspection, [this, which = squeezes](const Expected<qint64>& number) {
        if (!number)
            error = number.error();
        else if (result && result->squeeze == which)
            result->number = *number;
    });
}

InspectSession::InspectSession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
    d->listener = connection.addListener([this](const std::vector<Sample>& batch) {
        if (d->state == State::Squeezing)
            d->watch.take(batch);
    });
    d->reload();
}

InspectSession::~InspectSession()
{
    d->connection.removeListener(d->listener);
}

void InspectSession::setOperator(const QString& name)
{
    d->operatorName = name;
    d->job.setOperator(name);
}

void InspectSession::setExpectedType(const QString& name)
{
    d->expectedType = name;
}

void InspectSession::setRates(const VerdictOptions& rates)
{
    d->judge.rates = rates;
}

void InspectSession::setIdentificationOptions(const IdentificationOptions& options)
{
    d->judge.identification = options;
}

void InspectSession::setTransfer(const std::optional<CommonShift>& error)
{
    d->judge.transfer = error;
}

void InspectSession::setRecipe(const Recipe& recipe)
{
    d->recipe = recipe;
}

void InspectSession::setStoring(bool store)
{
    d->storeResults = store;
}

void InspectSession::setEarlyEnd(bool early)
{
    d->endsEarly = early;
}

void InspectSession::setForecasting(bool on)
{
    d->forecasting = on;
}

void InspectSession::reload()
{
    d->reload();
}

void InspectSession::beginBatch(const NewBatch& batch)
{
    NewBatch asked = batch;
    asked.operatorName = d->operatorName;
    d->archive.beginBatch(asked, [this](const Expected<void>& done) { d->noticeFailure(done); });
}

void InspectSession::endBatch()
{
    d->archive.endBatch(d->operatorName, [this](const Expected<void>& done) { d->noticeFailure(done); });
}

Expected<void> InspectSession::squeeze()
{
    if (const Expected<void> may = d->ready(); !may)
        return may;
    const Recipe recipe = d->wantedRecipe();
    const bool commandable = d->connection.identity().commandable;
    const Expected<void> started =
        commandable ? d->job.start(recipe, d->squeezes + 1) : d->job.listen(recipe.seconds);
    if (!started)
        return started;
    ++d->squeezes;
    d->begin(State::Squeezing);
    if (const std::optional<EarlyStopSetup> setup = d->earlyStopSetup())
        d->watch.begin(*setup);
    return {};
}

Expected<void> InspectSession::judgeRecording(Recording recording, const QString& source)
{
    if (const Expected<void> may = d->ready(); !may)
        return may;
    ++d->squeezes;
    d->begin(State::Judging);
    d->identify(std::move(recording), source);
    return {};
}

void InspectSession::cancel()
{
    if (d->state != State::Squeezing && d->state != State::Judging)
        return;
    d->job.cancel();
    d->judge.forget();
    d->fail({ErrorCode::Cancelled, {Words::tr("The inspection")}});
}

bool InspectSession::poll()
{
    const bool changed = d->archive.poll();
    if (d->state == State::Squeezing) {
        d->followSqueeze();
        return true; // progress, at least
    }
    if (d->state == State::Judging) {
        if (std::optional<InspectionJudge::Judged> judged = d->judge.take()) {
            d->show(std::move(*judged));
            return true;
        }
    }
    return d->pollForecast() || changed;
}

InspectSession::State InspectSession::state() const
{
    return d->state;
}

double InspectSession::progress() const
{
    return d->state == State::Squeezing ? d->job.progress() : 0;
}

const std::optional<InspectSession::Result>& InspectSession::result() const
{
    return d->result;
}

bool InspectSession::looking() const
{
    return d->watch.busy();
}

const std::optional<EarlyTimes>& InspectSession::forecast() const
{
    return d->forecast.times();
}

double InspectSession::longestSeconds() const
{
    return d->wantedRecipe().seconds;
}

bool InspectSession::earlyEnd() const
{
    return d->endsEarly;
}

const VerdictOptions& InspectSession::rates() const
{
    return d->judge.rates;
}

InspectionCounts InspectSession::counts() const
{
    return d->archive.counts();
}

const std::optional<BatchRecord>& InspectSession::batch() const
{
    return d->archive.batch();
}

bool InspectSession::changingBatch() const
{
    return d->archive.changingBatch();
}

const TypeModels& InspectSession::models() const
{
    return d->archive.comparable().main();
}

const std::vector<TypeRecord>& InspectSession::types() const
{
    return d->archive.types();
}

bool InspectSession::storing() const
{
    return d->archive.storing();
}

std::optional<Error> InspectSession::lastError() const
{
    return d->error;
}

} // namespace gripscope
