// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/sensor_correction.h"
#include "core/session/connection/gripper_port.h"
#include "core/session/connection/safety_gate.h"

#include <functional>
#include <memory>
#include <optional>

namespace gripscope {

/// The calibrations in force for the connected gripper, and what they do to its samples: from the device's
/// readings to loads. Recordings hold loads, and say in their provenance by which calibration; the readings
/// can be found again from it.
class ChannelCalibration {
public:
    /// Only those whose unit is the channel's own; the others are told by unusable(). None for a gripper
    /// whose samples are corrected already.
    void put(const CalibrationsInForce& calibrations, const GripperIdentity& gripper);
    void clear() { *this = {}; }
    /// What is used of a channel; null when nothing is.
    [[nodiscard]] const CalibrationRecord* record(SensorChannel channel) const;
    /// The reference object that the gripper is checked on.
    [[nodiscard]] const std::optional<ReferenceStanding>& reference() const { return m_reference; }
    [[nodiscard]] const QString& unusable() const { return m_unusable; }

    void correct(std::vector<Sample>& samples) const;
    /// The reading of the device itself that correct() takes to this value.
    [[nodiscard]] double uncorrected(SensorChannel channel, double value) const;
    /// Notes in the recording what was done to its channels, how long that holds and how certain it is.
    void describe(Recording& recording, const QDateTime& now) const;

private:
    struct InUse {
        CalibrationRecord record;
        SensorCorrection correction;
        double scaleUncertainty = 0; ///< relative, standard
    };
    [[nodiscard]] std::optional<InUse> use(const std::optional<CalibrationRecord>& record,
                                           const QString& unit);
    [[nodiscard]] const std::optional<InUse>& of(SensorChannel channel) const;

    std::optional<InUse> m_force, m_position;
    std::optional<ReferenceStanding> m_reference;
    QString m_unusable;
};

/// The connection to one gripper: opens it, drains its samples, hands them on, keeps count. No thread, no
/// timer: whoever owns it calls poll() every 16 to 33 ms (a screen) or in a loop (the command line).
///
///     Disconnected -> Connecting -> Connected -> Lost -> Connected ...
///                                             -> Disconnected (a replay is through)
///
/// A gripper that went away, or did not open, is looked out for while the state is Lost (see awaiting()), and
/// connected as soon as it is there: the same one, by its serial number. Nothing is armed by that: armed is
/// what a person makes it. disconnect() and connectTo() end the looking.
class ConnectSession {
public:
    enum class State { Disconnected, Connecting, Connected, Lost };
    using SampleListener = std::function<void(const std::vector<Sample>&)>;

    explicit ConnectSession(GripperPortFactory& factory);
    ~ConnectSession();
    ConnectSession(const ConnectSession&) = delete;
    ConnectSession& operator=(const ConnectSession&) = delete;

    /// Closes what is open, then starts to open `address`.
    [[nodiscard]] Expected<void> connectTo(const QString& address);
    void disconnect();
    /// Takes over what arrived, tells the listeners, moves the state on, tells the port that its owner is
    /// alive.
    void poll();

    [[nodiscard]] State state() const;
    /// Disconnected because the stream came to its orderly end (a replay), not by disconnect().
    [[nodiscard]] bool streamEnded() const;
    [[nodiscard]] std::optional<Error> lastError() const;
    [[nodiscard]] QString address() const;
    [[nodiscard]] GripperIdentity
    identity() const; ///< of the last gripper that answered, also after it was lost
    /// As of the last poll(), of all links to this gripper since connectTo().
    [[nodiscard]] LinkCounters counters() const;
    /// Lost, but connected again by itself as soon as it is there.
    [[nodiscard]] bool awaiting() const;
    /// How often this gripper went away and came back since connectTo(). Its samples count and time anew
    /// after each.
    [[nodiscard]] int reconnections() const;
    /// As of the last poll(), so that whoever looks after each poll misses no change.
    [[nodiscard]] bool armed() const;
    [[nodiscard]] GripperPort* port(); ///< null unless connected
    [[nodiscard]] SafetyGate* gate();  ///< null unless connected

    [[nodiscard]] Expected<void> arm(const QString& person);
    void disarm();
    void stop() noexcept;
    /// As of the last poll(). NotObeyed stays until the gripper was connected anew: switch off its power.
    [[nodiscard]] StopState stopState() const;
    /// Why the gripper is armed no longer though nobody asked for it; until it is armed again.
    [[nodiscard]] std::optional<Error> disarmReason() const;

    /// What was measured of this gripper's channels: recordings carry it from now on, until the next
    /// connectTo().
    void setMeasuringChain(double forceLag_s, const MeasuringChain& chain);
    [[nodiscard]] double forceLag_s() const; ///< as measured, else as the gripper says
    [[nodiscard]] const MeasuringChain& measuringChain() const;

    /// What the channels are corrected by from now on, until the next connectTo(); samples, live and
    /// recorded, are corrected from here on.
    void setCalibrations(const CalibrationsInForce& calibrations);
    [[nodiscard]] const ChannelCalibration& calibration() const;
    /// For an owner that has to ask for the calibrations first: after each connectTo() from now on nothing is
    /// squeezed before setCalibrations() was called, with none of them too. Off unless told otherwise.
    void awaitCalibrations(bool on);
    /// They could not be read; until setCalibrations().
    void tellCalibrationsUnread(const Error& reason);
    /// Usage, in words for a person, while they are awaited.
    [[nodiscard]] Expected<void> calibrationsTold() const;
    /// The device's own reading behind a corrected value.
    [[nodiscard]] double uncorrected(SensorChannel channel, double value) const;

    /// Called in poll() with each batch of new samples; returns a handle for removeListener(). A listener may
    /// add and remove listeners, itself too.
    int addListener(SampleListener listener);
    void removeListener(int handle);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
