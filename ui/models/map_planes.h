// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene/axis_scale.h"

#include <Eigen/Core>
#include <QString>

#include <vector>

namespace gripscope {

struct SpaceClustering;
struct TypeSpace;

/// One number for every unit of a self-organizing map, as a picture of its grid.
struct MapPlane {
    QString title;          ///< "Mass m"
    QString meaning;        ///< what it shows, in a sentence
    AxisScale scale;        ///< unit and digits; low and high are the extremes of `values`
    Eigen::MatrixXd values; ///< rows x columns of the grid
};

/// The map as pictures side by side: the U-matrix, then the component planes of m, b and k.
struct MapPlanes {
    int rows = 0, columns = 0;
    std::vector<MapPlane> planes;
    std::vector<int> hits;         ///< squeezes a unit; unit of row r and column c: r * columns + c
    std::vector<int> groups;       ///< cluster of each unit, from 0
    std::vector<QString> squeezes; ///< who is in a unit, in words: "3 squeezes: 2 of A, 1 of B"

    /// A unit in words: its number in that plane, who is there, where it is.
    [[nodiscard]] QString describe(int unit, int plane) const;
};

/// Empty where the clustering is not a map's.
[[nodiscard]] MapPlanes mapPlanes(const TypeSpace& space, const SpaceClustering& clustering);

} // namespace gripscope
