// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

class Workbench;

/// What the Inspect page says where there is no verdict: a headline, and what to do.
struct InspectHint {
    QString headline, words;
};
/// `time`: how long a squeeze takes, in words.
[[nodiscard]] InspectHint inspectHint(Workbench& workbench, const QString& time);

/// A code or name that no type has; `expected` stays what it was.
[[nodiscard]] InspectHint unknownCodeHint(const QString& code, const QString& expected);
[[nodiscard]] InspectHint expectedHint(const QString& expected);
/// The gripper's own button was pressed, and nothing may be squeezed.
[[nodiscard]] InspectHint buttonHint();

} // namespace gripscope
