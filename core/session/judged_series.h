// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/pool_task.h"
#include "core/session/series_session.h"

#include <vector>

namespace gripscope {

/// A series in which each squeeze is judged by itself, in the pool: a `Judgement` for each, kept in order.
template <typename Judgement>
class JudgedSeries : public SeriesSession {
public:
    [[nodiscard]] const std::vector<Judgement>& squeezes() const { return m_squeezes; }

protected:
    using SeriesSession::SeriesSession;
    /// Of one squeeze; in the pool, so that it reads nothing but the recording.
    using Judge = Judgement (*)(const Recording&);

    void judgeBy(Judge how, Recording recording)
    {
        m_task.start([how, recording = std::move(recording)] { return how(recording); });
    }
    void clear() override { m_squeezes.clear(); }

private:
    bool takeJudged() final
    {
        std::optional<Judgement> found = m_task.take();
        if (found)
            m_squeezes.push_back(std::move(*found));
        return found.has_value();
    }
    void forgetJudging() final { m_task.forget(); }

    PoolTask<Judgement> m_task;
    std::vector<Judgement> m_squeezes;
};

} // namespace gripscope
