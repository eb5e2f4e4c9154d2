// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/lag_session.h"

#include "core/session/library_answer.h"
#include "core/signal/preparation.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

struct LagSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), library(service), job(session)
    {
    }

    ConnectSession& connection;
    LibraryService& library;
    SqueezeJob job;
    PoolTask<LagEstimate> task;
    LibraryAnswer storing;
    Recipe recipe;
    QString operatorName, serial;
    int wanted = 0;

    State state = State::Idle;
    std::vector<LagEstimate> squeezes;
    LagEstimate result;
    std::optional<Error> error;

    [[nodiscard]] Expected<void> squeeze();
    void fail(const Error& reason);
    void followSqueeze();
    void followJudging();
};

Expected<void> LagSession::Private::squeeze()
{
    // Each with a seed of its own: a lag that depended on one sequence would show as scatter.
    const Expected<void> started = job.start(recipe, squeezes.size() + 1);
    if (started)
        state = State::Squeezing;
    return started;
}

void LagSession::Private::fail(const Error& reason)
{
    error = reason;
    state = State::Failed;
}

void LagSession::Private::followSqueeze()
{
    job.poll();
    if (job.state() == SqueezeJob::State::Failed)
        return fail(*job.error());
    if (job.state() != SqueezeJob::State::Done)
        return;
    state = State::Judging;
    task.start([recording = job.recording()] { return estimateLag(recording); });
}

void LagSession::Private::followJudging()
{
    std::optional<LagEstimate> found = task.take();
    if (!found)
        return;
    squeezes.push_back(std::move(*found));
    if (static_cast<int>(squeezes.size()) < wanted) {
        if (const Expected<void> next = squeeze(); !next)
            fail(next.error());
        return;
    }
    result = combineLags(squeezes);
    state = State::Measured;
}

LagSession::LagSession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
}

LagSession::~LagSession() = default;

void LagSession::setOperator(const QString& name)
{
    d->operatorName = name;
    d->job.setOperator(name);
}

Expected<void> LagSession::start(const Recipe& recipe, int squeezes)
{
    if (d->state == State::Squeezing || d->state == State::Judging || d->state == State::Storing)
        return failure(ErrorCode::Usage,
                       {Words::tr("The lag is being measured. Wait for its end or stop it.")});
    d->recipe = recipe;
    d->wanted = squeezes;
    d->squeezes.clear();
    d->result = {};
    d->error.reset();
    d->serial = d->connection.identity().serial;
    return d->squeeze();
}

void LagSession::cancel()
{
    d->job.cancel();
    d->task.forget();
    if (d->state == State::Squeezing || d->state == State::Judging)
        d->fail({ErrorCode::Cancelled, {Words::tr("The measurement of the lag")}});
}

Expected<void> LagSession::accept()
{
    if (d->state != State::Measured || d->result.status != LagStatus::Measured)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no lag that was measured well enough to be used.")});
    NewMeasuringChain measured;
    measured.gripperSerial = d->serial;
    measured.forceLag_s = d->result.lag_s;
    measured.chain = d->connection.measuringChain();
    measured.chain.forceLagUncertainty_s = d->result.standardError_s;
    measured.operatorName = d->operatorName;
    measured.basis = Words::tr("lag from %1 squeezes").arg(d->result.squeezes);
    d->state = State::Storing;
    d->storing.await<void>(
        d->library.run<void>([measured](Library& library) { return library.addMeasuringChain(measured); }),
        [this, measured](const Expected<void>& done) {
            if (!done)
                return d->fail(done.error());
            if (d->connection.identity().serial == measured.gripperSerial)
                d->connection.setMeasuringChain(measured.forceLag_s, measured.chain);
            d->state = State::Stored;
        });
    return {};
}

bool LagSession::poll()
{
    const State before = d->state;
    const std::size_t known = d->squeezes.size();
    if (d->state == State::Squeezing)
        d->followSqueeze();
    else if (d->state == State::Judging)
        d->followJudging();
    d->storing.poll();
    return d->state != before || d->squeezes.size() != known;
}

LagSession::State LagSession::state() const
{
    return d->state;
}

double LagSession::progress() const
{
    if (d->wanted < 1)
        return 0;
    const double current = d->state == State::Squeezing ? d->job.progress()
                           : d->state == State::Judging ? 1
                                                        : 0;
    return std::min(1.0, (static_cast<double>(d->squeezes.size()) + current) / d->wanted);
}

const std::vector<LagEstimate>& LagSession::squeezes() const
{
    return d->squeezes;
}

const LagEstimate& LagSession::result() const
{
    return d->result;
}

std::optional<Error> LagSession::error() const
{
    return d->error;
}

LagEstimate estimateLag(const Recording& recording)
{
    const PreparedRecord record = prepare(recording);
    LagEstimationOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = record.hold.value_or(ForceHold::First);
    options.holdIsKnown = record.hold.has_value();
    options.expectedLag_s = record.forceLag_s;
    options.lost = record.lost;
    return estimateLag(record.force, record.position, options);
}

} // namespace gripscope
