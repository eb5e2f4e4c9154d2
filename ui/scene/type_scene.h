// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/type_space.h"
#include "ui/scene/scene_content.h"

#include <vector>

namespace gripscope {

/// Which types are shown; one flag a type.
using TypeVisibility = std::vector<bool>;

/// The types with their ellipsoids, and the squeeze at hand. The axes hold all types, shown or not, so that
/// hiding one moves nothing.
[[nodiscard]] SceneContent typeScene(const TypeSpace& space, const TypeVisibility& visible,
                                     const std::optional<SceneHighlight>& highlight);

/// The squeezes coloured by the cluster they belong to after `step` iterations (shape: their type), the
/// centroids with the way they came.
[[nodiscard]] SceneContent clusterScene(const TypeSpace& space, const TypeVisibility& visible,
                                        const SpaceClustering& clustering, int step);

/// m, b and k in words: "m 39.6 g, b 43.0 N s/m, k 9.99 kN/m".
[[nodiscard]] QString parametersText(const MassDampingStiffness& parameters, const ParameterUnits& units);

} // namespace gripscope
