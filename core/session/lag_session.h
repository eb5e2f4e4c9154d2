// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lag_estimation.h"
#include "core/session/squeeze_job.h"
#include "core/store/library_service.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// Measures how much later a gripper's position channel samples than its force channel, on some squeezes of
/// one firm object, and keeps it in the library as a property of that gripper.
///
///     Idle -> Squeezing <-> Judging -> Measured -> Storing -> Stored
///       any of them -> Failed (error()), from which start() begins again
///
/// Measured holds result(); accept() stores it and puts it in force for the squeezes to come. What else is
/// known of the gripper's channels stays as it is.
class LagSession {
public:
    enum class State { Idle, Squeezing, Judging, Measured, Storing, Stored, Failed };
    static constexpr int usualSqueezes = 5;

    LagSession(ConnectSession& connection, LibraryService& library);
    ~LagSession();
    LagSession(const LagSession&) = delete;
    LagSession& operator=(const LagSession&) = delete;

    void setOperator(const QString& name);
    [[nodiscard]] Expected<void> start(const Recipe& recipe, int squeezes = usualSqueezes);
    void cancel(); ///< stops the gripper, too
    /// Usage: nothing was measured, or not well enough to be used.
    [[nodiscard]] Expected<void> accept();
    bool poll(); ///< never waits; true when something changed

    [[nodiscard]] State state() const;
    [[nodiscard]] double progress() const; ///< of all squeezes, 0 to 1
    [[nodiscard]] const std::vector<LagEstimate>& squeezes() const;
    [[nodiscard]] const LagEstimate& result() const;
    [[nodiscard]] std::optional<Error> error() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// The lag of one squeeze, prepared as identify() would.
[[nodiscard]] LagEstimate estimateLag(const Recording& recording);

} // namespace gripscope
