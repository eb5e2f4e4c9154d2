// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect_session.h"

#include "core/recognition/early_verdict.h"
#include "core/session/comparable_units.h"
#include "core/session/early_watch.h"
#include "core/session/enrollment_storage.h"
#include "core/session/hold_history.h"
#include "core/session/library_answer.h"
#include "core/session/squeeze_forecast.h"
#include "core/signal/units.h"
#include "core/words.h"

#include <algorithm>
#include <list>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct Loaded {
    std::vector<TypeRecord> types;
    ComparableTypes comparable;
    InspectionCounts counts;
};

Expected<Loaded> load(Library& library)
{
    Expected<std::vector<TypeRecord>> types = library.types();
    if (!types)
        return tl::unexpected<Error>(types.error());
    const Expected<std::vector<TypeSqueeze>> squeezes = library.enrolledSqueezes();
    if (!squeezes)
        return tl::unexpected<Error>(squeezes.error());
    const Expected<InspectionCounts> counts = library.inspectionCounts();
    if (!counts)
        return tl::unexpected<Error>(counts.error());
    ComparableTypes comparable(*types, *squeezes);
    return Loaded{std::move(*types), std::move(comparable), *counts};
}

struct Stored {
    qint64 number = 0;
    InspectionCounts counts;
};

Expected<Stored> store(Library& library, const NewInspection& inspection)
{
    const Expected<InspectionRecord> added = library.addInspection(inspection);
    if (!added)
        return tl::unexpected<Error>(added.error());
    const Expected<InspectionCounts> counts = library.inspectionCounts();
    if (!counts)
        return tl::unexpected<Error>(counts.error());
    return Stored{added->number, *counts};
}

/// Answers to a reload and to a store may be told in another order than they were made; inspections only get
/// more.
const InspectionCounts& newer(const InspectionCounts& one, const InspectionCounts& other)
{
    return one.total >= other.total ? one : other;
}

/// An identification and the verdict on it, found together in the pool: a gate may take 50 ms.
struct Judged {
    Identification identification;
    Verdict verdict;
};

double lengthOf(const Recording& recording)
{
    return recording.time_s.empty()
               ? static_cast<double>(recording.size()) * recording.sampleTime_s
               : recording.time_s.back() - recording.time_s.front() + recording.sampleTime_s;
}

} // namespace

struct InspectSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), library(service), job(session)
    {
    }

    ConnectSession& connection;
    LibraryService& library;
    SqueezeJob job;
    PoolTask<Judged> task;
    EarlyWatch watch;
    SqueezeForecast forecast;
    int listener = 0;
    LibraryAnswer loading;
    std::list<LibraryAnswer> storing; // in the order the inspections were made
    IdentificationOptions options;
    VerdictOptions rates;
    std::optional<CommonShift> transfer;
    Recipe recipe;
    QString operatorName, expectedType;
    bool storeResults = true, endsEarly = true, forecasting = false;

    State state = State::Loading;
    Loaded loaded;
    Recording measured; // what is being identified
    HoldHistory holds;
    QString source, measuredExpectedType;
    std::optional<EarlyEnd> measuredEarlyEnd;
    VerdictOptions measuredRates; // those in force then; they may be set anew while it is judged
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
    void show(Judged judged);
    void keep();
    bool pollStoring();
};

void InspectSession::Private::reload()
{
    if (state == State::Ready)
        state = State::Loading;
    loading.await<Loaded>(library.run<Loaded>(load), [this](Expected<Loaded> answer) {
        if (!answer) {
            error = answer.error();
            return;
        }
        answer->counts = newer(answer->counts, loaded.counts);
        loaded = std::move(*answer);
        if (state == State::Loading) {
            state = State::Ready;
            error.reset();
        }
    });
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
    const auto type = std::find_if(loaded.types.begin(), loaded.types.end(),
                                   [this](const TypeRecord& record) { return record.name == expectedType; });
    return type == loaded.types.end() ? recipe : type->recipe;
}

void InspectSession::Private::begin(State next)
{
    state = next;
    result.reset();
    error.reset();
    watch.end();
    measuredEarlyEnd.reset();
    measuredExpectedType = expectedType;
}

void InspectSession::Private::fail(const Error& reason)
{
    error = reason;
    state = State::Ready;
}

std::optional<EarlyStopSetup> InspectSession::Private::earlyStopSetup() const
{
    const GripperIdentity identity = connection.identity();
    if (!endsEarly || transfer || !identity.commandable)
        return {};
    const Expected<ComparableTypes::Choice> choice =
        loaded.comparable.modelsFor(identity.forceUnit, identity.positionUnit);
    if (!choice)
        return {};
    EarlyStopSetup setup{choice->models, choice->factor, rates, {}, connection.measuringChain()};
    setup.rates.siUnits = siFactor(identity.forceUnit, identity.positionUnit).has_value();
    setup.decision.sampleTime_s = identity.sampleTime_s;
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
    const Expected<ComparableTypes::Choice> choice =
        loaded.comparable.modelsFor(recording.forceUnit, recording.positionUnit);
    if (!choice)
        return fail(choice.error());
    state = State::Judging;
    source = from;
    IdentificationOptions withEarlier = options;
    withEarlier.earlierHold = holds.before(recording, options);
    measuredRates = rates;
    measuredRates.siUnits = siFactor(recording.forceUnit, recording.positionUnit).has_value();
    measured = recording;
    task.start([recording = std::move(recording), withEarlier, judging = measuredRates, other = transfer,
                models = choice->models, factor = choice->factor] {
        Judged judged{gripscope::identify(recording, withEarlier), {}};
        judged.verdict = judge(*models, judged.identification, factor, judging, other);
        return judged;
    });
}

void InspectSession::Private::show(Judged judged)
{
    holds.add(measured, judged.identification);
    Result found;
    found.verdict = std::move(judged.verdict);
    found.earlyEnd = measuredEarlyEnd;
    if (found.earlyEnd)
        found.verdict =
            verdictOnEarlyEnd(std::move(found.verdict), *found.earlyEnd,
                              static_cast<double>(found.earlyEnd->samples) * measured.sampleTime_s);
    found.outcome = inspectionOutcome(found.verdict.kind, found.verdict.type, measuredExpectedType);
    found.expectedType = measuredExpectedType;
    found.seconds = lengthOf(measured);
    found.identification = std::move(judged.identification);
    found.recording = std::move(measured);
    result = std::move(found);
    state = State::Ready;
    if (storeResults)
        keep();
}

void InspectSession::Private::keep()
{
    NewInspection inspection;
    inspection.grasp = makeGrasp(result->recording, result->identification, source, operatorName);
    inspection.verdict = result->verdict;
    inspection.rates = measuredRates;
    inspection.expectedType = result->expectedType;
    inspection.seconds = result->seconds;
    const std::uint64_t which = squeezes;
    storing.emplace_back().await<Stored>(
        library.run<Stored>([inspection](Library& store_) { return store(store_, inspection); }),
        [this, which](Expected<Stored> stored) {
            if (!stored) {
                error = stored.error();
                return;
            }
            loaded.counts = newer(stored->counts, loaded.counts);
            if (result && which == squeezes)
                result->number = stored->number;
        });
}

bool InspectSession::Private::pollStoring()
{
    bool changed = false;
    while (!storing.empty() && storing.front().poll()) {
        storing.pop_front();
        changed = true;
    }
    return changed;
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
    d->rates = rates;
}

void InspectSession::setIdentificationOptions(const IdentificationOptions& options)
{
    d->options = options;
}

void InspectSession::setTransfer(const std::optional<CommonShift>& error)
{
    d->transfer = error;
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
    d->task.forget();
    d->fail({ErrorCode::Cancelled, {Words::tr("The inspection")}});
}

bool InspectSession::poll()
{
    bool changed = d->pollStoring();
    changed = d->loading.poll() || changed;
    if (d->state == State::Squeezing) {
        d->followSqueeze();
        return true; // progress, at least
    }
    if (d->state == State::Judging) {
        if (std::optional<Judged> judged = d->task.take()) {
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
    return d->rates;
}

InspectionCounts InspectSession::counts() const
{
    return d->loaded.counts;
}

const TypeModels& InspectSession::models() const
{
    return d->loaded.comparable.main();
}

const std::vector<TypeRecord>& InspectSession::types() const
{
    return d->loaded.types;
}

bool InspectSession::storing() const
{
    return !d->storing.empty();
}

std::optional<Error> InspectSession::lastError() const
{
    return d->error;
}

} // namespace gripscope
