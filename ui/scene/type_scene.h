// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/space_clustering.h"
#include "ui/models/type_space.h"
#include "ui/scene/scene_content.h"

#include <vector>

namespace gripscope {

/// Which types are shown; one flag a type.
using TypeVisibility = std::vector<bool>;

/// The types with their ellipsoids, the error of each squeeze (of up to 500 that have one), and the squeeze
/// at hand. The axes hold all types, shown or not, so that
/// hiding one moves nothing.
[[nodiscard]] SceneContent typeScene(const TypeSpace& space, const TypeVisibility& visible,
                                     const std::optional<SceneHighlight>& highlight);

/// The squeezes coloured by the cluster they belong to in that state (shape: their type), and how the method
/// stands: centres with the way they came, ellipsoids of a mixture's components, the net of a map.
[[nodiscard]] SceneContent clusterScene(const TypeSpace& space, const TypeVisibility& visible,
                                        const SpaceClustering& clustering, int state);

/// Who it is: "Cola, squeeze 3".
[[nodiscard]] QString squeezeName(const TypeSpace& space, const SpaceSqueeze& squeeze);

/// m, b and k in words: "m 39.6 g, b 43.0 N s/m, k 9.99 kN/m"; with their 95 % intervals when their
/// covariance is given: "m 39.6 ± 0.3 g".
[[nodiscard]] QString parametersText(const MassDampingStiffness& parameters, const ParameterUnits& units,
                                     const std::optional<Eigen::Matrix3d>& covariance = std::nullopt);

} // namespace gripscope
