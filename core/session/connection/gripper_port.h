// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/connection/safety_gate.h"
#include "core/signal/recording/recording.h"
#include "core/signal/recording/stream_account.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// What a gripper says of itself.
struct GripperIdentity {
    QString address, serial, name, firmware;
    int protocolMajor = 0, protocolMinor = 0;
    QString forceUnit = QStringLiteral("N");
    QString positionUnit = QStringLiteral("m");
    double sampleTime_s = 0.0005;
    ForceHold hold = ForceHold::Zero;
    double forceLag_s = 0;
    DeviceLimits limits;
    QString keptSession;      ///< the name under which its raw reports are kept; empty where they are not
    bool corrected = false;   ///< its samples are loads already: a recording that is played back
    bool commandable = false; ///< false: it only streams (a replay, a read-only gripper)
    bool lossVisible = true;  ///< false: it sends neither a number nor a clock; what gets lost is not seen
    QString port;             ///< where it is plugged in, in the system's words; empty: nowhere
};

/// One sample as the device sent it, in the units of its identity, and what befell the stream between the
/// sample before and this one. `time_s` counts from the device's own zero.
struct Sample {
    std::uint64_t sequence = 0;
    double time_s = 0;
    double force = 0;
    double position = 0;
    std::uint16_t status = 0;    ///< SampleStatus bits
    std::uint16_t stall_ms = 0;  ///< nothing came for so long, where that was a stall
    std::uint8_t duplicates = 0; ///< reports that came twice; 255: or more
    std::uint8_t badReports = 0; ///< reports with a wrong CRC, length or version; 255: or more
    bool clockStepped = false;   ///< the device's clock jumped against its sample count
};

enum class LinkState { Closed, Opening, Ready, Armed, Lost, Closing };
[[nodiscard]] QString toString(LinkState state);

/// Counted since the link was opened; nothing is lost without being counted.
struct LinkCounters {
    using TimePoint = std::chrono::steady_clock::time_point;

    std::uint64_t reports = 0;
    std::uint64_t samples = 0;
    std::uint64_t lostSamples = 0;  ///< missing by sequence number
    std::uint64_t sequenceGaps = 0; ///< places where they are missing
    std::optional<TimePoint> lastLoss;
    std::uint64_t duplicateReports = 0;
    std::uint64_t badReports = 0;     ///< wrong CRC, length or version
    std::uint64_t droppedSamples = 0; ///< the program did not keep up: its own queue was full

    std::uint64_t clockSteps = 0; ///< the device's clock jumped against its sample count
    ClockAccount clocks;          ///< the device's time against the computer's; of this link
    std::uint64_t stalls = 0;     ///< nothing came for a while, though the device was there
    double longestStall_s = 0;
    bool stalled = false; ///< now

    double reportRate_Hz = 0; ///< over the last second
    double sampleRate_Hz = 0;
    std::optional<TimePoint> newestArrival; ///< of the samples taken over last
    double latency_ms = 0;                  ///< from arrival until the newest sample was taken over, smoothed
    /// From arrival until each sample was taken over, in the last 10 s: half were quicker, 99 of 100 were.
    double latency50_ms = 0, latency99_ms = 0;

    std::uint64_t commandsSent = 0;     ///< without repeats and heartbeats
    std::uint64_t commandsRepeated = 0; ///< sent again, because no answer came
    std::uint64_t commandsAnswered = 0;
    std::uint64_t commandsRefused = 0;    ///< answered with another result than done
    std::uint64_t commandsUnanswered = 0; ///< given up
    std::uint64_t heartbeats = 0;

    /// What a later link of the same gripper counted is added; what is no count is the later one's.
    LinkCounters& operator+=(const LinkCounters& later);
};

/// What became of the last squeeze asked for.
enum class SqueezeState { Idle, Uploading, Running, Finished, Stopped, Refused };

/// What became of the last stop. Obeyed: the device said that it is no longer armed, and its force fell below
/// a tenth of what it was. NotObeyed is final for the connection: nothing that it says later is believed.
enum class StopState { None, Waiting, Obeyed, NotObeyed };

class ReportLog;

/// A gripper as the sessions see it. Every call returns at once; the work is done by threads behind it.
/// Belongs to one thread at a time, but for stop(), which any thread may call at any moment.
class GripperPort {
public:
    virtual ~GripperPort() = default;

    /// Starts opening; state() goes Opening -> Ready, or Lost with lastError().
    virtual void open() = 0;
    /// Bounded: comes back within a second, whatever the device does.
    virtual void close() = 0;
    [[nodiscard]] virtual LinkState state() const = 0;
    [[nodiscard]] virtual std::optional<Error> lastError() const = 0;
    [[nodiscard]] virtual GripperIdentity identity() const = 0; ///< meaningful from Ready on
    [[nodiscard]] virtual LinkCounters counters() const = 0;

    /// Takes over what has arrived since the last call, at most `most` samples, and appends it.
    virtual std::size_t drain(std::vector<Sample>& samples, std::size_t most = 65536) = 0;

    /// Asked for by a person, through the SafetyGate only.
    virtual void arm(const ArmingOrder& order) = 0;
    virtual void disarm() = 0;
    /// Uploads the whole force signal, waits for the acknowledgement, then starts it.
    virtual void startExcitation(const AdmittedExcitation& excitation) = 0;
    /// Ends the squeeze that runs as if it were over: force off, still armed, Finished. A device that cannot
    /// goes on to the squeeze's own end.
    virtual void finishExcitation() = 0;
    [[nodiscard]] virtual SqueezeState squeezeState() const = 0;
    /// Handed to the device before anything else that is queued.
    virtual void stop() noexcept = 0;
    [[nodiscard]] virtual StopState stopState() const { return StopState::None; }
    /// Why an armed gripper is armed no longer though nobody asked for it, or why it was not armed though
    /// somebody did; until the next arm().
    [[nodiscard]] virtual std::optional<Error> disarmReason() const { return {}; }
    /// The screen (or the command line's loop) is alive: to be called at least once a second while armed, or
    /// the heartbeat ends and the gripper stops by itself.
    virtual void confirmAlive() noexcept = 0;
    /// What is done with the samples (a squeeze begins, ended), for whoever keeps the raw reports. Lines of
    /// text, the first of which says what it is.
    virtual void note(const QString&) {}
    /// The last reports as they passed; nothing where there are none, as in a recording that is played.
    [[nodiscard]] virtual const ReportLog* reportLog() const { return nullptr; }
};

class GripperReturn;
struct AwaitedGripper;

/// Makes ports from addresses; devices/ implements it, so that sessions need not know how.
class GripperPortFactory {
public:
    virtual ~GripperPortFactory() = default;
    [[nodiscard]] virtual Expected<std::unique_ptr<GripperPort>> create(const QString& address) = 0;
    /// Looks out for a gripper that went away or has not come yet; null where none can come (a replay).
    [[nodiscard]] virtual std::unique_ptr<GripperReturn> awaitReturn(const AwaitedGripper& awaited);
};

} // namespace gripscope
