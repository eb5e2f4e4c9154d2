// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/device_address.h"
#include "devices/profile/profile_codec.h"
#include "devices/profile/profile_library.h"
#include "devices/transport/report_decoder.h"

namespace gripscope {

/// What carries the bytes of a gripper that is known by a profile, and how they are read. Nothing is read
/// from the disk before the transport opens.
struct ProfiledDeviceMakers {
    TransportMaker transport;
    DecoderMaker decoder;
};

/// Nothing for a gripper that speaks Gripscope's own protocol.
[[nodiscard]] std::optional<ProfiledDeviceMakers> profiledDevice(const VirtualAddress& address);
[[nodiscard]] std::optional<ProfiledDeviceMakers> profiledDevice(const HidAddress& address);

/// A transport for reading the bytes at a `virtual:` or `hid:` address as they are, whatever they mean and
/// whether or not there is a profile. Nothing can be written to it.
[[nodiscard]] Expected<std::shared_ptr<Transport>> listenAt(const QString& address);

/// The profile that a connection to this address would use: the one it names, or the one of its USB numbers.
/// Reads files; a virtual gripper has the USB numbers of what it sends.
[[nodiscard]] Expected<GripperProfile> profileAt(const QString& address);

} // namespace gripscope
