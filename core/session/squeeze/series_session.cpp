// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/series_session.h"

#include "core/base/words.h"

#include <algorithm>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

struct SeriesSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), library(service), job(session)
    {
    }

    ConnectSession& connection;
    LibraryService& library;
    SqueezeJob job;
    PendingCall storing;
    Recipe recipe;
    QString operatorName, serial, reason;
    int wanted = 0, judged = 0;
    State state = State::Idle;
    std::optional<Error> error;
};

SeriesSession::SeriesSession(ConnectSession& connection, LibraryService& library)
    : d(std::make_unique<Private>(connection, library))
{
}

SeriesSession::~SeriesSession() = default;

void SeriesSession::setOperator(const QString& name)
{
    d->operatorName = name;
    d->job.setOperator(name);
}

void SeriesSession::setReason(const QString& why)
{
    d->reason = why;
}

Expected<void> SeriesSession::begin(const Recipe& recipe, int squeezes)
{
    if (busy())
        return failure(ErrorCode::Usage,
                       {Words::tr("Squeezes are under way. Wait for their end or stop them.")});
    d->recipe = recipe;
    d->wanted = squeezes;
    d->judged = 0;
    d->error.reset();
    d->serial = d->connection.identity().serial;
    clear();
    return squeeze();
}

Expected<void> SeriesSession::squeeze()
{
    // Each with a seed of its own: what depended on one sequence would show as scatter.
    const Expected<void> started = d->job.start(d->recipe, static_cast<std::uint64_t>(d->judged) + 1);
    if (started)
        d->state = State::Squeezing;
    return started;
}

void SeriesSession::cancel()
{
    d->job.cancel();
    forgetJudging();
    if (d->state == State::Squeezing || d->state == State::Judging)
        fail({ErrorCode::Cancelled, {Words::tr("The measurement")}});
}

void SeriesSession::fail(const Error& reason)
{
    d->error = reason;
    d->state = State::Failed;
}

Expected<void> SeriesSession::storeChain(const NewMeasuringChain& measured)
{
    if (measured.gripperSerial != d->connection.identity().serial)
        return failure(
            ErrorCode::Usage,
            {Words::tr("Another gripper is connected than the one that was measured. Connect gripper %1, "
                       "then try again.")
                 .arg(measured.gripperSerial)});
    NewMeasuringChain told = measured;
    told.reason = std::exchange(d->reason, {});
    store<NewMeasuringChain>(
        [told](Library& library) { return library.addMeasuringChain(told).map([&] { return told; }); },
        [this](const NewMeasuringChain& kept) {
            if (d->connection.identity().serial == kept.gripperSerial)
                d->connection.setMeasuringChain(kept.forceLag_s, kept.chain);
        });
    return {};
}

void SeriesSession::followSqueeze()
{
    d->job.poll();
    if (d->job.state() == SqueezeJob::State::Failed)
        return fail(*d->job.error());
    if (d->job.state() != SqueezeJob::State::Done)
        return;
    d->state = State::Judging;
    judge(d->job.recording());
}

void SeriesSession::followJudging()
{
    if (!takeJudged())
        return;
    if (++d->judged < d->wanted) {
        if (const Expected<void> next = squeeze(); !next)
            fail(next.error());
        return;
    }
    d->state = State::Measured;
    conclude();
}

bool SeriesSession::poll()
{
    const State before = d->state;
    const int known = d->judged;
    if (d->state == State::Squeezing)
        followSqueeze();
    else if (d->state == State::Judging)
        followJudging();
    d->storing.poll();
    return d->state != before || d->judged != known;
}

SeriesSession::State SeriesSession::state() const
{
    return d->state;
}

bool SeriesSession::busy() const
{
    return d->state == State::Squeezing || d->state == State::Judging || d->state == State::Storing;
}

double SeriesSession::progress() const
{
    if (d->wanted < 1)
        return 0;
    const double current = d->state == State::Squeezing ? d->job.progress()
                           : d->state == State::Judging ? 1
                                                        : 0;
    return std::min(1.0, (d->judged + current) / d->wanted);
}

std::optional<Error> SeriesSession::error() const
{
    return d->error;
}

ConnectSession& SeriesSession::connection() const
{
    return d->connection;
}

LibraryService& SeriesSession::library() const
{
    return d->library;
}

PendingCall& SeriesSession::storing()
{
    return d->storing;
}

QString SeriesSession::serial() const
{
    return d->serial;
}

QString SeriesSession::operatorName() const
{
    return d->operatorName;
}

void SeriesSession::setState(State state)
{
    d->state = state;
}

} // namespace gripscope
