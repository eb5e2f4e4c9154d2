// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// Quantities that types can be told apart by, and so the most coordinates of a space.
inline constexpr int mostDimensions = 6;

/// Logarithms of the p quantities of a space, and their covariance: p and p x p, without memory of their own.
using LogVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostDimensions, 1>;
using LogMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostDimensions, mostDimensions>;

/// Mass m, damping b, stiffness k, relaxing share k1/k (the part of the stiffness that relaxes, over the
/// rest), its relaxation time tau in seconds, Coulomb friction Fc. The first three in the order of
/// MechanicalQuantity.
enum class TypeQuantity { Mass, Damping, Stiffness, RelaxingShare, RelaxationTime, Friction };
inline constexpr TypeQuantity allQuantities[mostDimensions] = {
    TypeQuantity::Mass,          TypeQuantity::Damping,        TypeQuantity::Stiffness,
    TypeQuantity::RelaxingShare, TypeQuantity::RelaxationTime, TypeQuantity::Friction};

/// "m", "b", "k", "k1/k", "tau", "Fc".
[[nodiscard]] QString symbolOf(TypeQuantity quantity);

/// Which quantities the coordinates of a space of logarithms are, in order; each once. Empty: none.
struct QuantitySpace {
    std::vector<TypeQuantity> quantities{TypeQuantity::Mass, TypeQuantity::Damping, TypeQuantity::Stiffness};

    [[nodiscard]] int dimensions() const { return int(quantities.size()); } ///< p
    [[nodiscard]] std::optional<int> placeOf(TypeQuantity quantity) const;
    /// Each quantity of the other is one of these.
    [[nodiscard]] bool contains(const QuantitySpace& other) const;
    friend bool operator==(const QuantitySpace&, const QuantitySpace&) = default;
};

/// "m+b+k", "k+k1/k+tau"
[[nodiscard]] QString toString(const QuantitySpace& space);
/// Nothing where a symbol is none of these, or comes twice.
[[nodiscard]] std::optional<QuantitySpace> quantitySpaceFromString(const QString& text);

} // namespace gripscope
