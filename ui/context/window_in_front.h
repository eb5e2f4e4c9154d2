// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace gripscope {

/// What a question to the person who works here is shown over; none where no window is shown.
[[nodiscard]] QWidget* windowInFront();

} // namespace gripscope
