// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/connect_session.h"

#include "core/base/words.h"
#include "core/session/connection/gripper_return.h"
#include "core/session/connection/identity_limits.h"

#include <map>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What may change without a person choosing another address.
bool mayPass(ErrorCode code)
{
    return code == ErrorCode::DeviceNotFound || code == ErrorCode::DevicePermission ||
           code == ErrorCode::DeviceLost || code == ErrorCode::DeviceTimeout;
}

} // namespace

struct ConnectSession::Private {
    explicit Private(GripperPortFactory& ports) : factory(ports) {}

    GripperPortFactory& factory;
    std::unique_ptr<GripperPort> port;
    std::unique_ptr<SafetyGate> gate;
    State state = State::Disconnected;
    std::optional<Error> error;
    QString address;
    GripperIdentity
        identity; // of the last gripper that answered, so that it can still be named once it is lost
    LinkCounters counters, earlierCounters; ///< the earlier: of the links before this one
    std::unique_ptr<GripperReturn> awaited; ///< while it is looked out for
    std::unique_ptr<GripperPort> returning; ///< there again, not open yet
    bool wasConnected = false;
    bool wasFruitless = false; ///< the last link opened, and no sample came
    int reconnections = 0;
    std::optional<double> measuredLag_s;
    MeasuringChain chain;
    ChannelCalibration calibration;
    std::map<int, SampleListener> listeners;
    int nextHandle = 1;
    std::vector<Sample> batch;
    bool ended = false;
    bool armed = false; // at the last poll
    StopState stopState = StopState::None;
    std::optional<Error> disarmReason;
    bool awaitsCalibrations = false, calibrationsTold = false; ///< the latter: since connectTo()
    std::optional<Error> calibrationsUnread;

    void drain();
    void follow(LinkState link);
    void lookOut();
    void followReturn();
    void takeOver();
    void forgetReturn();
    [[nodiscard]] Error lossReason() const;
};

void ConnectSession::Private::drain()
{
    batch.clear();
    port->drain(batch);
    counters = earlierCounters;
    counters += port->counters();
    if (batch.empty())
        return;
    calibration.correct(batch);
    // A listener may come or go while one is called: so by handle, looked up each time.
    std::vector<int> handles;
    for (const auto& entry : listeners)
        handles.push_back(entry.first);
    for (const int handle : handles) {
        const auto found = listeners.find(handle);
        if (found == listeners.end())
            continue;
        const SampleListener listener = found->second; // it may remove itself
        listener(batch);
    }
}

Error ConnectSession::Private::lossReason() const
{
    if (const std::optional<Error> reason = port->lastError())
        return *reason;
    return {ErrorCode::DeviceLost, {address, Words::tr("the link closed")}};
}

void ConnectSession::Private::follow(LinkState link)
{
    armed = link == LinkState::Armed;
    stopState = port->stopState();
    disarmReason = port->disarmReason();
    switch (link) {
    case LinkState::Opening:
        return;
    case LinkState::Ready:
    case LinkState::Armed:
        identity = port->identity();
        if (const std::optional<Finding> reason = outOfRange(identity)) {
            error = Error{ErrorCode::DeviceRefused, {Words::tr("say what it is"), *reason}};
            armed = false;
            port->stop();
            port->close();
            state = State::Disconnected;
            return;
        }
        wasConnected = true;
        state = State::Connected;
        return;
    case LinkState::Closed:
    case LinkState::Closing:
        error = lossReason();
        ended = true;
        state = State::Disconnected;
        return;
    case LinkState::Lost:
        error = lossReason();
        state = State::Lost;
        lookOut();
        return;
    }
}

void ConnectSession::Private::lookOut()
{
    if (!mayPass(error->code))
        return;
    const bool fruitless = port->counters().samples == 0;
    AwaitedGripper gripper{address, {}, reconnections + 1, !(fruitless && wasFruitless)};
    wasFruitless = fruitless;
    if (wasConnected)
        gripper.identity = identity;
    awaited = factory.awaitReturn(gripper);
}

void ConnectSession::Private::followReturn()
{
    if (!returning) {
        returning = awaited ? awaited->take() : nullptr;
        if (returning)
            returning->open();
        return;
    }
    switch (returning->state()) {
    case LinkState::Opening:
        return;
    case LinkState::Ready:
    case LinkState::Armed:
        if (const QString serial = returning->identity().serial; wasConnected && serial != identity.serial) {
            error = Error{ErrorCode::DeviceNotFound,
                          {identity.address,
                           Words::tr("Gripper %1 came in its place: choose it to work with it, or plug "
                                     "gripper %2 in.")
                               .arg(serial, identity.serial)}};
            returning.reset();
            return;
        }
        return takeOver();
    case LinkState::Closed:
    case LinkState::Closing:
    case LinkState::Lost:
        // What a person can do something about; else what was said of the loss still holds.
        if (const auto reason = returning->lastError(); reason && reason->code == ErrorCode::DevicePermission)
            error = reason;
        returning.reset();
        return;
    }
}

void ConnectSession::Private::takeOver()
{
    if (wasConnected)
        ++reconnections;
    earlierCounters = counters;
    gate.reset();
    port = std::move(returning);
    gate = std::make_unique<SafetyGate>(*port);
    forgetReturn();
    error.reset();
    follow(port->state());
}

void ConnectSession::Private::forgetReturn()
{
    awaited.reset();
    returning.reset();
}

ConnectSession::ConnectSession(GripperPortFactory& factory) : d(std::make_unique<Private>(factory)) {}

ConnectSession::~ConnectSession()
{
    disconnect();
}

Expected<void> ConnectSession::connectTo(const QString& address)
{
    // What is no address leaves the gripper that works, or is waited for, as it is.
    Expected<std::unique_ptr<GripperPort>> port = d->factory.create(address);
    if (!port && d->state != State::Disconnected)
        return tl::unexpected<Error>(port.error());
    disconnect();
    d->address = address;
    d->error.reset();
    if (!port) {
        d->error = port.error();
        return tl::unexpected<Error>(port.error());
    }
    d->port = std::move(*port);
    d->gate = std::make_unique<SafetyGate>(*d->port);
    d->identity = {};
    d->identity.address = address;
    d->counters = {};
    d->earlierCounters = {};
    d->reconnections = 0;
    d->wasConnected = false;
    d->wasFruitless = false;
    d->measuredLag_s.reset();
    d->chain = {};
    d->calibration.clear();
    d->calibrationsTold = false;
    d->calibrationsUnread.reset();
    d->stopState = StopState::None;
    d->state = State::Connecting;
    d->port->open();
    return {};
}

void ConnectSession::disconnect()
{
    d->forgetReturn();
    if (d->port) {
        if (d->port->state() == LinkState::Armed)
            d->port->stop();
        d->port->close();
        d->stopState = d->port->stopState(); // one that was not obeyed is told until the next connection
    }
    d->gate.reset();
    d->port.reset();
    d->ended = false;
    d->armed = false;
    d->disarmReason.reset();
    d->state = State::Disconnected;
}

void ConnectSession::poll()
{
    if (d->state == State::Lost)
        return d->followReturn();
    if (d->state != State::Connecting && d->state != State::Connected)
        return;
    d->port->confirmAlive();
    // The state first, the samples after it: what arrived before a loss is handed on before the loss is told.
    const LinkState link = d->port->state();
    // The first samples wait until the owner has seen that it is connected, and could ask for them.
    if (d->state == State::Connected)
        d->drain();
    if (d->port)
        d->follow(link);
}

ConnectSession::State ConnectSession::state() const
{
    return d->state;
}

bool ConnectSession::streamEnded() const
{
    return d->ended;
}

std::optional<Error> ConnectSession::lastError() const
{
    return d->error;
}

QString ConnectSession::address() const
{
    return d->address;
}

GripperIdentity ConnectSession::identity() const
{
    return d->identity;
}

LinkCounters ConnectSession::counters() const
{
    return d->counters;
}

bool ConnectSession::awaiting() const
{
    return d->state == State::Lost && d->awaited;
}

int ConnectSession::reconnections() const
{
    return d->reconnections;
}

bool ConnectSession::armed() const
{
    return d->armed;
}

GripperPort* ConnectSession::port()
{
    return d->state == State::Connected ? d->port.get() : nullptr;
}

SafetyGate* ConnectSession::gate()
{
    return d->state == State::Connected ? d->gate.get() : nullptr;
}

Expected<void> ConnectSession::arm(const QString& person)
{
    if (d->state != State::Connected)
        return failure(ErrorCode::DeviceRefused, {Words::tr("arm"), Words::tr("no gripper is connected")});
    if (d->stopState == StopState::NotObeyed)
        return failure(ErrorCode::StopNotObeyed, {});
    return d->gate->arm(person);
}

void ConnectSession::disarm()
{
    if (d->port)
        d->port->disarm();
}

void ConnectSession::stop() noexcept
{
    if (d->port)
        d->port->stop();
}

StopState ConnectSession::stopState() const
{
    return d->stopState;
}

std::optional<Error> ConnectSession::disarmReason() const
{
    return d->disarmReason;
}

void ConnectSession::setMeasuringChain(double forceLag_s, const MeasuringChain& chain)
{
    d->measuredLag_s = forceLag_s;
    d->chain = chain;
}

double ConnectSession::forceLag_s() const
{
    return d->measuredLag_s.value_or(d->identity.forceLag_s);
}

const MeasuringChain& ConnectSession::measuringChain() const
{
    return d->chain;
}

void ConnectSession::setCalibrations(const CalibrationsInForce& calibrations)
{
    d->calibration.put(calibrations, d->identity);
    d->calibrationsTold = true;
    d->calibrationsUnread.reset();
}

void ConnectSession::awaitCalibrations(bool on)
{
    d->awaitsCalibrations = on;
}

void ConnectSession::tellCalibrationsUnread(const Error& reason)
{
    if (!d->calibrationsTold)
        d->calibrationsUnread = reason;
}

Expected<void> ConnectSession::calibrationsTold() const
{
    if (!d->awaitsCalibrations || d->calibrationsTold)
        return {};
    if (d->calibrationsUnread)
        return failure(ErrorCode::Usage,
                       {Words::say("What the library knows of this gripper could not be read, so nothing is "
                                   "squeezed; it is asked again every 2 seconds. %1")
                            .arg(d->calibrationsUnread->describe())});
    return failure(ErrorCode::Usage, {Words::tr("The library is still being asked what is known of this "
                                                "gripper. Wait a moment, then squeeze again.")});
}

const ChannelCalibration& ConnectSession::calibration() const
{
    return d->calibration;
}

double ConnectSession::uncorrected(SensorChannel channel, double value) const
{
    return d->calibration.uncorrected(channel, value);
}

int ConnectSession::addListener(SampleListener listener)
{
    d->listeners.emplace(d->nextHandle, std::move(listener));
    return d->nextHandle++;
}

void ConnectSession::removeListener(int handle)
{
    d->listeners.erase(handle);
}

} // namespace gripscope
