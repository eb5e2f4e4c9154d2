// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/base/error.h"
#include "core/math/two_sided_interval.h"

#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// Which standard deviation the test of the bias at one reference rests on.
enum class BiasDeviation {
    Own,    ///< of the readings at that reference alone, m - 1 degrees of freedom
    Pooled, ///< within all references together, N - g: sharper, if they scatter alike
};

struct LinearityOptions {
    BiasDeviation deviation = BiasDeviation::Own;
    std::optional<double> processVariation; ///< usually 6 sigma of the process, in the unit of the values
    double confidence = 0.95;               ///< of all intervals, and 1 minus the level of all tests
    /// What values in SI are of: sentences tell them in the reader's units then, else as bare numbers.
    std::optional<MechanicalQuantity> quantity;
    [[nodiscard]] std::optional<Error> validate() const;
};

/// Of the readings at one reference, or of all.
struct ReferenceBias {
    double reference = 0; ///< of all: their mean
    std::size_t count = 0;
    double bias = 0; ///< mean of value - reference
    /// Those of the test: nothing where a reference has one reading, or only equal ones, and no other
    /// deviation stands for them.
    std::optional<double> deviation, t, p;
    std::optional<TwoSidedInterval> interval;
    double line = 0;                      ///< the regression line there
    std::optional<TwoSidedInterval> band; ///< for it, at that reference alone
    std::optional<double> percentBias;    ///< 100 |bias| / process variation
};

/// Fisher's F of a mean square over another, and its tail.
struct LinearityTest {
    double f = 0, numerator = 0, denominator = 0, p = 1;
};

struct LinearityStudy {
    std::size_t count = 0;                            ///< N
    double meanReference = 0, spreadOfReferences = 0; ///< x_mean and Sxx = sum (x - x_mean)^2
    double intercept = 0, slope = 0;
    /// Nothing of these where the readings lie on the line as far as a double can tell, or are only two.
    std::optional<double> residualDeviation; ///< sqrt(residual sum of squares / (N - 2))
    std::optional<double> tIntercept, tSlope, pIntercept, pSlope;
    std::optional<double> rSquared;         ///< nothing where all biases are the same
    std::vector<ReferenceBias> references;  ///< by size
    ReferenceBias average;                  ///< over all readings; its test by the pooled deviation
    std::optional<double> pooledDeviation;  ///< within the references
    double pooledDegrees = 0;               ///< N - g
    double percentLinearity = 0;            ///< 100 |slope|
    std::optional<double> linearity;        ///< |slope| times the process variation
    std::optional<LinearityTest> lackOfFit; ///< three references and repeated readings at least
    std::optional<LinearityTest> zeroLine;  ///< intercept and slope together are zero
    double confidence = 0.95;
    Findings messages;

    /// The regression line at a reference, and its band there.
    [[nodiscard]] double lineAt(double reference) const;
    [[nodiscard]] std::optional<TwoSidedInterval> bandAt(double reference) const;
};

/// Readings of several reference parts; `references` and `values` are as long.
///     value - reference = intercept + slope reference + error
/// by least squares over all N readings, errors independent and normal with one standard deviation s:
///     t_slope = slope / (s / sqrt(Sxx)),  t_intercept = intercept / (s sqrt(1 / N + x_mean^2 / Sxx))
///     band: line +- t s sqrt(1 / N + (x - x_mean)^2 / Sxx),  N - 2 degrees of freedom
/// (AIAG, Measurement Systems Analysis, 4th edition 2010, chapter III B). The gripper is unbiased over the
/// range where the zero line lies in the band; `zeroLine` tests that with the stated level for all of it.
/// percent_linearity is linearity = |slope| S over S, so that the process variation S cancels.
///
/// Bias at a reference: t = bias / (s_i / sqrt(m_i)), s_i the standard deviation of its own readings (AIAG's
/// and Minitab's standard deviation method), or the pooled one. Minitab's default takes range / d2* in place
/// of s_i, and so has other p (0.293 in place of 0.354 at reference 4 of AIAG's example, 0.688 in place of
/// 0.667 at 6). AIAG's example needs the own deviation: 0.10 to 0.45, so that the pooled one is wrong for
/// most of its references.
///
/// Lack of fit: (residual - pure error) / (g - 2) over pure error / (N - g) (Draper and Smith, Applied
/// Regression Analysis, 1998).
///
/// Usage for options that make no sense. BadInput for lists of different lengths, fewer than two references,
/// numbers that are not finite or too large to calculate with.
[[nodiscard]] Expected<LinearityStudy> studyLinearity(std::span<const double> references,
                                                      std::span<const double> values,
                                                      const LinearityOptions& options = {});

/// What studyLinearity() puts into `messages`.
[[nodiscard]] Findings inWords(const LinearityStudy& study, const LinearityOptions& options);

} // namespace gripscope
