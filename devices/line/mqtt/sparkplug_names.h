// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Words of the specification.
namespace gripscope::sparkplug_name {

inline constexpr const char* birthDeath = "bdSeq";
inline constexpr const char* rebirth = "Node Control/Rebirth";
inline constexpr const char* space = "spBv1.0";

} // namespace gripscope::sparkplug_name
