// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_library.h"

#include <hidapi/hidapi.h>

namespace gripscope {

QString hidapiVersion()
{
    return QString::fromLatin1(hid_version_str());
}

} // namespace gripscope
