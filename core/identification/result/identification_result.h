// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_watch.h"
#include "core/identification/comparison/hold_evidence.h"
#include "core/identification/comparison/model_comparison.h"
#include "core/identification/model/estimate.h"
#include "core/identification/periodic/periodic.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/identification/validation/validation.h"
#include "core/signal/preparation/preparation.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

/// About the measurement, never about the part.
enum class ValidityVerdict { Valid, Suspect, Invalid };
[[nodiscard]] QString toString(ValidityVerdict verdict);
[[nodiscard]] std::optional<ValidityVerdict> validityVerdictFromString(const QString& text);

/// One check: `id` is one of the contract's (samples_lost, saturation, excitation, residual_whiteness,
/// input_independence, hold, convergence, physical_range, fit, calibration), or `stuck`, `device_fault`,
/// `clock`, `sample_time`, `linearity`, `feedback`, `preparation`, `position_held`, `relaxation`.
struct ValidityCheck {
    QString id;
    bool ok = true;
    bool decisive = false; ///< failing it makes the measurement invalid, not only suspect
    std::optional<double> value, limit;
    Finding message; ///< what was found and, when it failed, what to do
    /// It did not fail, which is all: there was nothing to judge it by, or what was found is only made up
    /// for.
    bool noted = false;
};

struct Validity {
    ValidityVerdict verdict = ValidityVerdict::Valid;
    std::vector<ValidityCheck> checks;
};

/// Invalid when a decisive check failed, suspect when another one did.
[[nodiscard]] ValidityVerdict overallVerdict(const std::vector<ValidityCheck>& checks);

/// What goes with every verdict on a part: what its measurement is worth.
struct ValiditySummary {
    ValidityVerdict verdict = ValidityVerdict::Valid;
    QStringList checksFailed; ///< their ids, in the order of the checks
    /// Whole sentences, why and what to do: of the checks that make it what it is. Those that only follow
    /// from another (a stuck channel leaves nothing to find) are left out.
    Findings reasons;
};
[[nodiscard]] ValiditySummary summaryOf(const Validity& validity);

enum class InitialState { Free, Rest };

struct IdentificationOptions {
    std::vector<Estimator> estimators = {Estimator::Arx, Estimator::OutputError};
    std::optional<ForceHold> hold; ///< empty: the recording's, else first-order
    InitialState initialState = InitialState::Free;
    bool freeOffset = true; ///< a position offset (OE) or a constant column (ARX)
    bool assess = true;     ///< budget, comparison of models and validation, too: about as much work again
    /// What earlier squeezes of the same device say about the hold. It counts where they declared the same
    /// hold and lag.
    HoldEvidence earlierHold = {};
    /// Told how far it is; may stop it: the result then lacks what was not begun, and is not to be used.
    std::shared_ptr<WorkWatch> watch = {};
};

/// All that was found out about one recording.
struct Identification {
    WindowChoice choice;
    ForceHold hold = ForceHold::First;
    double sampleTime_s = 0;
    std::vector<Estimate> estimates; ///< in the order asked for
    Estimator recommended = Estimator::OutputError;
    Validity validity;
    /// What output error says about the force hold: this squeeze alone, and with the earlier ones.
    HoldEvidence holdEvidence, summedHold;
    UncertaintyBudget budget;   ///< of the recommended estimate: the intervals to be shown
    ModelComparison comparison; ///< of output error with other models
    /// The recommended estimator on the first part of the record, held against the rest.
    Validation validation;
    /// What the periods of a repeating force tell; where `periodic` was asked for and found parameters.
    std::optional<PeriodicDiagnostics> repetition;
    std::vector<PreparationStep> preparation; ///< what was done to the recording before, and noticed
    std::optional<GripperBaseline> baseline;  ///< the recording's: what the empty gripper alone is
    /// The window that was used, on a regular grid; at the indexes `lost` nothing was measured and the values
    /// are for plots only.
    std::vector<double> time_s, force, position;
    std::vector<std::size_t> lost;

    /// The recommended estimate, or null when there is none with parameters.
    [[nodiscard]] const Estimate* best() const;
    [[nodiscard]] const Estimate* find(Estimator estimator) const;
    /// What check and budget go by: the sum, or this squeeze where it alone contradicts the declared hold.
    [[nodiscard]] const HoldEvidence& tellingHold() const;
    /// The recommended estimate of the object alone, the empty gripper taken off where its m, b, k are known:
    /// what is shown, enrolled and judged. A covariance of zero: the estimate has none. Nothing without an
    /// estimate, or when the object is not told from the empty gripper.
    [[nodiscard]] std::optional<CorrectedParameters> object() const;
};

} // namespace gripscope
