// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/early_stop.h"
#include "core/session/pool_task.h"
#include "core/store/library.h"

#include <optional>

namespace gripscope {

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
    PoolTask<std::optional<EarlyTimes>> m_task;
    std::optional<EarlyTimes> m_times;
};

} // namespace gripscope
