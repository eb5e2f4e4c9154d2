// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace gripscope {

class TourScript;
class Workbench;

/// Brings the Inspect page to a telling state: parts as expected, another type, a stranger. `expect` and
/// `squeeze` are what a person does on the page.
void addInspections(TourScript& tour, Workbench& workbench, const std::function<void()>& expect,
                    const std::function<void()>& squeeze);

} // namespace gripscope
