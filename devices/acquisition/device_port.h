// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "core/session/connection/report_log.h"
#include "devices/acquisition/gripscope_decoder.h"
#include "devices/acquisition/link_limits.h"
#include "devices/acquisition/sample_queue.h"
#include "devices/transport/transport.h"

#include <memory>

namespace gripscope {

/// A gripper behind any transport, which speaks the Gripscope protocol unless another decoder is given. See
/// DeviceLink for the threads.
///
/// Samples of a squeeze always come first: squeezeState() says Finished or Stopped only when drain() has
/// handed out everything that arrived up to that end.
class DevicePort : public GripperPort {
public:
    /// Both makers are called at each open(): a connection never uses what an earlier one left behind.
    DevicePort(QString address, TransportMaker makeTransport,
               std::size_t queueCapacity = SampleQueue::defaultCapacity,
               DecoderMaker makeDecoder = &GripscopeDecoder::make, const LinkLimits& limits = {});
    ~DevicePort() override;
    DevicePort(const DevicePort&) = delete;
    DevicePort& operator=(const DevicePort&) = delete;

    void open() override;
    void close() override;
    [[nodiscard]] LinkState state() const override;
    [[nodiscard]] std::optional<Error> lastError() const override;
    [[nodiscard]] GripperIdentity identity() const override;
    [[nodiscard]] LinkCounters counters() const override;
    std::size_t drain(std::vector<Sample>& samples, std::size_t most = 65536) override;
    void arm(const ArmingOrder& order) override;
    void disarm() override;
    void startExcitation(const AdmittedExcitation& excitation) override;
    [[nodiscard]] SqueezeState squeezeState() const override;
    [[nodiscard]] StopState stopState() const override;
    [[nodiscard]] std::optional<Error> disarmReason() const override;
    void finishExcitation() override;
    void stop() noexcept override;
    void confirmAlive() noexcept override;
    /// Adds which sample was drained last.
    void note(const QString& text) override;
    /// The last reports that passed, of this connection and those before it. May be copied from any thread.
    [[nodiscard]] const ReportLog* reportLog() const override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// Stops every gripper of this program that is open, for who does not know them. From any thread.
void stopOpenLinks() noexcept;

} // namespace gripscope
