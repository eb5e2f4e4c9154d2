// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace gripscope {

class DeviceLink;

/// The links of this program that are open, for who must stop them all without knowing them. From any thread.
void addOpenLink(const std::shared_ptr<DeviceLink>& link);
void stopOpenLinks() noexcept;

} // namespace gripscope
