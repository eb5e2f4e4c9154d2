// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/factory/gripper_factory.h"

#include "core/session/connection/gripper_return.h"
#include "devices/acquisition/device_port.h"
#include "devices/address/device_address.h"
#include "devices/hid/hid_return.h"
#include "devices/hid/hid_transport.h"
#include "devices/hid/node_permission.h"
#include "devices/profile/profiled_device.h"
#include "devices/replay/capture_decoder.h"
#include "devices/replay/capture_transport.h"
#include "devices/replay/replay_port.h"
#include "devices/virtual/virtual_plug.h"
#include "devices/virtual/virtual_transport.h"

#include <QFileInfo>

#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A virtual gripper that its faults plug in again.
class VirtualReturn : public GripperReturn {
public:
    using PortMaker = std::function<std::unique_ptr<GripperPort>()>;
    VirtualReturn(VirtualAddress address, PortMaker makePort)
        : m_address(std::move(address)), m_makePort(std::move(makePort))
    {
    }

    [[nodiscard]] std::unique_ptr<GripperPort> take() override
    {
        const bool there = virtual_plug::comesBack(m_address) && virtual_plug::isIn(m_address);
        return there ? m_makePort() : nullptr;
    }

private:
    const VirtualAddress m_address;
    const PortMaker m_makePort;
};

} // namespace

namespace {

using Port = Expected<std::unique_ptr<GripperPort>>;

/// What a port needs to know beside its address: of keeping its reports (an address may name a file, which
/// comes before the setting) and of the link's limits.
struct PortOptions {
    std::optional<KeepSessions> sessions;
    std::shared_ptr<CaptureMonitor> monitor;
    LinkLimits limits;

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
                                          const QString& capture, const PortOptions& options)
{
    return std::make_unique<DevicePort>(text, options.around(device.transport, text, capture),
                                        SampleQueue::defaultCapacity, device.decoder, options.limits);
}

std::unique_ptr<GripperPort> virtualPort(const QString& text, const VirtualAddress& address,
                                         const QString& capture, PortOptions options)
{
    if (options.sessions && !options.sessions->virtualToo)
        options.sessions.reset();
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, capture, options);
    const TransportMaker make = [address,
                                 patience = options.limits.virtualPatience]() -> std::shared_ptr<Transport> {
        return *VirtualTransport::make(address, patience);
    };
    return std::make_unique<DevicePort>(text, options.around(make, text, capture),
                                        SampleQueue::defaultCapacity, &GripscopeDecoder::make,
                                        options.limits);
}

Port makePort(const QString& text, const VirtualAddress& address, const PortOptions& options)
{
    // Made once here, so that an object that makes no sense is told at once.
    RETURN_IF_ERROR(VirtualTransport::make(address));
    return virtualPort(text, address, address.capture, options);
}

std::unique_ptr<GripperPort> hidPort(const QString& text, const HidAddress& address,
                                     const PortOptions& options)
{
    if (const std::optional<ProfiledDeviceMakers> device = profiledDevice(address))
        return profiledPort(text, *device, address.capture, options);
    const TransportMaker make = [address]() -> std::shared_ptr<Transport> {
        return std::make_shared<HidTransport>(address);
    };
    return std::make_unique<DevicePort>(text, options.around(make, text, address.capture),
                                        SampleQueue::defaultCapacity, &GripscopeDecoder::make,
                                        options.limits);
}

Port makePort(const QString& text, const HidAddress& address, const PortOptions& options)
{
    return hidPort(text, address, options);
}

Port makePort(const QString& text, const ReplayAddress& address, const PortOptions&)
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
                                        const PortOptions& options)
{
    if (!virtual_plug::comesBack(address))
        return nullptr;
    const QString capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<VirtualReturn>(
        address, [=, text = awaited.address] { return virtualPort(text, address, capture, options); });
}

std::unique_ptr<GripperReturn> returnOf(HidAddress address, const AwaitedGripper& awaited,
                                        const PortOptions& options)
{
    address.capture = captureOfLink(address.capture, awaited.timesLost + 1);
    return std::make_unique<HidReturn>(
        address, awaited,
        [text = awaited.address, options](const HidAddress& found) { return hidPort(text, found, options); });
}

std::unique_ptr<GripperReturn> returnOf(const ReplayAddress&, const AwaitedGripper&, const PortOptions&)
{
    return nullptr;
}

} // namespace

Port DeviceFactory::create(const QString& address)
{
    ASSIGN_OR_RETURN(const DeviceAddress parsed, parseDeviceAddress(address));
    const PortOptions options{m_keep, m_monitor, m_limits};
    return std::visit([&](const auto& kind) { return makePort(address, kind, options); }, parsed);
}

std::unique_ptr<GripperReturn> DeviceFactory::awaitReturn(const AwaitedGripper& awaited)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(awaited.address);
    if (!parsed)
        return nullptr;
    const PortOptions options{m_keep, m_monitor, m_limits};
    return std::visit([&](const auto& kind) { return returnOf(kind, awaited, options); }, *parsed);
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
        if (!node.accessible) {
            device.missing = missingIn(permissionOf(node));
            device.toAllow = permissionCommand(node);
        }
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
