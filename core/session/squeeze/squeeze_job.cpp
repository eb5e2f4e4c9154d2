// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_job.h"

#include "core/base/words.h"
#include "core/session/connection/described_recording.h"
#include "core/session/connection/limit_watch.h"
#include "core/session/connection/stop_words.h"
#include "core/session/squeeze/squeeze_notes.h"
#include "core/session/squeeze/squeeze_recorder.h"
#include "core/signal/recording/recording_limits.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Longer than the device's start and the way of the last samples take, short enough for a person to wait.
constexpr double graceSeconds = 2.0;
/// A device that sends nothing for so long after its squeeze has nothing more to send: a hundred reports at
/// least.
constexpr double silenceSeconds = 0.25;

QString settingText(double value)
{
    return QString::number(value, 'g', 12);
}

} // namespace

ExcitationOptions excitationOptions(const Recipe& recipe, const GripperIdentity& identity, std::uint64_t seed)
{
    ExcitationOptions options;
    options.kind = recipe.kind;
    options.peak = recipe.peak_N;
    options.bias = recipe.bias_N;
    options.bit_s = recipe.bit_s;
    options.levels = recipe.levels;
    options.sampleTime_s = identity.sampleTime_s;
    options.samples = samplesIn(recipe.seconds, identity.sampleTime_s);
    options.seed = seed;
    options.oneSided = true;
    return options;
}

std::optional<Error> forceProblem(const Recipe& recipe, const GripperIdentity& identity)
{
    const ExcitationOptions options = excitationOptions(recipe, identity, 1);
    if (options.kind == ExcitationKind::InverseRepeat && !excitationPeriod(options)) {
        constexpr double pushes =
            8 * 14; // of the shortest sequence, in as many periods as `periodic` asks for
        return Error{
            ErrorCode::Usage,
            {Words::tr("A repeating force takes eight periods of 14 pushes: choose a length of at "
                       "least %1 s, or a shorter push.")
                 .arg(Words::number(pushes * std::max(recipe.bit_s, identity.sampleTime_s), 'g', 3))}};
    }
    constexpr double mostWork = 2e7; // tones times samples: made within the time of a click
    if (options.kind == ExcitationKind::Multisine &&
        recipe.seconds / (2 * recipe.bit_s) * static_cast<double>(options.samples) > mostWork)
        return Error{
            ErrorCode::Usage,
            {Words::tr("A sum of sines as long as this has too many tones: choose a longer shortest push, "
                       "or a shorter squeeze.")}};
    return options.validate();
}

struct SqueezeJob::Private {
    explicit Private(ConnectSession& session) : connection(session) {}

    ConnectSession& connection;
    Clock clock = [] { return std::chrono::steady_clock::now(); };
    QString operatorName;
    State state = State::Idle;
    std::optional<Error> error;
    SqueezeRecorder recorder;
    LimitWatch watch;
    Recording recording;
    int listener = 0;
    bool listening = false;
    std::optional<QString> finishing; // why the squeeze may end before its time
    bool endedEarly = false;
    std::uint64_t badReportsBefore = 0;
    int link = 0; // how often the gripper had come back when the squeeze began
    double seconds = 0;
    std::chrono::steady_clock::time_point started, lastNews;

    [[nodiscard]] Expected<void> ready() const;
    void begin(std::size_t samples, QMap<QString, QString> provenance);
    void end(State outcome);
    void fail(Error reason);
    void followListening(double waited_s);
    void followSqueeze(double waited_s);
    void followStop(const GripperPort& port);
    [[nodiscard]] std::optional<Error> deviceReason(const GripperPort& port) const;
    [[nodiscard]] Error noEnd(const GripperPort& port) const;
    void finishSqueeze();
    [[nodiscard]] bool running() const { return state == State::Starting || state == State::Squeezing; }
    [[nodiscard]] double secondsSince(std::chrono::steady_clock::time_point t) const
    {
        return std::chrono::duration<double>(clock() - t).count();
    }
};

Expected<void> SqueezeJob::Private::ready() const
{
    if (running())
        return failure(ErrorCode::Usage, {Words::tr("A squeeze is under way. Wait for its end or stop it.")});
    if (connection.state() != ConnectSession::State::Connected)
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("squeeze"), Words::tr("no gripper is connected")});
    return connection.calibrationsTold(); // what is recorded uncorrected stays so
}

void SqueezeJob::Private::begin(std::size_t samples, QMap<QString, QString> provenance)
{
    recording = describedRecording(connection, operatorName, std::move(provenance));
    const auto mode = listening ? SqueezeRecorder::Mode::Everything : SqueezeRecorder::Mode::Movement;
    recorder.begin(mode, samples, recording.sampleTime_s);
    connection.port()->note(toNote(SqueezeBegins{mode, samples, {}}));
    error.reset();
    finishing.reset();
    endedEarly = false;
    badReportsBefore = connection.counters().badReports;
    link = connection.reconnections();
    state = State::Starting;
    seconds = static_cast<double>(samples) * recording.sampleTime_s;
    started = lastNews = clock();
    listener = connection.addListener([this](const std::vector<Sample>& batch) {
        recorder.take(batch);
        watch.take(batch);
        lastNews = clock();
    });
}

void SqueezeJob::Private::end(State outcome)
{
    connection.removeListener(listener);
    listener = 0;
    recorder.moveTo(recording, connection.counters().clocks);
    state = outcome;
    if (GripperPort* port = connection.port())
        port->note(
            toNote(SqueezeEnded{outcome == State::Failed ? std::optional(error->describe()) : std::nullopt,
                                recording.size(), slice(recording, {})}));
}

void SqueezeJob::Private::fail(Error reason)
{
    error = std::move(reason);
    end(State::Failed);
}

void SqueezeJob::Private::followListening(double waited_s)
{
    if (recorder.complete())
        return end(State::Done);
    if (waited_s > seconds + graceSeconds && recorder.size() == 0)
        return fail(
            {ErrorCode::DeviceTimeout, {Words::tr("send anything"), settingText(seconds + graceSeconds)}});
    if (recorder.size() > 0 && secondsSince(lastNews) > graceSeconds)
        end(State::Done);
}

/// What the device itself says of why the squeeze is over: the bits of its samples, then what the link knows.
std::optional<Error> SqueezeJob::Private::deviceReason(const GripperPort& port) const
{
    if (const QString reason = ownReason(recorder.statusSeen()); !reason.isEmpty())
        return Error{ErrorCode::DeviceRefused, {Words::tr("go on with the squeeze"), reason}};
    if (const std::optional<Error> reason = port.disarmReason())
        return reason;
    return port.lastError();
}

void SqueezeJob::Private::followStop(const GripperPort& port)
{
    if (port.state() == LinkState::Lost)
        return; // the connection says so at its next poll, with the reason
    fail(deviceReason(port).value_or(Error{ErrorCode::Cancelled, {Words::tr("The squeeze")}}));
}

/// No end came in time; a cable is to blame only where the device gave no other reason.
Error SqueezeJob::Private::noEnd(const GripperPort& port) const
{
    if (const std::optional<Error> reason = deviceReason(port))
        return *reason;
    const std::uint64_t bad = connection.counters().badReports;
    if (!recorder.moved() && bad > badReportsBefore)
        return {ErrorCode::DeviceRefused,
                {Words::tr("finish the squeeze"),
                 Words::tr("%1 of its reports since then could not be read, and no "
                           "other told of a movement")
                     .arg(bad - badReportsBefore)}};
    return {ErrorCode::DeviceTimeout, {Words::tr("finish the squeeze"), settingText(seconds + graceSeconds)}};
}

void SqueezeJob::Private::finishSqueeze()
{
    // A report or two may be lost at the end; a tenth of the squeeze is more than that.
    const bool whole = recorder.movingSeconds() > 0.9 * seconds;
    endedEarly = finishing && !whole;
    if (endedEarly)
        recording.provenance[u"ended_early"_qs] = *finishing;
    if (whole || endedEarly)
        return end(State::Done);
    const GripperPort* port = connection.port();
    const std::optional<Error> reason = port ? deviceReason(*port) : std::nullopt;
    fail(reason.value_or(
        Error{ErrorCode::DeviceRefused,
              {Words::tr("go on with the squeeze"), Words::tr("it ended early, without a reason")}}));
}

void SqueezeJob::Private::followSqueeze(double waited_s)
{
    if (connection.stopState() == StopState::NotObeyed)
        return fail({ErrorCode::StopNotObeyed, {}}); // whatever it measured is no squeeze
    if (watch.exceeded()) {
        connection.stop();
        return fail(*watch.exceeded());
    }
    const GripperPort& port = *connection.port();
    switch (port.squeezeState()) {
    case SqueezeState::Refused:
        return fail(port.lastError().value_or(
            Error{ErrorCode::DeviceRefused, {Words::tr("squeeze"), Words::tr("it gave no reason")}}));
    case SqueezeState::Stopped:
        return followStop(port);
    case SqueezeState::Running:
        state = State::Squeezing;
        break;
    case SqueezeState::Idle:
    case SqueezeState::Uploading:
    case SqueezeState::Finished:
        break;
    }
    if (recorder.moved())
        state = State::Squeezing;
    const bool silent = recorder.moved() && secondsSince(lastNews) > silenceSeconds;
    if (recorder.complete() || (silent && port.squeezeState() == SqueezeState::Finished))
        return finishSqueeze();
    if (waited_s > seconds + graceSeconds) {
        const Error why = noEnd(port); // before the stop, which has an outcome of its own
        connection.stop();
        fail(why);
    }
}

SqueezeJob::SqueezeJob(ConnectSession& connection) : d(std::make_unique<Private>(connection)) {}

SqueezeJob::~SqueezeJob()
{
    cancel();
}

void SqueezeJob::setOperator(const QString& name)
{
    d->operatorName = name;
}

void SqueezeJob::setClock(Clock clock)
{
    d->clock = std::move(clock);
}

Expected<void> SqueezeJob::start(const Recipe& recipe, std::uint64_t seed)
{
    RETURN_IF_ERROR(forceProblem(recipe, d->connection.identity()));
    return start(excitationOptions(recipe, d->connection.identity(), seed),
                 {recipe.maxForce_N, recipe.maxTravel_m});
}

Expected<void> SqueezeJob::start(ExcitationOptions excitation, const JobLimits& limits)
{
    RETURN_IF_ERROR(d->ready());
    excitation.sampleTime_s = d->connection.identity().sampleTime_s;
    ASSIGN_OR_RETURN(const std::vector<double> force_N, makeExcitation(excitation));
    SafetyGate& gate = *d->connection.gate();
    gate.setJobLimits(limits);
    RETURN_IF_ERROR(gate.start(force_N));
    d->listening = false;
    d->watch = LimitWatch(gate.effectiveLimits(), d->connection.identity());
    QMap<QString, QString> facts{{u"excitation"_qs, toString(excitation.kind)},
                                 {u"excitation_peak_N"_qs, settingText(excitation.peak)},
                                 {u"excitation_bias_N"_qs, settingText(excitation.bias)},
                                 {u"excitation_bit_s"_qs, settingText(excitation.bit_s)},
                                 {u"excitation_seed"_qs, QString::number(excitation.seed)}};
    if (const std::optional<std::size_t> period = excitationPeriod(excitation))
        facts.insert(u"excitation_period_samples"_qs, QString::number(*period));
    d->begin(force_N.size(), std::move(facts));
    return {};
}

Expected<void> SqueezeJob::listen(double seconds)
{
    RETURN_IF_ERROR(d->ready());
    const std::size_t samples = samplesIn(seconds, d->connection.identity().sampleTime_s);
    if (samples == 0 || !(seconds > 0))
        return failure(ErrorCode::Usage, {Words::tr("Listening needs a time above zero.")});
    if (samples > mostSamples)
        return failure(
            ErrorCode::LimitExceeded,
            {Words::tr("A recording"), settingText(seconds) + u" s"_qs,
             settingText(static_cast<double>(mostSamples) * d->connection.identity().sampleTime_s) + u" s"_qs,
             Words::tr("what a recording can hold")});
    d->listening = true;
    d->watch = {}; // nothing is moved that could be stopped
    d->begin(samples, {{u"excitation"_qs, u"none, listened only"_qs}});
    return {};
}

void SqueezeJob::poll()
{
    if (!d->running())
        return;
    if (d->connection.state() != ConnectSession::State::Connected) {
        // All that a replay had to say is what there was to hear.
        if (d->listening && d->connection.streamEnded() && d->recorder.size() > 0)
            return d->end(State::Done);
        return d->fail(d->connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {d->connection.address(), Words::tr("it was disconnected")}}));
    }
    if (d->connection.reconnections() != d->link) // gone and back between two looks
        return d->fail(
            {ErrorCode::DeviceLost, {d->connection.address(), Words::tr("it went away during the squeeze")}});
    const double waited_s = d->secondsSince(d->started);
    if (d->listening) {
        d->state = d->recorder.size() > 0 ? State::Squeezing : State::Starting;
        d->followListening(waited_s);
    } else {
        d->followSqueeze(waited_s);
    }
}

void SqueezeJob::finish(const QString& reason)
{
    if (d->state != State::Squeezing || d->listening || d->finishing)
        return;
    SafetyGate* gate = d->connection.gate();
    if (!gate)
        return;
    d->finishing = reason;
    gate->finish();
}

void SqueezeJob::note(const QString& text)
{
    if (GripperPort* port = d->connection.port())
        port->note(text);
}

void SqueezeJob::cancel()
{
    if (!d->running())
        return;
    if (!d->listening)
        d->connection.stop();
    d->fail({ErrorCode::Cancelled, {Words::tr("The squeeze")}});
}

SqueezeJob::State SqueezeJob::state() const
{
    return d->state;
}

double SqueezeJob::progress() const
{
    if (d->state == State::Done)
        return 1;
    return d->running() ? d->recorder.progress() : 0;
}

bool SqueezeJob::endedEarly() const
{
    return d->endedEarly;
}

const Recording& SqueezeJob::recording() const
{
    return d->recording;
}

std::optional<Error> SqueezeJob::error() const
{
    return d->error;
}

} // namespace gripscope
