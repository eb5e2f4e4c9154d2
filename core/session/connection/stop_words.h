// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>

namespace gripscope {

/// Why a gripper ended something by itself, from the status bits of its samples (StatusFault ...); empty
/// where they say nothing. A limit is told before the watchdog, which trips behind any stop.
[[nodiscard]] QString ownReason(std::uint16_t status);

/// What a person is to do about StopState::NotObeyed: said by the screen, and the reason why nothing is
/// armed.
[[nodiscard]] inline QString notObeyedWords()
{
    return Error{ErrorCode::StopNotObeyed, {}}.describe();
}

} // namespace gripscope
