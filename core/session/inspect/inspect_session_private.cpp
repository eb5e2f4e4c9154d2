// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session_private.h"

#include "core/base/words.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/recognition/early/early_stop.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/conformity_of_squeeze.h"
#include "core/recognition/verdict/judgement.h"
#include "core/recognition/verdict/transfer.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/session/inspect/squeeze_judged.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <utility>

namespace gripscope {

void InspectSession::Private::reload()
{
    if (state == State::Ready)
        state = State::Loading;
    archive.load([this](const Expected<void>& done) {
        noticeFailure(done);
        if (done && storeResults) // who stores nothing watches nothing
            drift.load(archive.comparable().main());
        if (!done || state != State::Loading)
            return;
        error.reset();
        if (!storeResults || archive.spillKnown())
            state = State::Ready;
        else if (!archive.spillAsked())
            openSpill();
    });
}

void InspectSession::Private::openSpill()
{
    archive.openSpill(
        [this] {
            if (state == State::Loading)
                state = State::Ready;
        },
        [this](const Error& lost) { error = lost; });
}

void InspectSession::Private::noticeFailure(const Expected<void>& done)
{
    if (!done)
        error = done.error();
}

Expected<void> InspectSession::Private::ready()
{
    switch (state) {
    case State::Ready:
        break;
    case State::Loading:
        return failure(ErrorCode::Usage, {Words::tr("The library is still being read.")});
    case State::Squeezing:
    case State::Judging:
        return failure(ErrorCode::Usage, {Words::tr("The last squeeze is still being worked on.")});
    }
    if (!storeResults)
        return {};
    if (!archive.spillAsked()) // storing was not wanted before
        openSpill();
    return archive.roomForOneMore();
}

namespace {
/// For a part that may be of any of the approved types: by the one with the lowest crush limit, and no
/// further than the least travel that any of them bears.
Recipe gentlestRecipe(const std::vector<TypeRecord>& types)
{
    std::optional<Recipe> gentlest;
    double travel_m = Recipe().maxTravel_m;
    for (const TypeRecord& type : types) {
        if (!type.approved)
            continue;
        travel_m = gentlest ? std::min(travel_m, type.recipe.maxTravel_m) : type.recipe.maxTravel_m;
        if (!gentlest || type.recipe.maxForce_N < gentlest->maxForce_N)
            gentlest = type.recipe;
    }
    if (gentlest)
        gentlest->maxTravel_m = travel_m;
    return gentlest.value_or(Recipe());
}
} // namespace

Recipe InspectSession::Private::wantedRecipe() const
{
    const std::vector<TypeRecord>& types = archive.types();
    const auto type = std::find_if(types.begin(), types.end(),
                                   [this](const TypeRecord& record) { return record.name == expectedType; });
    if (type != types.end())
        return type->recipe;
    return recipe ? *recipe : gentlestRecipe(types);
}

void InspectSession::Private::begin(State next)
{
    state = next;
    result.reset();
    error.reset();
    watch.end();
    measuredEarlyEnd.reset();
    measuredExpectedType = expectedType;
    measuredPolicy = policy;
    const std::optional<BatchRecord>& batch = archive.batch();
    measuredBatch = batch && !batch->ended ? batch->id : QString();
    measuredPartNumber = std::exchange(partNumber, {});
}

void InspectSession::Private::fail(const Error& reason)
{
    error = reason;
    state = State::Ready;
    if (partNumber.isEmpty())
        partNumber = measuredPartNumber; // the part has still to be squeezed
}

std::optional<CommonShift> InspectSession::Private::transferOf(const QString& gripperSerial) const
{
    if (isTransferStated)
        return statedTransfer;
    const AdjustmentStanding* const adjustment = archive.adjustmentOf(gripperSerial);
    return adjustment != nullptr ? std::optional(adjustment->record.adjustment.error) : std::nullopt;
}

std::optional<EarlyStopSetup> InspectSession::Private::earlyStopSetup() const
{
    const GripperIdentity identity = connection.identity();
    if (!endsEarly || transferOf(identity.serial) || !identity.commandable)
        return {};
    // How a part stands to its limits is told the better the longer it is squeezed.
    if (std::ranges::any_of(archive.types(),
                            [](const TypeRecord& type) { return type.approved && !type.limits.isEmpty(); }))
        return {};
    const Expected<ComparableTypes::Choice> choice =
        archive.comparable().modelsFor(identity.forceUnit, identity.positionUnit);
    if (!choice)
        return {};
    const std::shared_ptr<const TypeModels> models = choice->types->whole();
    // What is known while a squeeze goes on is m, b and k, of a part that has no more than these: one that
    // yields or rubs would be taken for a stranger.
    if (models->space != QuantitySpace{} || !choice->types->allDetermineTheSame())
        return {};
    EarlyStopSetup setup{models, choice->factor, judge.rates, {}, connection.measuringChain()};
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
                                                  connection.identity().sampleTime_s)
                       .english());
    if (job.state() == SqueezeJob::State::Done) {
        if (job.endedEarly())
            measuredEarlyEnd = watch.decision();
        job.note(toNote(SqueezeJudged{judge.rates, measuredEarlyEnd, measuredPolicy,
                                      transferOf(connection.identity().serial)}));
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
    const QString serial = recording.provenance.value(QStringLiteral("serial"));
    const AdjustmentStanding* const adjustment = isTransferStated ? nullptr : archive.adjustmentOf(serial);
    judgedTransfer = transferOf(serial);
    judgedAdjustment = adjustment != nullptr ? adjustment->record.id : QString();
    const Expected<void> started = judge.start(std::move(recording), archive.comparable(), judgedTransfer);
    if (!started)
        return fail(started.error());
    judgedVersion = archive.version();
    judgedTypes = archive.types();
    state = State::Judging;
}

std::optional<Conformity> InspectSession::Private::conformityTo(const QString& type,
                                                                const InspectionJudge::Judged& judged) const
{
    const auto named = std::ranges::find(judgedTypes, type, &TypeRecord::name);
    if (named == judgedTypes.end())
        return {};
    const Recording& recording = judged.recording;
    const Expected<double> factor =
        parameterFactor(recording.forceUnit, recording.positionUnit, named->forceUnit, named->positionUnit);
    if (!factor)
        return {};
    return conformityOf(named->limits, judged.identification, *factor,
                        siFactor(named->forceUnit, named->positionUnit), judgedTransfer);
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
    if (Findings reasons = refusals(measuredPolicy, judged.recording, judged.identification);
        !reasons.empty() && found.verdict.kind != VerdictKind::Invalid) {
        found.verdict = refusedVerdict(found.verdict, std::move(reasons));
        found.refused = true;
    }
    if (found.verdict.kind == VerdictKind::Type)
        found.verdict.conformity = conformityTo(found.verdict.type, judged);
    found.outcome = inspectionOutcome(PartJudged(found.verdict), found.verdict.type, measuredExpectedType);
    found.expectedType = measuredExpectedType;
    found.partNumber = measuredPartNumber;
    found.rates = judged.rates;
    found.adjustmentId = judgedAdjustment;
    invalidInARow = found.outcome == InspectionOutcome::NotValid ? invalidInARow + 1 : 0;
    found.invalidInARow = invalidInARow;
    found.seconds = lengthSeconds(judged.recording);
    found.squeeze = squeezes;
    found.identification = std::move(judged.identification);
    found.recording = std::move(judged.recording);
    found.keeping = storeResults ? Keeping::Waiting : Keeping::NotWanted;
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
    inspection.libraryVersion = judgedVersion;
    inspection.partNumber = result->partNumber;
    inspection.adjustmentId = result->adjustmentId;
    inspection.grasp.program = QStringLiteral(GRIPSCOPE_VERSION); // another may store it
    inspection.id = newTimeOrderedId();
    const QDateTime now = QDateTime::currentDateTime();
    inspection.grasp.recorded = now.toUTC();
    inspection.grasp.utcOffset_s = now.offsetFromUtc();
    watchDrift(inspection);
    archive.keep(inspection,
                 [this, which = squeezes, type = inspection.verdict.type](const Expected<qint64>& number) {
                     if (!number)
                         error = number.error();
                     else
                         process.look(processType = type);
                     if (!result || result->squeeze != which)
                         return;
                     result->keeping = number ? Keeping::Stored : Keeping::Refused;
                     result->number = number.value_or(0);
                 });
}

/// Those that the charts go by: of the type that was expected, else the one that was named.
void InspectSession::Private::watchDrift(const NewInspection& inspection)
{
    const QString type =
        inspection.expectedType.isEmpty() ? inspection.verdict.type : inspection.expectedType;
    const bool recognised = inspection.verdict.kind == VerdictKind::Type && inspection.verdict.type == type;
    if (!recognised || inspection.grasp.estimates.empty())
        return;
    const Estimate& object = inspection.grasp.estimates.front(); // the one that stands for the squeeze
    if (!object.parameters)
        return;
    const TypeSqueeze squeeze =
        scaledSqueeze(type, *object.parameters, object.covariance,
                      siFactor(inspection.grasp.forceUnit, inspection.grasp.positionUnit).value_or(1));
    drift.add(judgedTransfer ? adjusted(squeeze, *judgedTransfer) : squeeze);
}

Expected<void> InspectionJudge::start(Recording recording, const ComparableTypes& types,
                                      const std::optional<CommonShift>& transfer)
{
    ASSIGN_OR_RETURN(const ComparableTypes::Choice choice,
                     types.modelsFor(recording.forceUnit, recording.positionUnit));
    IdentificationOptions withEarlier = identification;
    withEarlier.earlierHold = m_holds.before(recording, identification);
    m_ratesThen = rates;
    m_ratesThen.siUnits = siFactor(recording.forceUnit, recording.positionUnit).has_value();
    m_measured = recording;
    m_task = inPool([recording = std::move(recording), withEarlier, judging = m_ratesThen, other = transfer,
                     types = choice.types] {
        Found found{identify(recording, withEarlier), {}};
        found.verdict = judgeRecording(*types, found.identification, recording, judging, other);
        return found;
    });
    m_task.whenReady(wake);
    return {};
}

std::optional<InspectionJudge::Judged> InspectionJudge::take()
{
    std::optional<Found> found = m_task.take();
    if (!found)
        return {};
    m_holds.add(m_measured, found->identification);
    return Judged{std::move(m_measured), std::move(found->identification), std::move(found->verdict),
                  m_ratesThen};
}

} // namespace gripscope
