// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/gripper_factory.h"

#include "devices/acquisition/device_port.h"
#include "devices/device_address.h"
#include "devices/hid/hid_return.h"
#include "devices/hid/hid_transport.h"
#include "devices/profile/profiled_device.h"
#include "devices/replay/capture_decoder.h"
#include "devices/replay/capture_transport.h"
#include "devices/replay/replay_port.h"
#include "devices/virtual/virtual_return.h"
#include "devices/virtual/virtual_transport.h"

#include <QFileInfo>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Port = Expected<std::unique_ptr<GripperPort>>;

/// What a port needs to know of keeping its reports: an address may name a file, which comes before the
/// setting.
struct Keeping {
    std::optional<KeepSessions> sessions;
    std::shared_ptr<CaptureMonitor> monitor;

    [[nodiscard]] TransportMaker around(TransportMaker make, const QString& address,
                                        const QString& file) const
    {
        CaptureDestination to{file, {}, address};
        if (file.isEmpty() && !sessions)
            return make;
        if (file.isEmpty()) {
            to.folder = sessions->folder;
            to.limits = sessions->limits;
        }
        return [make = std::move(make), to, told = monitor] {
            return std::make_shared<CapturingTransport>(make(), to, told);
        };
    }
};

std::unique_ptr<GripperPort> profiledPort(const QString& text, const ProfiledDeviceMakers& device,
                                          const QString& capture, const Keeping& keeping)
{
    return std::make_unique<DevicePort>(text, keeping.around(device.transport, text, capture),
                                        SampleQueue::defaultCapacity, device.decoder);
}

std::unique_ptr<GripperPort> virtualPort(const QString& text, const VirtualAddress& address,
                                         const QString& capture, Keeping keeping)
{
    if (keeping.sessions && !keeping.sessions->virtualToo)
        keeping.sessions.reset();
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, capture, keeping);
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return *VirtualTransport::make(address);
    };
    return std::make_unique<DevicePort>(text, keeping.around(make, text, capture));
}

Port makePort(const QString& text, const VirtualAddress& address, const Keeping& keeping)
{
    // Made once here, so that an object that makes no sense is told at once.
    if (const auto checked = VirtualTransport::make(address); !checked)
        return tl::unexpected<Error>(checked.error());
    return virtualPort(text, address, address.capture, keeping);
}

std::unique_ptr<GripperPort> hidPort(const QString& text, const HidAddress& address, const Keeping& keeping)
{
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, address.capture, keeping);
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return std::make_shared<HidTransport>(address);
    };
    return std::make_unique<DevicePort>(text, keeping.around(make, text, address.capture));
}

Port makePort(const QString& text, const HidAddress& address, const Keeping& keeping)
{
    return hidPort(text, address, keeping);
}

Port makePort(const QString& text, const ReplayAddress& address, const Keeping&)
{
    const QString file = address.file;
    const double speed = address.speed;
    if (!file.endsWith(u".gscap", Qt::CaseInsensitive))
        return std::make_unique<ReplayPort>(text, file, speed);
    return std::make_unique<DevicePort>(
        text,
        [file, speed]() -> std::shared_ptr<Transport> {
            return std::make_shared<CaptureReplayTransport>(file, speed);
        },
        SampleQueue::defaultCapacity, [file] { return std::make_unique<CaptureDecoder>(file); });
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

std::unique_ptr<GripperReturn> returnOf(const VirtualAddress& address, const AwaitedGripper& awaited,
                                        const Keeping& keeping)
{
    if (!virtual_plug::comesBack(address))
        return nullptr;
    const QString capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<VirtualReturn>(
        address, [=, text = awaited.address] { return virtualPort(text, address, capture, keeping); });
}

std::unique_ptr<GripperReturn> returnOf(HidAddress address, const AwaitedGripper& awaited,
                                        const Keeping& keeping)
{
    address.capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<HidReturn>(
        address, awaited,
        [text = awaited.address, keeping](const HidAddress& found) { return hidPort(text, found, keeping); });
}

std::unique_ptr<GripperReturn> returnOf(const ReplayAddress&, const AwaitedGripper&, const Keeping&)
{
    return nullptr;
}

} // namespace

Port DeviceFactory::create(const QString& address)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    const Keeping keeping{m_keep, m_monitor};
    return std::visit([&](const auto& kind) { return makePort(address, kind, keeping); }, *parsed);
}

std::unique_ptr<GripperReturn> DeviceFactory::awaitReturn(const AwaitedGripper& awaited)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(awaited.address);
    if (!parsed)
        return nullptr;
    const Keeping keeping{m_keep, m_monitor};
    return std::visit([&](const auto& kind) { return returnOf(kind, awaited, keeping); }, *parsed);
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
