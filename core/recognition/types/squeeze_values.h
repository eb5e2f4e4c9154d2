// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/recognition/types/type_model.h"

#include <utility>

namespace gripscope {

// A squeeze as recognition takes it: what was found, in the units of the types, and in logarithms.

/// All positive and finite: what has logarithms.
[[nodiscard]] inline bool isUsable(const MassDampingStiffness& p)
{
    const Eigen::Vector3d values = p.vector();
    return values.allFinite() && values.minCoeff() > 0;
}

/// Of usable parameters.
[[nodiscard]] inline Eigen::Vector3d logOf(const MassDampingStiffness& p)
{
    return p.vector().array().log();
}

/// The squeeze's own covariance in logarithms; nothing where it is not known or none.
[[nodiscard]] inline std::optional<Eigen::Matrix3d> noiseOf(const TypeSqueeze& squeeze)
{
    return squeeze.covariance ? logCovariance(squeeze.parameters, *squeeze.covariance) : std::nullopt;
}

/// m, b, k and their covariance times `factor`, siFactor() of the channels' units for one.
[[nodiscard]] inline TypeSqueeze scaledSqueeze(QString type, const MassDampingStiffness& p,
                                               const std::optional<Eigen::Matrix3d>& covariance,
                                               double factor)
{
    TypeSqueeze squeeze{std::move(type), {p.m * factor, p.b * factor, p.k * factor}};
    if (covariance)
        squeeze.covariance = factor * *covariance * factor;
    return squeeze;
}

/// The same of what an identification found of the object; a covariance of zeros is not known.
[[nodiscard]] inline TypeSqueeze scaledSqueeze(QString type, const CorrectedParameters& object, double factor)
{
    const bool isKnown = !object.covariance.isZero(0);
    return scaledSqueeze(std::move(type), object.parameters,
                         isKnown ? std::optional(object.covariance) : std::nullopt, factor);
}

} // namespace gripscope
