// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profiled_device.h"

#include "core/base/words.h"
#include "devices/hid/hid_transport.h"
#include "devices/profile/virtual_robot_transport.h"
#include "devices/transport/transport.h"
#include "devices/virtual/virtual_transport.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Another transport, of which only the reading end is let through: whatever is asked of this one, nothing
/// goes to the device. For grippers that are known by a profile, which would not understand what is written
/// and might move.
class ListeningTransport : public Transport {
public:
    explicit ListeningTransport(std::shared_ptr<Transport> inner) : m_inner(std::move(inner)) {}

    Expected<void> open() override { return m_inner->open(); }
    Expected<protocol::Report> feature(protocol::ReportId) override
    {
        return failure(ErrorCode::DeviceRefused,
                       {Words::tr("be asked"), Words::tr("it is known by a profile, and only "
                                                         "listened to")});
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        return m_inner->read(buffer, timeout);
    }
    bool write(const protocol::Report&) override { return false; }
    void close() noexcept override { m_inner->close(); }
    [[nodiscard]] Place place() const override { return m_inner->place(); }
    [[nodiscard]] bool streamsAlways() const override { return m_inner->streamsAlways(); }
    [[nodiscard]] bool keepsComputerTime() const override { return m_inner->keepsComputerTime(); }
    [[nodiscard]] bool takesCommands() const override { return false; }

private:
    const std::shared_ptr<Transport> m_inner;
};

} // namespace

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
    ASSIGN_OR_RETURN(const DeviceAddress parsed, parseDeviceAddress(address));
    std::shared_ptr<Transport> transport;
    if (const auto* hid = std::get_if<HidAddress>(&parsed)) {
        transport = std::make_shared<HidTransport>(*hid);
    } else if (const auto* gripper = std::get_if<VirtualAddress>(&parsed); gripper && isProfiled(*gripper)) {
        transport = robotAt(*gripper);
    } else if (gripper) {
        ASSIGN_OR_RETURN(const std::shared_ptr<VirtualTransport> made, VirtualTransport::make(*gripper));
        transport = made;
    } else {
        return failure(ErrorCode::Usage, {Words::tr("A replay has no bytes to watch; name a gripper.")});
    }
    return std::make_shared<ListeningTransport>(std::move(transport));
}

Expected<GripperProfile> profileAt(const QString& address)
{
    ASSIGN_OR_RETURN(const DeviceAddress parsed, parseDeviceAddress(address));
    if (const auto* hid = std::get_if<HidAddress>(&parsed); hid && isProfiled(*hid))
        return profileOf(*hid);
    if (const auto* gripper = std::get_if<VirtualAddress>(&parsed); gripper && isProfiled(*gripper))
        return profileOf(*gripper);
    return failure(ErrorCode::NotFound,
                   {Words::tr("profile for %1: it is no gripper of another maker").arg(address)});
}

} // namespace gripscope
