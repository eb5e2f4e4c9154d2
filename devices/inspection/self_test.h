// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/connect_session.h"

#include <memory>
#include <vector>

namespace gripscope {

/// One question that the self-test asked.
struct SelfTestLine {
    enum class Outcome { Passed, Failed, NotTested };
    QString id;   ///< features, rate, sequence, clock, status, force_noise, position_noise, stop
    QString name; ///< "Rate"
    Outcome outcome = Outcome::NotTested;
    QString figure, limit;       ///< what was found, what is allowed
    std::optional<double> value; ///< of the figure, where it is one number
    QString advice;              ///< what to do; empty when passed
};
[[nodiscard]] QString toString(SelfTestLine::Outcome outcome);

/// Tests a gripper without moving it, over whatever connection there is: two seconds of listening, then a
/// stop, which also disarms it.
///
///     Idle -> Listening -> Stopping -> Done
///
/// Done with all lines, also when the gripper did not open or went away: then the first of them says so.
/// Driven by the owner's calls of ConnectSession::poll() followed by poll().
class SelfTest {
public:
    enum class State { Idle, Listening, Stopping, Done };
    static constexpr double seconds = 2;

    explicit SelfTest(ConnectSession& connection);
    ~SelfTest();
    SelfTest(const SelfTest&) = delete;
    SelfTest& operator=(const SelfTest&) = delete;

    /// A session that is still connecting is waited for. Usage: nothing is connected, or a squeeze runs.
    [[nodiscard]] Expected<void> start();
    void poll();

    [[nodiscard]] State state() const;
    [[nodiscard]] double progress() const; ///< 0 to 1
    [[nodiscard]] const std::vector<SelfTestLine>& lines() const;
    [[nodiscard]] bool passed() const; ///< Done, and nothing failed

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// What two seconds of listening gave.
struct SelfTestEvidence {
    GripperIdentity identity;
    LinkCounters before, after; ///< at the beginning and the end of it
    std::vector<Sample> samples;
    std::optional<double> stopAnswered_s; ///< nothing: no answer came
};

// Each a line with figure, limit and advice; pure functions.
[[nodiscard]] SelfTestLine featuresLine(const GripperIdentity& identity, const std::optional<Error>& error);
[[nodiscard]] SelfTestLine rateLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine sequenceLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine clockLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine statusLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine forceNoiseLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine positionNoiseLine(const SelfTestEvidence& evidence);
[[nodiscard]] SelfTestLine stopLine(const SelfTestEvidence& evidence);

} // namespace gripscope
