// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <variant>

namespace gripscope {

/// Faults the virtual gripper can be asked for: `fault=loss:0.01`, several separated by commas.
struct VirtualFaults {
    double lossProbability = 0;            ///< loss:P        a report is not sent
    double duplicateProbability = 0;       ///< duplicate:P   a report is sent twice
    double badCrcProbability = 0;          ///< crc:P         a bit is flipped
    std::optional<double> stallAfter_s;    ///< stall:S   no more reports, the device stays
    std::optional<double> unplugAfter_s;   ///< unplug:S  the device goes away
    std::optional<double> saturateForce_N; ///< saturate:N  the force channel ends there
    bool sensorStuck = false;              ///< stuck         the position channel stays where it was
    bool millimetres = false;              ///< units         the device states its positions in mm, not m
};

struct VirtualAddress {
    QString object = QStringLiteral("A"); ///< "A".."D", or "m,b,k" in SI
    std::uint64_t seed = 1;
    std::optional<double> positionNoise_m; ///< standard deviation; default 5 um
    double speed = 1; ///< device seconds in a second; 0: as fast as it can, and only while a squeeze runs
    VirtualFaults faults;
    QString capture; ///< file for the raw reports (.gscap); empty: none
};
struct HidAddress {
    std::optional<std::uint16_t> vendor, product;
    QString serial;  ///< empty: the only one there is
    QString capture; ///< file for the raw reports (.gscap); empty: none
};
struct ReplayAddress {
    QString file;
};
using DeviceAddress = std::variant<VirtualAddress, HidAddress, ReplayAddress>;

/// `virtual:?object=A&seed=7&noise=20e-6&speed=0&fault=loss:0.01,stuck`, `hid:`, `hid:1209:0001`,
/// `hid:1209:0001:SERIAL`, `replay:FILE` (a recording, or a capture: FILE ends in .gscap). With the option
/// capture=FILE, behind `virtual:?` or `hid:...?`, the raw reports are kept. Usage errors name the part that
/// is wrong and what it may be.
[[nodiscard]] Expected<DeviceAddress> parseDeviceAddress(const QString& text);

} // namespace gripscope
