// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/fact.h"

#include <vector>

class QGridLayout;

namespace gripscope {

/// Two columns, for facts.
[[nodiscard]] QGridLayout* makeFactGrid();
/// In place of what is there.
void fillFacts(QGridLayout* grid, const std::vector<Fact>& facts);

} // namespace gripscope
