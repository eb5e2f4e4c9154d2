// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/profile/profile_codec.h"

#include <string_view>

namespace gripscope {

/// How the note begins by which a capture keeps the profile that its gripper was read by.
inline constexpr std::string_view profileNote = "profile\n";

/// `profile`, the serial number, and the profile's JSON.
[[nodiscard]] QString toNote(const ProfiledDevice& device);
/// Nothing for a note of another kind, or one that is damaged.
[[nodiscard]] std::optional<ProfiledDevice> profiledDeviceOf(const QString& note);

} // namespace gripscope
