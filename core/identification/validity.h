// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// About the measurement, never about the part.
enum class ValidityVerdict { Valid, Suspect, Invalid };
[[nodiscard]] QString toString(ValidityVerdict verdict);

/// One check: `id` is one of the contract's (samples_lost, saturation, excitation, residual_whiteness,
/// input_independence, hold, convergence, physical_range, fit, calibration), `linearity` or `feedback`.
struct ValidityCheck {
    QString id;
    bool ok = true;
    bool decisive = false; ///< failing it makes the measurement invalid, not only suspect
    std::optional<double> value, limit;
    QString message; ///< what was found and, when it failed, what to do
};

struct Validity {
    ValidityVerdict verdict = ValidityVerdict::Valid;
    std::vector<ValidityCheck> checks;
};

/// Invalid when a decisive check failed, suspect when another one did.
[[nodiscard]] ValidityVerdict overallVerdict(const std::vector<ValidityCheck>& checks);

} // namespace gripscope
