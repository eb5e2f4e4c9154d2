// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

/// What can go wrong with the virtual gripper; resources/manual/virtual.md says what each one does.
enum class Fault {
    Loss,
    Duplicate,
    Crc,
    Saturate,
    Stuck,
    Stall,
    Resume,
    Clock,
    Unplug,
    Replug,
    Deaf,
    HangFeature,
    HangWrite,
    Broken,
    NoWatchdog,
    Load,
    Button,
    ClockRate,
};

/// From `at_s` on. `value`: a share (Loss, Duplicate, Crc), newtons (Saturate, Load), seconds (Clock: the
/// step; HangFeature, HangWrite: how long a call blocks), a report ID (Deaf; 0: all commands), by how much
/// its time is fast, as a share (ClockRate); without one: off again, or nothing to say.
struct FaultEvent {
    double at_s = 0;
    Fault fault = Fault::Loss;
    std::optional<double> value;
    friend bool operator==(const FaultEvent&, const FaultEvent&) = default;
};

/// All that is wrong at a moment.
struct FaultState {
    double loss = 0, duplicate = 0, badCrc = 0; ///< share of the reports
    std::optional<double> saturate_N;           ///< the force channel ends there
    double load_N = 0;    ///< a weight hangs on the force sensor (no fault: to calibrate with)
    bool stuck = false;   ///< the position channel stays where it was
    bool stalled = false; ///< nothing is sent
    bool unplugged = false;
    bool broken = false;       ///< the device finds a fault in itself
    bool noWatchdog = false;   ///< it states one, and none trips
    bool buttonDown = false;   ///< a person holds its button (no fault either)
    double clock_s = 0;        ///< its clock is ahead by so much
    double clockRate = 0;      ///< its time is fast by this share: its clock, and when it samples
    std::uint32_t deafTo = 0;  ///< bit i: output report 0x20 + i does not arrive
    double featureHangs_s = 0; ///< a feature request blocks for so long, and fails
    double writeHangs_s = 0;   ///< so does a write
    friend bool operator==(const FaultState&, const FaultState&) = default;

    void apply(const FaultEvent& event);
    [[nodiscard]] bool deaf(std::uint8_t reportId) const;
};

/// A line for each event: the time in seconds since the connection opened, a word, what the word needs;
/// behind # comes a comment.
///
///     2.0 loss 0.1      # a tenth of the reports
///     3.0 loss 0
///     4.0 stall
///     4.5 resume
///
/// Times never decrease. BadInput with FILE:LINE:COLUMN, what was found and what may be there.
[[nodiscard]] Expected<std::vector<FaultEvent>> parseFaultScript(const QByteArray& text, const QString& name);
/// FileUnreadable, or as above.
[[nodiscard]] Expected<std::vector<FaultEvent>> readFaultScript(const QString& file);

/// The events in order of time; those of one time stay in their order.
void sortByTime(std::vector<FaultEvent>& events);

/// These events and those of a script, in order of time; no script where the name is empty.
[[nodiscard]] Expected<std::vector<FaultEvent>> withScript(std::vector<FaultEvent> events,
                                                           const QString& script);

/// Longest time in a script, s: eleven days.
inline constexpr double longestFaultTime_s = 1e6;
/// The most by which its time can be wrong, as a share.
inline constexpr double largestClockRate = 0.5;
/// How long a call hangs unless told otherwise: as long as the kernel waits for a device's answer.
inline constexpr double usualHang_s = 5;

} // namespace gripscope
