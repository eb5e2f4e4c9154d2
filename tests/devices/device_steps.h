// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/devices/bare_device.h"

#include <functional>

// Ways to bring a bare device to a state, for tests of what it does there.

namespace gripscope::test {

using Steps = std::function<void(BareDevice&)>;
using Forces = std::vector<std::int32_t>;
inline constexpr std::int32_t ownForce = VirtualFirmware::ownForce, ownTravel = VirtualFirmware::ownTravel;
inline constexpr std::size_t rest = 100, restAfter = 120; ///< samples of 0.5 ms
inline constexpr std::uint32_t mostSamples = VirtualFirmware::maxSamples;
inline const Forces push(400, 10000); // 10 N for 200 ms

/// Without noise, so that what is measured is what is commanded, to a count.
inline VirtualFirmwareOptions quiet(const QString& object = QStringLiteral("A"))
{
    VirtualFirmwareOptions options = BareDevice::options(object);
    options.forceNoise_N = 0;
    options.positionNoise_m = 0;
    return options;
}

inline protocol::UploadCommand chunk(std::uint16_t excitation, std::uint32_t first, const Forces& forces)
{
    protocol::UploadCommand upload;
    upload.excitationNumber = excitation;
    upload.offset = first;
    upload.count = static_cast<std::uint8_t>(forces.size());
    std::copy(forces.begin(), forces.end(), upload.forces.begin());
    return upload;
}

inline void armed(BareDevice& d)
{
    d.send(protocol::ArmCommand{1});
}
inline void loaded(BareDevice& d)
{
    armed(d);
    d.upload(push, 5);
}
inline void resting(BareDevice& d)
{
    loaded(d);
    d.start(push, 5);
}
inline void moving(BareDevice& d)
{
    resting(d);
    d.run(rest + 10);
}
inline void settling(BareDevice& d)
{
    resting(d);
    d.run(rest + push.size() + 10);
}
inline void finished(BareDevice& d)
{
    resting(d);
    d.run(rest + push.size() + restAfter + 10);
}
inline void broken(BareDevice& d, bool is = true)
{
    FirmwareFaults faults;
    faults.broken = is;
    d.firmware.setFaults(faults);
}
inline void weight(BareDevice& d, double load_N)
{
    FirmwareFaults faults;
    faults.load_N = load_N;
    d.firmware.setFaults(faults);
}

} // namespace gripscope::test

Q_DECLARE_METATYPE(gripscope::test::Steps)
Q_DECLARE_METATYPE(gripscope::protocol::CommandBody)
