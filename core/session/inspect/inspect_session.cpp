// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session.h"

#include "core/base/words.h"
#include "core/session/inspect/inspect_session_private.h"
#include "core/signal/recording/recording_limits.h"

namespace gripscope {

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

void InspectSession::setPolicy(const JudgingPolicy& policy)
{
    d->policy = policy;
}

const JudgingPolicy& InspectSession::policy() const
{
    return d->policy;
}

void InspectSession::setIdentificationOptions(const IdentificationOptions& options)
{
    d->judge.identification = options;
}

void InspectSession::setTransfer(const std::optional<CommonShift>& error)
{
    d->isTransferStated = true;
    d->statedTransfer = error;
}

void InspectSession::setTransferOfLibrary()
{
    d->isTransferStated = false;
    d->statedTransfer.reset();
}

void InspectSession::setRecipe(const Recipe& recipe)
{
    d->recipe = recipe;
}

void InspectSession::setStoring(bool store)
{
    d->storeResults = store;
}

void InspectSession::setClock(SqueezeJob::Clock clock)
{
    d->archive.setClock(clock);
    d->job.setClock(std::move(clock));
}

void InspectSession::setEarlyEnd(bool early)
{
    d->endsEarly = early;
}

void InspectSession::setWake(std::function<void()> wake)
{
    d->judge.wake = std::move(wake);
}

void InspectSession::setForecasting(bool on)
{
    d->forecasting = on;
}

void InspectSession::reload()
{
    d->reload();
}

void InspectSession::setPartNumber(const QString& number)
{
    d->partNumber = number;
}

void InspectSession::setShiftStart(qint64 after)
{
    d->archive.setShiftStart(after);
}

void InspectSession::voidLast(const QString& reason)
{
    if (!d->result || d->result->number == 0)
        return;
    d->archive.voidInspection(d->result->number, reason, d->operatorName,
                              [this, number = d->result->number](const Expected<void>& done) {
                                  d->noticeFailure(done);
                                  if (done) {
                                      d->drift.load(d->archive.comparable().main());
                                      d->process.look(d->processType);
                                  }
                                  if (done && d->result && d->result->number == number)
                                      d->result->voided = true;
                              });
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
    RETURN_IF_ERROR(d->ready());
    const Recipe recipe = d->wantedRecipe();
    const bool commandable = d->connection.identity().commandable;
    const Expected<void> started =
        commandable ? d->job.start(recipe, d->squeezes + 1) : d->job.listen(recipe.seconds);
    if (!started)
        return started;
    ++d->squeezes;
    d->begin(State::Squeezing);
    if (const std::optional<EarlyStopSetup> setup = d->earlyStopSetup())
        d->watch.begin(*setup, samplesIn(recipe.seconds, d->connection.identity().sampleTime_s));
    return {};
}

Expected<void> InspectSession::judgeRecording(Recording recording, const QString& source,
                                              const std::optional<EarlyEnd>& earlyEnd)
{
    RETURN_IF_ERROR(d->ready());
    ++d->squeezes;
    d->begin(State::Judging);
    d->measuredEarlyEnd = earlyEnd;
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
    const bool stored = d->archive.poll();
    const bool signalled = d->process.poll();
    const bool changed = d->drift.poll() || stored || signalled;
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

Recipe InspectSession::nextRecipe() const
{
    return d->wantedRecipe();
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

const InspectionCounts& InspectSession::shiftCounts() const
{
    return d->archive.shiftCounts();
}

const QString& InspectSession::expectedType() const
{
    return d->expectedType;
}

const QString& InspectSession::partNumber() const
{
    return d->partNumber;
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

std::vector<TypeRecord> InspectSession::approvedTypes() const
{
    std::vector<TypeRecord> approved = types();
    std::erase_if(approved, [](const TypeRecord& type) { return !type.approved; });
    return approved;
}

std::optional<AdjustmentStanding> InspectSession::adjustment() const
{
    const AdjustmentStanding* const standing = d->archive.adjustmentOf(d->connection.identity().serial);
    return standing != nullptr && !d->isTransferStated ? std::optional(*standing) : std::nullopt;
}

const std::optional<DriftReport>& InspectSession::drift() const
{
    return d->drift.report();
}

const std::optional<Finding>& InspectSession::processSignal() const
{
    return d->process.signal();
}

bool InspectSession::storing() const
{
    return d->archive.unstored() > 0 && !d->archive.obstacle();
}

std::size_t InspectSession::unstored() const
{
    return d->archive.unstored();
}

std::size_t InspectSession::spilled() const
{
    return d->archive.spilled();
}

std::optional<Error> InspectSession::lastError() const
{
    if (d->error)
        return d->error;
    return d->archive.obstacle() ? d->archive.obstacle() : d->archive.spillProblem();
}

} // namespace gripscope
