// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/session/squeeze/squeeze_job.h"
#include "core/session/tasks/pool.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// What is measured on some squeezes in a row and then kept in the library: the part that is the same for all
/// such measurements.
///
///     Idle -> Squeezing <-> Judging -> Measured -> Storing -> Stored
///       any of them -> Failed (error()), from which a start begins again
class SeriesSession {
public:
    enum class State { Idle, Squeezing, Judging, Measured, Storing, Stored, Failed };

    virtual ~SeriesSession();
    SeriesSession(const SeriesSession&) = delete;
    SeriesSession& operator=(const SeriesSession&) = delete;

    void setOperator(const QString& name);
    void setReason(const QString& why); ///< of what is accepted or removed next
    void cancel();                      ///< stops the gripper, too
    bool poll();                        ///< never waits; true when something changed

    [[nodiscard]] State state() const;
    [[nodiscard]] bool busy() const;       ///< squeezing, judging or storing
    [[nodiscard]] double progress() const; ///< of all squeezes, 0 to 1
    [[nodiscard]] std::optional<Error> error() const;

protected:
    SeriesSession(ConnectSession& connection, LibraryService& library);

    /// Usage: busy. Else what SqueezeJob says.
    [[nodiscard]] Expected<void> begin(const Recipe& recipe, int squeezes);
    /// Keeps something in the library; Stored, and `done`, when it is there.
    template <typename T>
    void store(std::function<Expected<T>(Library&)> work, std::function<void(const T&)> done)
    {
        setState(State::Storing);
        storing() = PendingCall(library().run<T>(std::move(work)),
                                [this, done = std::move(done)](Expected<T> answer) {
                                    if (!answer)
                                        return fail(answer.error());
                                    setState(State::Stored);
                                    done(*answer);
                                });
    }
    /// Keeps what is known of the connected gripper's channels from now on, and puts it in force. Usage: it
    /// was measured on another gripper.
    [[nodiscard]] Expected<void> storeChain(const NewMeasuringChain& measured);
    void fail(const Error& reason);

    virtual void clear() = 0;                           ///< what earlier squeezes said
    virtual void judge(const Recording& recording) = 0; ///< begins with it, in the pool
    virtual bool takeJudged() = 0;                      ///< true when the judgement came
    virtual void forgetJudging() = 0;
    virtual void conclude() = 0; ///< all squeezes are judged; the state is Measured

    [[nodiscard]] ConnectSession& connection() const;
    [[nodiscard]] QString serial() const; ///< of the gripper that was begun with
    [[nodiscard]] QString operatorName() const;

private:
    void setState(State state);
    PendingCall& storing();
    [[nodiscard]] LibraryService& library() const;
    [[nodiscard]] Expected<void> squeeze();
    void followSqueeze();
    void followJudging();

    struct Private;
    std::unique_ptr<Private> d;
};

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
        m_task = inPool([how, recording = std::move(recording)] { return how(recording); });
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

    Pending<Judgement> m_task;
    std::vector<Judgement> m_squeezes;
};

} // namespace gripscope
