// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_report.h"
#include "devices/line/mqtt/mqtt_words.h"

#include <functional>
#include <memory>
#include <thread>

namespace gripscope {

/// Where the results of a library wait: beside it.
[[nodiscard]] QString mqttFile(const QString& library);

/// Results on their way to a broker, each kept in a file (outbox_file.h) before anybody may send it, by a
/// thread that only does that. Who hands one over never waits. When there is no room, the newest is refused:
/// what was taken is sent, and a gap in the sequence says how many are missing.
class MqttOutbox {
public:
    struct Limits {
        std::size_t mostWaiting = 10'000; ///< some five megabytes
        std::size_t mostHanded = 256;     ///< not in the file yet
    };
    explicit MqttOutbox(const QString& file) : MqttOutbox(file, Limits()) {}
    MqttOutbox(const QString& file, const Limits& limits);
    ~MqttOutbox(); ///< what was handed over is in the file
    MqttOutbox(const MqttOutbox&) = delete;
    MqttOutbox& operator=(const MqttOutbox&) = delete;

    /// Its sequence is given here.
    void offer(const LineReport& report);

    // The sender's side.
    /// Waits for the disk until it is known what an earlier program left: before, nothing below is. False
    /// where the file cannot be had, for now; see status().
    [[nodiscard]] bool waitUntilRead() const;
    /// At most so many that wait, in their order, behind this sequence.
    [[nodiscard]] std::vector<LineReport> waiting(quint64 behind, std::size_t most) const;
    [[nodiscard]] quint64 newest() const; ///< the last sequence of what was handed over
    void acknowledge(quint64 sequence);   ///< this one and all before it
    /// Another number for each session with a broker, 0 to 255, kept before it is told. Waits for the disk;
    /// nothing where the file cannot be had.
    [[nodiscard]] std::optional<std::uint8_t> nextBirth();
    /// Called on the outbox's thread when there is something new to send; empty: nobody is.
    void setWake(std::function<void()> wake);

    struct Status {
        std::size_t waiting = 0; ///< not acknowledged
        quint64 refused = 0;     ///< since this program runs
        bool damaged = false;    ///< some of the file could not be read
        std::optional<Error> problem;
    };
    [[nodiscard]] Status status() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// Sends what an outbox holds to a broker, in a thread of its own, which may wait for the network. Nobody
/// waits for it: one that hangs when it is to go ends by itself later, and sends nothing more.
class MqttPublisher {
public:
    MqttPublisher(const MqttOptions& options, std::shared_ptr<MqttOutbox> outbox);
    ~MqttPublisher(); ///< waits for milliseconds
    MqttPublisher(const MqttPublisher&) = delete;
    MqttPublisher& operator=(const MqttPublisher&) = delete;

    void setGripper(const QString& serial); ///< that is connected; empty: none
    /// Says that the node leaves. True when it did so within this time.
    bool end(std::chrono::milliseconds patience);
    [[nodiscard]] MqttLink link() const;

private:
    struct Shared;
    std::shared_ptr<Shared> d;
    std::thread m_thread;
};

} // namespace gripscope
