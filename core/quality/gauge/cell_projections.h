// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/gauge/source_sums.h"

namespace gripscope {

/// More combinations than this take minutes where they are not balanced.
inline constexpr std::size_t mostUnbalancedCells = 1000;

/// A table by its combinations of factors: all that a likelihood or a projection needs.
struct CellTable {
    Eigen::VectorXd count;                 ///< rows in each
    Eigen::MatrixXd mean;                  ///< cells x values
    Eigen::MatrixXd within;                ///< sums of squares and products within cells
    double withinDegrees = 0;              ///< rows - cells
    std::vector<std::vector<int>> levelOf; ///< of each term: the level of each cell
};

/// `centred` as in sourceSums(), a row each of the layout's.
[[nodiscard]] CellTable cellTable(const GaugeLayout& layout, const Eigen::MatrixXd& centred);

/// The sums of an unbalanced table, each term given those that do not contain it, by orthogonal projections
/// of the cells' means weighted with their counts. A term that is determined by the others has 0 degrees of
/// freedom. BadInput for more than mostUnbalancedCells.
[[nodiscard]] std::optional<Error> projectedSums(const GaugeLayout& layout, const Eigen::MatrixXd& centred,
                                                 SourceSums& sums);

} // namespace gripscope
