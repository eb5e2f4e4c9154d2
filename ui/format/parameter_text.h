// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/format/number_format.h"

#include <QString>

#include <vector>

namespace gripscope {

/// m, b and k of an estimate for the screen, in SI where the channels' units allow it, with the half widths
/// of their 95 % intervals.
struct ParameterTexts {
    FormattedNumber m, b, k;
};
/// With the intervals of the uncertainty budget, which count all that is uncertain; without a budget, those
/// of the recommended estimate's noise.
[[nodiscard]] ParameterTexts parameterTexts(const Identification& identification, const QString& forceUnit,
                                            const QString& positionUnit);
[[nodiscard]] ParameterTexts parameterTexts(const Estimate& estimate, const QString& forceUnit,
                                            const QString& positionUnit);
/// The same from the numbers alone; `standardErrors` may be absent.
[[nodiscard]] ParameterTexts parameterTexts(const MassDampingStiffness& parameters,
                                            const std::optional<Eigen::Vector3d>& standardErrors,
                                            const QString& forceUnit, const QString& positionUnit);
/// The same from half widths that the caller knows.
[[nodiscard]] ParameterTexts parameterTextsWithin(const MassDampingStiffness& parameters,
                                                  const std::optional<Eigen::Vector3d>& halfWidths,
                                                  const QString& forceUnit, const QString& positionUnit);

/// A number of an identification for a paper: m, b, k, what else was determined, or what follows from them.
struct ReportedResult {
    QString name;   ///< in English: "mass"
    QString symbol; ///< "m"
    QString latex;  ///< the symbol in mathematics: "f_0"
    double value = 0;
    double lower = 0, upper = 0; ///< of the 95 % interval; equal to the value without one
    bool onlyUpperBound = false;
    bool onlyLowerBound = false; ///< at least `value`
    QString unit;                ///< SI where the channels allow it; "1" for a bare number
};

/// Of the recommended estimate, with the intervals of the uncertainty budget where there is one, which are
/// those on the screen; empty without an estimate.
[[nodiscard]] std::vector<ReportedResult>
reportedResults(const Identification& identification, const QString& forceUnit, const QString& positionUnit);

/// A line each: "m = 39.60 ± 0.32 g". Rounded by roundedForReport(), decimal mark and minus of the language;
/// an interval that is askew by more than a tenth of its half width is written out. The first line says that
/// they are of 95 %, and what of, the last whether the measurement is valid.
[[nodiscard]] QString resultsAsText(const Identification& identification, const QString& title,
                                    const QString& forceUnit, const QString& positionUnit);
/// The same for LaTeX without packages: "$m = (39.60 \pm 0.32)\,\mathrm{g}$", the rest in comments.
[[nodiscard]] QString resultsAsLatex(const Identification& identification, const QString& title,
                                     const QString& forceUnit, const QString& positionUnit);
/// A table (RFC 4180, decimal points) with all digits: quantity, value, half_width_95, lower_95, upper_95,
/// unit, validity. Cells without a number are empty; of a bound there is `value`, empty, and the bound.
[[nodiscard]] QString resultsAsCsv(const Identification& identification, const QString& forceUnit,
                                   const QString& positionUnit);

} // namespace gripscope
