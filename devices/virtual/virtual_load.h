// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gripscope::virtual_load {

/// A part leans on the force sensors of the virtual grippers in this program with so many newtons, from now
/// on; 0: none does. From any thread.
void set(double load_N);
[[nodiscard]] double load_N();

} // namespace gripscope::virtual_load
