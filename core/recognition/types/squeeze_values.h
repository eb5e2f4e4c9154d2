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

using QuantitySet = unsigned; ///< bit i: the i-th of allQuantities
[[nodiscard]] QuantitySet setOf(const QuantitySpace& space);
[[nodiscard]] QuantitySpace spaceFrom(QuantitySet set);

/// What a squeeze's `determined` has, and what its m, b and k tell: the two are not mixed.
using Determines = std::pair<QuantitySet, QuantitySet>;
[[nodiscard]] Determines determinedBy(const TypeSqueeze& squeeze);

/// The squeeze's logarithms in a space: of `determined` where that has every quantity, finite, else of m, b,
/// k where these do. The two are not mixed, since how they vary together is not known. Nothing where neither
/// does, or for a space of none.
[[nodiscard]] std::optional<LogVector> coordinatesOf(const TypeSqueeze& squeeze, const QuantitySpace& space);

/// As many quantities of the space as the squeeze has coordinates in together; none where it has none.
[[nodiscard]] QuantitySpace determinedPart(const TypeSqueeze& squeeze, const QuantitySpace& space);

/// The covariance of these; nothing where it is not known or none.
[[nodiscard]] std::optional<LogMatrix> noiseOf(const TypeSqueeze& squeeze, const QuantitySpace& space);

/// A squeeze that has these logarithms in this space, and their covariance where it is known.
[[nodiscard]] TypeSqueeze squeezeAt(QString type, const QuantitySpace& space, const LogVector& log,
                                    const std::optional<LogMatrix>& covariance = {});

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

/// A squeeze of the type: `linear`, its m, b and k, where they were found, and what it determines besides
/// them or in their place. Where that lacks one of them, they do not count together any more. Nothing where
/// neither is there.
[[nodiscard]] std::optional<TypeSqueeze> foundSqueeze(const QString& type, std::optional<TypeSqueeze> linear,
                                                      std::optional<DeterminedQuantities> determined);

} // namespace gripscope
