// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/recognition/early/early_stop.h"
#include "core/session/connection/gripper_port.h"
#include "core/session/tasks/pool.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// Follows one squeeze after another in the thread pool, to say when it may end early. Its owner hands over
/// the samples and polls; neither waits for anything. A pool that is busy or a test that takes long only
/// makes the decision later: samples that came meanwhile are looked at together.
///
/// Only samples of the movement count. Those that were lost or at a channel's limit are told to the test as
/// lost. The last tenth of a squeeze is not looked at: to end it would save nothing, and the processors are
/// wanted for the verdict.
class EarlyWatch {
public:
    /// A new squeeze of so many samples; what was known of the last one is forgotten.
    void begin(EarlyStopSetup setup, std::size_t samples);
    /// No squeeze is followed any more.
    void end();
    void take(const std::vector<Sample>& batch);
    void poll();

    /// Samples are being looked at.
    [[nodiscard]] bool busy() const { return m_task.waiting(); }
    /// Why the squeeze may end, from the moment this is known until the next begin().
    [[nodiscard]] const std::optional<EarlyEnd>& decision() const { return m_decision; }

private:
    struct Pair {
        double force, position; ///< not a number where nothing was measured
    };
    struct Followed;
    void take(const Sample& sample);

    std::shared_ptr<Followed> m_followed; ///< shared with the task that runs, if any
    Pending<std::optional<EarlyEnd>> m_task;
    std::vector<Pair> m_waiting;
    std::optional<std::uint64_t> m_lastSequence;
    std::size_t m_taken = 0, m_worthLooking = 0; ///< samples of this squeeze; up to where looks are of use
    std::optional<EarlyEnd> m_decision;
};

/// How long the next squeeze will take: expectedTimes(), worked out in the thread pool and kept until
/// something it depends on changes.
class SqueezeForecast {
public:
    /// What is to be squeezed next. Asking again for the same costs nothing. The force is the recipe's on a
    /// gripper of the setup's sample time.
    void ask(const EarlyStopSetup& setup, const Recipe& recipe);
    void forget();
    bool poll(); ///< true when an answer came
    /// Nothing while it is worked out, and where nothing is known.
    [[nodiscard]] const std::optional<EarlyTimes>& times() const { return m_times; }

private:
    struct Question {
        EarlyStopSetup setup;
        Recipe recipe;
        friend bool operator==(const Question&, const Question&) = default;
    };
    std::optional<Question> m_question;
    Pending<std::optional<EarlyTimes>> m_task;
    std::optional<EarlyTimes> m_times;
};

} // namespace gripscope
