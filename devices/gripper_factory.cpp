// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/gripper_factory.h"

#include "devices/acquisition/device_port.h"
#include "devices/device_address.h"
#include "devices/hid/hid_transport.h"
#include "devices/replay/capture_transport.h"
#include "devices/replay/replay_port.h"
#include "devices/virtual/virtual_transport.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Port = Expected<std::unique_ptr<GripperPort>>;

TransportMaker capturing(TransportMaker make, const QString& file)
{
    if (file.isEmpty())
        return make;
    return [make = std::move(make), file] { return std::make_shared<CapturingTransport>(make(), file); };
}

Port makePort(const QString& text, const VirtualAddress& address)
{
    // Made once here, so that an object that makes no sense is told at once.
    if (const auto checked = VirtualTransport::make(address); !checked)
        return tl::unexpected<Error>(checked.error());
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return *VirtualTransport::make(address);
    };
    return std::make_unique<DevicePort>(text, capturing(make, address.capture));
}

Port makePort(const QString& text, const HidAddress& address)
{
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return std::make_shared<HidTransport>(address);
    };
    return std::make_unique<DevicePort>(text, capturing(make, address.capture));
}

Port makePort(const QString& text, const ReplayAddress& address)
{
    const QString file = address.file;
    if (!file.endsWith(u".gscap", Qt::CaseInsensitive))
        return std::make_unique<ReplayPort>(text, file);
    return std::make_unique<DevicePort>(text, [file]() -> std::shared_ptr<Transport> {
        return std::make_shared<CaptureReplayTransport>(file);
    });
}

} // namespace

Port DeviceFactory::create(const QString& address)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    return std::visit([&](const auto& kind) { return makePort(address, kind); }, *parsed);
}

std::vector<FoundDevice> findDevices()
{
    std::vector<FoundDevice> found{
        {u"virtual:"_qs, u"VG-1"_qs, u"Virtual gripper, can A"_qs, u"available"_qs}};
    for (const HidNode& node : grippersAmong(listHidNodes()))
        found.push_back({addressOf(node), node.serial, node.name,
                         node.accessible ? u"available"_qs : u"no permission"_qs});
    return found;
}

} // namespace gripscope
