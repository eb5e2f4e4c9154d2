// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/model/estimate.h"
#include "core/signal/preparation/preparation.h"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// Where the motion is from that an estimate is held against.
enum class ValidationSource { SecondWindow, OtherRecording };
[[nodiscard]] QString toString(ValidationSource source); ///< "second_window", "other_recording"

/// What of the measured motion the parameters of another record explain. The names of the fits are those of
/// Fit; the prediction is one step ahead with the noise model found here, equal to the simulation where the
/// noise is white.
struct Validation {
    ValidationSource source = ValidationSource::SecondWindow;
    QString name;    ///< of the other recording
    Finding message; ///< what came of it, or why nothing did; a sentence
    /// The misfit is one that noise and the estimate's own covariance explain. Absent: not judged.
    std::optional<bool> asExpected;
    Estimator estimator = Estimator::OutputError;
    MassDampingStiffness parameters; ///< as they were found elsewhere
    std::optional<double> k3;
    Window estimatedOn; ///< samples of the record that the estimate is from
    Window validatedOn; ///< samples of the record it was held against
    Fit fit;
    /// The simulation fit to be expected: noise as large as here, and parameters wrong by as much as their
    /// covariance says.
    std::optional<double> expectedPercent;
    /// Ljung-Box on the residuals and the F test of past and present force on them; what the parameters'
    /// errors contribute is scaled to the size of the noise, so that both are uniform when all is well.
    std::optional<double> whitenessP, inputIndependenceP;
    /// The F test of the directions in which m, b, k (and k3) move the response: p-value and root of F.
    std::optional<double> misfitP, misfit;
    /// By what share m, b, k would have to change to explain this record best (linearised), and the standard
    /// errors to be expected of that, from both records. Absent where the record does not tell.
    std::optional<Eigen::Vector3d> change, changeErrors;
    Nuisance nuisance; ///< fitted anew
    /// The record it was held against, and the model there; empty when it could not be simulated.
    std::vector<double> time_s, force, position, simulated, residual;

    [[nodiscard]] bool available() const { return !simulated.empty(); }
};

/// Each of the two tests that `asExpected` rests on rejects below this: together one validation in a hundred
/// fails by chance.
inline constexpr double validationLimit = 0.005;

/// Holds m, b, k (and k3) of `estimate` against a record it was not found from. Start and offset belong to a
/// record and are fitted anew; nothing else is. With S the derivatives of the response to the parameters
/// (start and offset projected out), P the estimate's covariance and e the noise of this record, the residual
/// is S (truth - estimate) + e, so that its coordinates z in the span of S have the covariance
///     V = A'P A + s^2 I,   A the coordinates of S,
/// s^2 from what is left outside. z'V^-1 z is compared with Hotelling's distribution, the degrees of freedom
/// of P and s^2 pooled (Yao 1965, Biometrika 52:139). Noise that is certainly not white (Ljung-Box below
/// 0.001) is whitened by an autoregression first.
///
/// Lost samples: the longest stretch without any is used. `periodic` estimates are simulated but not judged:
/// they are for records whose force answers to the position, which no simulation from the measured force can
/// judge. Never throws; numbers that do not exist are absent.
[[nodiscard]] Validation validate(const Estimate& estimate, const PreparedRecord& record, ForceHold hold);

/// The estimator on the first 60 % of the record, held against the rest. Of a record longer than 100,000
/// samples its first 100,000. Says why where the record is too short for that or its first part gives no
/// estimate.
[[nodiscard]] Validation validateOnSecondWindow(Estimator estimator, const PreparedRecord& record,
                                                const EstimatorTask& task);

/// `estimate`, found from `recording`, against another squeeze, which is prepared first and brought to the
/// units of `recording`. `hold`: that asked for, else the other recording's own, else first-order. Says why
/// where the units cannot be compared or the other recording cannot be used.
[[nodiscard]] Validation validateOnRecording(const Estimate& estimate, const Recording& recording,
                                             const Recording& other, const QString& name,
                                             std::optional<ForceHold> hold);

} // namespace gripscope
