// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QString>

namespace gripscope {

/// What a test on the residuals found, in words with its number: "white, p = 0.31".
struct ResidualFinding {
    QString words;         ///< empty: nothing was tested
    bool doubtful = false; ///< rejected, and the checks on the measurement do not let it pass
};
struct ResidualFindings {
    ResidualFinding whiteness;         ///< Ljung-Box
    ResidualFinding inputIndependence; ///< F test of past and present force
};

/// Worded for `estimate` (null: nothing), at the level that the validity checks of the identification use;
/// without such a check at 0.5 %. The plots never say otherwise than the checks: what these let pass for the
/// recommended estimate (too small to matter, or in the noise model) is named but not marked.
[[nodiscard]] ResidualFindings residualFindings(const Identification& identification,
                                                const Estimate* estimate);

/// "p = 0.31", "p = 0.013", "p < 0.001": two digits are all that a p-value can carry.
[[nodiscard]] QString pValueText(double p);

} // namespace gripscope
