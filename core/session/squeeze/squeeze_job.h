// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/session/connection/connect_session.h"
#include "core/signal/excitation/excitation.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace gripscope {

/// The excitation that a recipe means on a given device, in newtons.
[[nodiscard]] ExcitationOptions excitationOptions(const Recipe& recipe, const GripperIdentity& identity,
                                                  std::uint64_t seed);
/// Why that gripper cannot squeeze by it, in the words of a recipe; nothing where it can, within the limits
/// that the gate holds.
[[nodiscard]] std::optional<Error> forceProblem(const Recipe& recipe, const GripperIdentity& identity);

/// One squeeze: through the gate to the device, the samples back as a Recording with provenance.
///
///     Idle -> Starting -> Squeezing -> Done (recording()) | Failed (error())
///
/// Failed: refused by the gate or the device, stopped by a person, device lost, or no end within the
/// excitation's length plus two seconds. Driven by the owner's calls of ConnectSession::poll() followed by
/// poll().
///
/// The recording goes from 20 ms before the device reports that it moves to 20 ms after it stopped to; it has
/// the sample time, hold and units of the device's identity, what is known of its channels (lag, chain),
/// every sample's sequence number and status, and in its provenance: device, serial, address, firmware,
/// excitation (kind, peak, bias, bit, seed), operator, UTC time and what befell the stream (StreamAccount).
class SqueezeJob {
public:
    enum class State { Idle, Starting, Squeezing, Done, Failed };
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    explicit SqueezeJob(ConnectSession& connection);
    ~SqueezeJob();
    SqueezeJob(const SqueezeJob&) = delete;
    SqueezeJob& operator=(const SqueezeJob&) = delete;

    void setOperator(const QString& name);
    void setClock(Clock clock); ///< for the time limit; the steady clock unless a test sets another

    [[nodiscard]] Expected<void> start(const Recipe& recipe, std::uint64_t seed);
    /// Any force signal, peak and bias in newtons; the sample time is the device's.
    [[nodiscard]] Expected<void> start(ExcitationOptions excitation, const JobLimits& limits);
    /// Only listens for `seconds` (devices that cannot be commanded). When the device falls silent after it
    /// has sent something, what came until then is the recording.
    [[nodiscard]] Expected<void> listen(double seconds);
    void poll();
    /// Enough is known: the force goes off, the gripper stays armed, and what was measured is the recording,
    /// with `reason` as its provenance "ended_early". A device that cannot goes on to the squeeze's end.
    /// Nothing while nothing is squeezed, and for one that only listens.
    void finish(const QString& reason);
    void cancel(); ///< stops the gripper, too, unless it only listens
    /// Beside the raw reports, where they are kept.
    void note(const QString& text);

    [[nodiscard]] State state() const;
    [[nodiscard]] double progress() const; ///< 0 to 1
    /// The recording is shorter than the excitation that was asked for, because of finish().
    [[nodiscard]] bool endedEarly() const;
    [[nodiscard]] const Recording& recording() const;
    [[nodiscard]] std::optional<Error> error() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
