// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "core/signal/recording/recording.h"
#include "devices/transport/bounded_thread.h"

#include <chrono>
#include <memory>
#include <mutex>

namespace gripscope {

/// A recording (CSV) played back as if a gripper sent it: the same samples at the pace of their time
/// stamps or a multiple of it.
/// It cannot be commanded.
///
/// open() reads the file in a thread of its own; Lost with the file's error when it is not one. At the end,
/// when the last sample has been drained, the state becomes Closed and lastError() says that the recording is
/// through. Lost samples of the recording count as lost here. No thread runs during the play: drain() looks
/// at the clock.
class ReplayPort : public GripperPort {
public:
    /// `speed`: times the pace of the time stamps; 0: as fast as it is drained.
    ReplayPort(QString address, QString file, double speed = 1);
    ~ReplayPort() override;

    void open() override;
    void close() override;
    [[nodiscard]] LinkState state() const override;
    [[nodiscard]] std::optional<Error> lastError() const override;
    [[nodiscard]] GripperIdentity identity() const override;
    [[nodiscard]] LinkCounters counters() const override;
    std::size_t drain(std::vector<Sample>& samples, std::size_t most = 65536) override;
    void arm(const ArmingOrder&) override {}
    void disarm() override {}
    void startExcitation(const AdmittedExcitation&) override {}
    [[nodiscard]] SqueezeState squeezeState() const override { return SqueezeState::Idle; }
    void finishExcitation() override {}
    void stop() noexcept override {}
    void confirmAlive() noexcept override {}

private:
    using Clock = std::chrono::steady_clock;
    void takeOver() const; ///< the file, once it is read

    /// The file on its way in; shared with the thread that reads it, which may be left behind.
    struct Reading {
        std::mutex mutex;
        std::optional<Expected<Recording>> result;
    };

    const QString m_address, m_file;
    const double m_speed;
    std::shared_ptr<Reading> m_reading;
    BoundedThread m_reader;
    // Reading ends between two calls of the owner, some of which are const: hence mutable.
    mutable LinkState m_state = LinkState::Closed;
    mutable std::optional<Error> m_error;
    mutable Recording m_recording;
    mutable std::vector<Gap> m_gaps;
    mutable GripperIdentity m_identity;
    mutable Clock::time_point m_started;
    std::size_t m_next = 0;    ///< sample
    std::size_t m_nextGap = 0; ///< in m_gaps
    LinkCounters m_counters;
};

} // namespace gripscope
