// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/inspection/self_test.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;
using Steady = std::chrono::steady_clock;

namespace {
constexpr double stopWait_s = 1;

double secondsSince(Steady::time_point t)
{
    return std::chrono::duration<double>(Steady::now() - t).count();
}
} // namespace

QString toString(SelfTestLine::Outcome outcome)
{
    switch (outcome) {
    case SelfTestLine::Outcome::Passed:
        return u"passed"_qs;
    case SelfTestLine::Outcome::Failed:
        return u"failed"_qs;
    case SelfTestLine::Outcome::NotTested:
        return Words::tr("not tested");
    }
    return {};
}

struct SelfTest::Private {
    explicit Private(ConnectSession& session) : connection(session) {}

    ConnectSession& connection;
    State state = State::Idle;
    std::vector<SelfTestLine> lines;
    SelfTestEvidence evidence;
    int listener = 0;
    std::optional<Steady::time_point> began, stopped;
    std::uint64_t answeredBefore = 0;

    void beginListening();
    void endListening();
    void finish(const std::optional<Error>& error);
    [[nodiscard]] bool listened() const { return began && secondsSince(*began) >= seconds; }
};

void SelfTest::Private::beginListening()
{
    const LinkCounters counters = connection.counters();
    // From a first sample on, so that the rate is timed between two arrivals.
    if (!counters.newestArrival && !(began && secondsSince(*began) >= seconds)) {
        began = began.value_or(Steady::now());
        return;
    }
    evidence.before = counters;
    evidence.samples.reserve(static_cast<std::size_t>(
        std::clamp(2 * seconds / connection.identity().sampleTime_s, 1.0, 100000.0)));
    listener = connection.addListener([this](const std::vector<Sample>& batch) {
        evidence.samples.insert(evidence.samples.end(), batch.begin(), batch.end());
    });
    began = Steady::now();
}

void SelfTest::Private::endListening()
{
    evidence.after = connection.counters();
    connection.removeListener(listener);
    listener = 0;
    answeredBefore = evidence.after.commandsAnswered;
    stopped = Steady::now();
    state = State::Stopping;
    if (evidence.identity.commandable)
        connection.stop();
}

void SelfTest::Private::finish(const std::optional<Error>& error)
{
    if (listener != 0)
        connection.removeListener(listener);
    listener = 0;
    state = State::Done;
    lines = {featuresLine(evidence.identity, error)};
    if (error)
        return;
    for (auto* make :
         {rateLine, sequenceLine, clockLine, statusLine, forceNoiseLine, positionNoiseLine, stopLine})
        lines.push_back(make(evidence));
}

SelfTest::SelfTest(ConnectSession& connection) : d(std::make_unique<Private>(connection)) {}

SelfTest::~SelfTest()
{
    if (d->listener != 0)
        d->connection.removeListener(d->listener);
}

Expected<void> SelfTest::start()
{
    if (d->state == State::Listening || d->state == State::Stopping)
        return failure(ErrorCode::Usage, {Words::tr("The self-test is under way. Wait for its end.")});
    const ConnectSession::State link = d->connection.state();
    if (link != ConnectSession::State::Connected && link != ConnectSession::State::Connecting)
        return failure(ErrorCode::Usage, {Words::tr("No gripper is connected. Connect one, then test it.")});
    const GripperPort* port = d->connection.port();
    const SqueezeState squeeze = port ? port->squeezeState() : SqueezeState::Idle;
    if (squeeze == SqueezeState::Uploading || squeeze == SqueezeState::Running)
        return failure(ErrorCode::Usage, {Words::tr("A squeeze is under way. Wait for its end or stop it.")});
    d->lines.clear();
    d->evidence = {};
    d->began.reset();
    d->state = State::Listening;
    return {};
}

void SelfTest::poll()
{
    if (d->state != State::Listening && d->state != State::Stopping)
        return;
    switch (d->connection.state()) {
    case ConnectSession::State::Connecting:
        return;
    case ConnectSession::State::Connected:
        break;
    case ConnectSession::State::Disconnected:
    case ConnectSession::State::Lost:
        return d->finish(d->connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {d->connection.address(), Words::tr("it was disconnected")}}));
    }
    d->evidence.identity = d->connection.identity();
    if (d->state == State::Listening) {
        if (d->listener == 0)
            d->beginListening();
        else if (d->listened())
            d->endListening();
        return;
    }
    const bool answered = d->connection.counters().commandsAnswered > d->answeredBefore;
    if (answered)
        d->evidence.stopAnswered_s = secondsSince(*d->stopped);
    if (answered || !d->evidence.identity.commandable || secondsSince(*d->stopped) > stopWait_s)
        d->finish({});
}

SelfTest::State SelfTest::state() const
{
    return d->state;
}

double SelfTest::progress() const
{
    if (d->state == State::Stopping || d->state == State::Done)
        return 1;
    return d->listener != 0 ? std::min(1.0, secondsSince(*d->began) / seconds) : 0;
}

const std::vector<SelfTestLine>& SelfTest::lines() const
{
    return d->lines;
}

bool SelfTest::passed() const
{
    return d->state == State::Done &&
           std::none_of(d->lines.begin(), d->lines.end(), [](const SelfTestLine& line) {
               return line.outcome == SelfTestLine::Outcome::Failed;
           });
}

} // namespace gripscope
