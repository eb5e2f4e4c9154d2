// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope {

/// Whether verdicts are heard; on until somebody switches it off.
[[nodiscard]] bool soundIsOn();
void setSoundOn(bool on);

} // namespace gripscope
