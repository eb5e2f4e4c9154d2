// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope::virtual_button {

/// Presses the button of the virtual grippers in this program and lets it go a moment later; from any thread.
void press();
/// Whether it is down.
[[nodiscard]] bool down();

} // namespace gripscope::virtual_button
