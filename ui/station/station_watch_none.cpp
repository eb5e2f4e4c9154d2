// SPDX-License-Identifier: GPL-3.0-or-later
// Where nothing is known of the desktop.
#include "ui/station/station_watch.h"

namespace gripscope {

std::unique_ptr<StationWatch> makeStationWatch()
{
    return std::make_unique<StationWatch>();
}

} // namespace gripscope
