// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connect_session.h"
#include "core/signal/excitation.h"
#include "core/store/library.h"

#include <memory>
#include <optional>

namespace gripscope {

/// The excitation that a recipe means on a given device.
[[nodiscard]] ExcitationOptions excitationOptions(const Recipe& recipe, const GripperIdentity& identity,
                                                  std::uint64_t seed);

/// One squeeze: through the gate to the device, the samples back as a Recording with provenance.
///
///     Idle -> Starting -> Squeezing -> Done (recording()) | Failed (error())
///
/// Failed: refused by the gate or the device, stopped by a person, device lost, or no end within the excitation's
/// length plus two seconds. Driven by the owner's calls of ConnectSession::poll() followed by poll().
class SqueezeJob {
public:
    enum class State { Idle, Starting, Squeezing, Done, Failed };

    explicit SqueezeJob(ConnectSession& connection);
    ~SqueezeJob();
    SqueezeJob(const SqueezeJob&) = delete;
    SqueezeJob& operator=(const SqueezeJob&) = delete;

    [[nodiscard]] Expected<void> start(const Recipe& recipe, std::uint64_t seed);
    /// Only listens for `seconds` (devices that cannot be commanded).
    [[nodiscard]] Expected<void> listen(double seconds);
    void poll();
    void cancel();

    [[nodiscard]] State state() const;
    [[nodiscard]] double progress() const; ///< 0 to 1
    [[nodiscard]] const Recording& recording() const;
    [[nodiscard]] std::optional<Error> error() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
