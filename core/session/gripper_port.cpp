// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/gripper_port.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(LinkState state)
{
    switch (state) {
    case LinkState::Closed:
        return u"closed"_qs;
    case LinkState::Opening:
        return u"opening"_qs;
    case LinkState::Ready:
        return u"ready"_qs;
    case LinkState::Armed:
        return u"armed"_qs;
    case LinkState::Lost:
        return u"lost"_qs;
    case LinkState::Closing:
        return u"closing"_qs;
    }
    return {};
}

} // namespace gripscope
