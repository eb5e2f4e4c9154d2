// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_items.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace gripscope {

/// Where Lloyd's iteration stands still, J may still fall when a single item changes its cluster, because
/// both means move with it: from cluster a to b when
///     n_b / (n_b + 1) |x - c_b|^2 < n_a / (n_a - 1) |x - c_a|^2 .
/// Passes over the items make such moves until none is left. The means afterwards, or nothing when there was
/// no move. `items`: finite, of a size whose squares neither vanish nor overflow; `labels` from 0, below
/// `clusters`.
/// Source: Hartigan, Clustering Algorithms (1975); Telgarsky and Vattani, Hartigan's method (2010), who show
/// that where it stands still Lloyd's iteration does too.
[[nodiscard]] std::optional<Eigen::MatrixXd> meansAfterSingleMoves(const ItemRows& items,
                                                                   std::vector<int> labels, int clusters);

} // namespace gripscope
