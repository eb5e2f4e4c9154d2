// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"

namespace gripscope {

/// A gripper that is looked out for: one that was lost, or one that could not be opened.
struct AwaitedGripper {
    QString address;          ///< as the person gave it
    GripperIdentity identity; ///< of the one that was lost; without a name: none was connected yet
    int timesLost = 0;        ///< since the person connected
    bool worthATry = true;    ///< as it stands; false: it opened twice and sent nothing, so plug it in anew
};

/// Looks out for one gripper. Belongs to one thread; whatever waits for the system's events is behind it.
class GripperReturn {
public:
    virtual ~GripperReturn() = default;
    /// A port to it, to be opened, as soon as there is something to open that has not been tried; null until
    /// then. Returns at once. One that does not open is no end: it goes on looking.
    [[nodiscard]] virtual std::unique_ptr<GripperPort> take() = 0;
};

} // namespace gripscope
