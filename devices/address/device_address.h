// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/fault_script.h"
#include "devices/address/virtual_object.h"

#include <QString>

#include <variant>

namespace gripscope {

/// So many samples a second a virtual gripper can take: five in each of a thousand reports at the most.
inline constexpr double slowestVirtual_Hz = 20, fastestVirtual_Hz = 5000;
/// Of a sample time: no position is taken before the one before it, nor behind the next.
inline constexpr double largestJitter = 0.25;

struct VirtualAddress {
    QString object = QStringLiteral("A"); ///< "A".."D", "m,b,k" in SI, or a SimulatedPart
    std::uint64_t seed = 1;
    VirtualTerms terms = {};
    /// A part of a gauge study, its seed the one above; none: the object scatters by itself.
    std::optional<VirtualStudyPart> study = {};
    double samplesPerSecond = 2000;
    double jitter_s = 0; ///< standard deviation of when a position is taken, about when it says
    std::optional<double> positionNoise_m; ///< standard deviation; default 5 um
    double speed = 1; ///< device seconds in a second; 0: as fast as it can, and only while a squeeze runs
    std::vector<FaultEvent> faults; ///< in order of time
    QString script;                 ///< file with further ones (fault_script.h); empty: none
    bool millimetres = false;       ///< the device states its positions in mm instead of m
    QString capture;                ///< file for the raw reports (.gscap); empty: none
    /// Another maker's gripper, which squeezes by itself: what its bytes are read by, and what they are sent
    /// by. A file, or the name of a profile that came with the program; one alone stands for both, but for
    /// `like` alone, which is read by the profile there is for its USB numbers.
    QString profile, like;
    friend bool operator==(const VirtualAddress&, const VirtualAddress&) = default;
};
struct HidAddress {
    std::optional<std::uint16_t> vendor, product;
    QString serial{};  ///< empty: the only one there is
    QString capture{}; ///< file for the raw reports (.gscap); empty: none
    QString port{};    ///< where it is plugged in; empty: anywhere
    QString profile{}; ///< what another maker's gripper is read by; empty: the one there is for its numbers
};
struct ReplayAddress {
    QString file;
    double speed = 1; ///< times the pace it was taken at; 0: as fast as it is read
};
using DeviceAddress = std::variant<VirtualAddress, HidAddress, ReplayAddress>;

/// `virtual:?object=A&seed=7&noise=20e-6&speed=0&fault=loss:0.01,stuck&script=FILE`, with friction=N,
/// own-friction=N, zener=SHARE,TAU, k3=N_PER_M3, rate=HZ and jitter=S of parts and grippers that are not
/// ideal (object=tomato and other simulated parts yield without zener=), with part=N, operator=N, trial=N,
/// part-spread=S, operator-spread=S and repeat-spread=S of a gauge study (VirtualStudyPart), `hid:`,
/// `hid:1209:0001`, `hid:1209:0001:SERIAL`, `hid:1209:0001:SERIAL?port=usb-0000:00:14.0-2/input0` (of several
/// with the same number, or none, the one at that port), `replay:FILE` or `replay:FILE?speed=10` (a
/// recording, or a capture: FILE ends in .gscap). With the option capture=FILE, behind `virtual:?` or
/// `hid:...?`, the raw reports are kept. Usage errors name the part that is wrong and what it may be.
/// profile=FILE reads another maker's gripper by that profile.
///
/// Faults: loss:P, duplicate:P, crc:P, saturate:N, stuck and units from the beginning on; stall:S, unplug:S,
/// deaf:S, hang-feature:S, hang-write:S, broken:S and button:S after so many seconds; replug:S so long after
/// the unplug. A script (fault_script.h) says more; it is read when the gripper is opened.
[[nodiscard]] Expected<DeviceAddress> parseDeviceAddress(const QString& text);

} // namespace gripscope
