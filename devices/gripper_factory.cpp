// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/gripper_factory.h"

#include "devices/acquisition/device_port.h"
#include "devices/device_address.h"
#include "devices/hid/hid_return.h"
#include "devices/hid/hid_transport.h"
#include "devices/profile/profiled_device.h"
#include "devices/replay/capture_transport.h"
#include "devices/replay/replay_port.h"
#include "devices/virtual/virtual_return.h"
#include "devices/virtual/virtual_transport.h"

#include <QFileInfo>

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

std::unique_ptr<GripperPort> profiledPort(const QString& text, const ProfiledDeviceMakers& device,
                                          const QString& capture)
{
    return std::make_unique<DevicePort>(text, capturing(device.transport, capture),
                                        SampleQueue::defaultCapacity, device.decoder);
}

std::unique_ptr<GripperPort> virtualPort(const QString& text, const VirtualAddress& address,
                                         const QString& capture)
{
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, capture);
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return *VirtualTransport::make(address);
    };
    return std::make_unique<DevicePort>(text, capturing(make, capture));
}

Port makePort(const QString& text, const VirtualAddress& address)
{
    // Made once here, so that an object that makes no sense is told at once.
    if (const auto checked = VirtualTransport::make(address); !checked)
        return tl::unexpected<Error>(checked.error());
    return virtualPort(text, address, address.capture);
}

std::unique_ptr<GripperPort> hidPort(const QString& text, const HidAddress& address)
{
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, address.capture);
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return std::make_shared<HidTransport>(address);
    };
    return std::make_unique<DevicePort>(text, capturing(make, address.capture));
}

Port makePort(const QString& text, const HidAddress& address)
{
    return hidPort(text, address);
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

/// Another file for each link, so that a gripper that comes back does not write over what it sent before:
/// grip.gscap, grip-2.gscap...
QString captureOfLink(const QString& file, int link)
{
    if (file.isEmpty())
        return file;
    const QFileInfo info(file);
    const QString name = info.completeBaseName() + u'-' + QString::number(link);
    return info.path() + u'/' + (info.suffix().isEmpty() ? name : name + u'.' + info.suffix());
}

std::unique_ptr<GripperReturn> returnOf(const VirtualAddress& address, const AwaitedGripper& awaited)
{
    if (!virtual_plug::comesBack(address))
        return nullptr;
    const QString capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<VirtualReturn>(
        address, [=, text = awaited.address] { return virtualPort(text, address, capture); });
}

std::unique_ptr<GripperReturn> returnOf(HidAddress address, const AwaitedGripper& awaited)
{
    address.capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<HidReturn>(
        address, awaited, [text = awaited.address](const HidAddress& found) { return hidPort(text, found); });
}

std::unique_ptr<GripperReturn> returnOf(const ReplayAddress&, const AwaitedGripper&)
{
    return nullptr;
}

} // namespace

Port DeviceFactory::create(const QString& address)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    return std::visit([&](const auto& kind) { return makePort(address, kind); }, *parsed);
}

std::unique_ptr<GripperReturn> DeviceFactory::awaitReturn(const AwaitedGripper& awaited)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(awaited.address);
    if (!parsed)
        return nullptr;
    return std::visit([&](const auto& kind) { return returnOf(kind, awaited); }, *parsed);
}

std::vector<FoundDevice> findDevices()
{
    return devicesAmong(listHidNodes());
}

std::vector<FoundDevice> devicesAmong(const std::vector<HidNode>& nodes)
{
    std::vector<FoundDevice> found{
        {u"virtual:"_qs, u"VG-1"_qs, u"Virtual gripper, can A"_qs, u"available"_qs}};
    const auto add = [&](const HidNode& node, const QString& name) {
        FoundDevice device{addressOf(node, nodes), node.serial, name,
                           node.accessible ? u"available"_qs : u"no permission"_qs};
        if (device.address.contains(u"?port="))
            device.port = node.port;
        if (!node.accessible)
            device.toAllow = permissionCommands(node);
        found.push_back(device);
    };
    for (const HidNode& node : grippersAmong(nodes))
        add(node, node.name);
    const ProfileCollection profiles = nodes.empty() ? ProfileCollection() : loadProfiles();
    for (const HidNode& node : nodes)
        if (const KnownProfile* known = profiles.find(node.vendor, node.product))
            add(node, known->profile.name);
    return found;
}

} // namespace gripscope
