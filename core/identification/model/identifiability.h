// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/words.h"
#include "core/identification/model/estimate.h"

namespace gripscope {

// What the estimators of m, b and k in continuous time agree on: when data determines them, and the words for
// when not.

/// Above this condition number of the scaled columns, rounding decides what m, b and k are.
inline constexpr double largestCondition = 1e8;
/// A force whose response differs this little from what a free start and offset can imitate says nothing.
inline constexpr double smallestOwnShare = 1e-9;
/// A solution that leaves more than this share of the position's energy unexplained (a fit below 50 %) is not
/// trusted before others have been tried.
inline constexpr double poorShare = 0.25;

inline constexpr const char* constantForce =
    QT_TRANSLATE_NOOP("Words", "a constant force does not determine m, b and k together with a "
                               "free start and offset; squeeze with a force that "
                               "varies, for instance a pseudo-random binary sequence");
inline constexpr const char* constantPosition = QT_TRANSLATE_NOOP(
    "Words",
    "the position does not change; check that the fingers hold the object and that the sensor works");
inline constexpr const char* poorForce =
    QT_TRANSLATE_NOOP("Words", "this force does not determine m, b and k; squeeze with a richer one");
inline constexpr const char* noAnswer = QT_TRANSLATE_NOOP(
    "Words", "the position does not answer the force; check the grip and which column is which");

/// m, b or k (0, 1, 2) has its best value at zero or at infinity.
[[nodiscard]] Finding boundaryMessage(int parameter, bool atZero);

/// No numbers but a status, and why.
[[nodiscard]] Estimate statusOnly(Estimator estimator, EstimateStatus status, Finding message);

/// Residuals below this share of the position's size are rounding, which no test and no comparison of fits
/// speaks about.
inline constexpr double roundingShare = 1e-9;

} // namespace gripscope
