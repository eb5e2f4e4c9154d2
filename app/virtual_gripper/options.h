// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/address/device_address.h"

#include <QStringList>

namespace gripscope {

struct VirtualGripperOptions {
    std::vector<VirtualAddress> grippers; ///< at least one, no two with the same serial number
    bool help = false;
};

/// Usage, or what is wrong with a script.
[[nodiscard]] Expected<VirtualGripperOptions> parseVirtualGripperOptions(const QStringList& arguments);
[[nodiscard]] QString virtualGripperHelp();

} // namespace gripscope
