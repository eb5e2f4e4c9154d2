// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profiled_device.h"

#include "core/words.h"
#include "devices/hid/hid_transport.h"
#include "devices/profile/listening_transport.h"
#include "devices/profile/virtual_robot_transport.h"
#include "devices/virtual/virtual_transport.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What a virtual gripper of another maker sends.
Expected<GripperProfile> layoutOf(const VirtualAddress& address)
{
    return namedProfile(address.like.isEmpty() ? address.profile : address.like);
}

/// What it is read by: as for a real one, the profile named or the one there is for its USB numbers.
Expected<GripperProfile> profileOf(const VirtualAddress& address)
{
    if (!address.profile.isEmpty())
        return namedProfile(address.profile);
    return layoutOf(address).and_then(
        [](const GripperProfile& sent) { return profileFor(sent.vendor, sent.product); });
}

Expected<GripperProfile> profileOf(const HidAddress& address)
{
    if (!address.profile.isEmpty())
        return namedProfile(address.profile);
    return profileFor(address.vendor.value_or(protocol::vendorId),
                      address.product.value_or(protocol::productId));
}

bool isProfiled(const VirtualAddress& address)
{
    return !address.profile.isEmpty() || !address.like.isEmpty();
}

bool isProfiled(const HidAddress& address)
{
    const bool another = address.vendor.value_or(protocol::vendorId) != protocol::vendorId ||
                         address.product.value_or(protocol::productId) != protocol::productId;
    return another || !address.profile.isEmpty();
}

/// The serial number of the only one there is, when the address names none.
QString serialOf(const HidAddress& address)
{
    if (!address.serial.isEmpty())
        return address.serial;
    const Expected<HidNode> node = chooseHidNode(address, listHidNodes());
    return node ? node->serial : QString();
}

QString serialOf(const VirtualAddress& address)
{
    return u"VR-%1"_s.arg(address.seed);
}

template <typename Address>
DecoderMaker decoderOf(const Address& address)
{
    return [address]() -> std::unique_ptr<ReportDecoder> {
        return std::make_unique<ProfileDecoder>([address] {
            return profileOf(address).map([&](const GripperProfile& profile) {
                return ProfiledDevice{profile, serialOf(address)};
            });
        });
    };
}

std::shared_ptr<Transport> robotAt(const VirtualAddress& address)
{
    return std::make_shared<VirtualRobotTransport>(address, [address] { return layoutOf(address); });
}

} // namespace

std::optional<ProfiledDeviceMakers> profiledDevice(const VirtualAddress& address)
{
    if (!isProfiled(address))
        return std::nullopt;
    return ProfiledDeviceMakers{[address] { return robotAt(address); }, decoderOf(address)};
}

std::optional<ProfiledDeviceMakers> profiledDevice(const HidAddress& address)
{
    if (!isProfiled(address))
        return std::nullopt;
    return ProfiledDeviceMakers{[address]() -> std::shared_ptr<Transport> {
                                    return std::make_shared<ListeningTransport>(
                                        std::make_shared<HidTransport>(address));
                                },
                                decoderOf(address)};
}

Expected<std::shared_ptr<Transport>> listenAt(const QString& address)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    std::shared_ptr<Transport> transport;
    if (const auto* hid = std::get_if<HidAddress>(&*parsed)) {
        transport = std::make_shared<HidTransport>(*hid);
    } else if (const auto* gripper = std::get_if<VirtualAddress>(&*parsed); gripper && isProfiled(*gripper)) {
        transport = robotAt(*gripper);
    } else if (gripper) {
        const Expected<std::shared_ptr<VirtualTransport>> made = VirtualTransport::make(*gripper);
        if (!made)
            return tl::unexpected<Error>(made.error());
        transport = *made;
    } else {
        return failure(ErrorCode::Usage, {Words::tr("A replay has no bytes to watch; name a gripper.")});
    }
    return std::make_shared<ListeningTransport>(std::move(transport));
}

Expected<GripperProfile> profileAt(const QString& address)
{
    const Expected<DeviceAddress> parsed = parseDeviceAddress(address);
    if (!parsed)
        return tl::unexpected<Error>(parsed.error());
    if (const auto* hid = std::get_if<HidAddress>(&*parsed); hid && isProfiled(*hid))
        return profileOf(*hid);
    if (const auto* gripper = std::get_if<VirtualAddress>(&*parsed); gripper && isProfiled(*gripper))
        return profileOf(*gripper);
    return failure(ErrorCode::NotFound,
                   {Words::tr("profile for %1: it is no gripper of another maker").arg(address)});
}

} // namespace gripscope
