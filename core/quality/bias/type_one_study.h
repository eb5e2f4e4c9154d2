// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/base/error.h"
#include "core/math/two_sided_interval.h"

#include <cstddef>
#include <optional>
#include <span>

namespace gripscope {

/// All in the unit of the values, but for shares and numbers of sigmas.
struct TypeOneOptions {
    double reference = 0;     ///< what the part is, by a better instrument
    double tolerance = 0;     ///< T, above 0: from the lower to the upper limit of the product
    double sharePercent = 20; ///< of T that the gripper may take
    double sigmas = 6;        ///< how many standard deviations are its spread
    double minimum = 1.33;    ///< of Cg and Cgk
    double confidence = 0.95; ///< of all intervals, and 1 minus the level of the test of the bias
    /// What values in SI are of: sentences tell them in the reader's units then, else as bare numbers.
    std::optional<MechanicalQuantity> quantity;
    [[nodiscard]] std::optional<Error> validate() const;
};

struct TypeOneStudy {
    std::size_t count = 0; ///< n
    double mean = 0;
    double bias = 0;          ///< mean - reference
    double repeatability = 0; ///< s, the standard deviation, with n - 1
    /// Nothing where all values are the same: what is below the resolution is not known then.
    std::optional<TwoSidedInterval> biasInterval, repeatabilityInterval;
    std::optional<double> t, p; ///< of no bias, two-sided, n - 1 degrees of freedom
    std::optional<double> cg, cgk;
    std::optional<TwoSidedInterval> cgInterval, cgkInterval;
    double variationPercent = 0; ///< sigmas s of T; share / Cg
    /// share / Cgk: the share of T whose halves hold the bias and half of the spread. Nothing where Cgk is
    /// not above 0.
    std::optional<double> biasedVariationPercent;
    double largestVariationPercent = 0; ///< what the minimum allows: share / minimum
    double leastTolerance = 0;          ///< for which Cg reaches the minimum
    double leastBiasedTolerance = 0;    ///< for which Cgk does
    std::optional<double> step;         ///< the smallest difference between two values that are not the same
    std::optional<double> stepPercent;  ///< of T
    bool biased = false;                ///< by the test, or by the reading itself where s = 0
    bool capable = false;               ///< Cg and Cgk reach the minimum, and the step is fine enough
    Findings messages;                  ///< the verdict first, then what it rests on and what to do
};

/// The largest step of the values in percent of the tolerance (Booklet 10).
inline constexpr double largestStepPercent = 5;

/// Repeated readings of one reference part, in the order of squeezing or any other:
///     Cg  = (share / 100) T / (sigmas s)
///     Cgk = ((share / 200) T - |bias|) / (sigmas s / 2)
/// which with 20 % and 6 are 0.2 T / (6 s) and (0.1 T - |bias|) / (3 s), to be 1.33 at least, from 50
/// readings, 25 at least (Robert Bosch GmbH, Quality Management, Booklet 10: Capability of Measurement and
/// Test Processes). bias: mean +- t s / sqrt(n); the intervals of s and Cg by chi-square, that of Cgk as
/// biasedCapabilityInterval(). Assumes independent normal readings. Usage for options that make no sense,
/// BadInput for fewer than two readings, or some that are not finite or too far apart for a double.
[[nodiscard]] Expected<TypeOneStudy> studyTypeOne(std::span<const double> readings,
                                                  const TypeOneOptions& options);

/// Confidence limits of a standard deviation, and of an index that has it below, from n normal values:
/// (n - 1) s^2 / sigma^2 is chi-square with n - 1 degrees of freedom.
///     sigma: s sqrt((n - 1) / chi^2_upper) to s sqrt((n - 1) / chi^2_lower)
///     Cg:    Cg sqrt(chi^2_lower / (n - 1)) to Cg sqrt(chi^2_upper / (n - 1))
/// Nothing for fewer than two values, or a value or deviation that is not finite.
[[nodiscard]] std::optional<TwoSidedInterval> deviationInterval(double deviation, std::size_t count,
                                                                double confidence);
[[nodiscard]] std::optional<TwoSidedInterval> capabilityInterval(double cg, std::size_t count,
                                                                 double confidence);

/// Confidence limits of Cgk = (a - |bias|) / (h sigma), h = sigmas / 2: sqrt(n) h Cgk as it is found is
/// Student's t with n - 1 degrees of freedom and the shift sqrt(n) h Cgk as it is (Chou, Owen and Borrego,
/// Lower confidence limits on process capability indices, Journal of Quality Technology 22, 1990; here both
/// limits, and Cgk may be negative). Exact where the sign of the bias is certain. Where it is not, |bias|
/// makes the index as it is found too small: the lower limit then holds more often than stated, the upper
/// one less often. With 95 % stated, 93 to 96 % hold in simulation for 5 to 50 values.
[[nodiscard]] std::optional<TwoSidedInterval> biasedCapabilityInterval(double cgk, double sigmas,
                                                                       std::size_t count, double confidence);

/// What studyTypeOne() puts into `messages`.
[[nodiscard]] Findings inWords(const TypeOneStudy& study, const TypeOneOptions& options);

} // namespace gripscope
