// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/binomial_evidence.h"
#include "core/recognition/verdict/verdict.h"

#include <Eigen/Core>
#include <QStringList>

#include <vector>

namespace gripscope {

/// What the enrolled squeezes are called when each is judged by models that do not know it, in
/// spaceOf(squeezes).
///
/// Squeezes of one part are left out together, and a part counts once in the bounds, wrong when any of its
/// squeezes is: squeezes of one part are not independent. Up to 400 parts are left out one at a time; of a
/// larger library one part of every type at a time, 50 at the most of each. A type with a single part is not
/// tested.
struct HeldOutConfusion {
    QStringList types; ///< sorted
    /// Squeezes of type i that were called type j; then two columns: unknown, and inconclusive.
    Eigen::MatrixXi counts;
    int squeezes = 0, parts = 0, untested = 0;
    BinomialEvidence wrongType;                ///< parts that were called another type
    BinomialEvidence unknown;                  ///< parts that were called unknown: false rejects
    std::vector<BinomialEvidence> wrongTypeOf; ///< the same for each type
};
[[nodiscard]] HeldOutConfusion heldOutConfusion(const std::vector<TypeSqueeze>& squeezes,
                                                const VerdictOptions& options = {});

} // namespace gripscope
