// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/estimate.h"
#include "core/identification/validity.h"
#include "core/signal/recording.h"
#include "core/signal/window.h"

#include <optional>
#include <vector>

namespace gripscope {

enum class InitialState { Free, Rest };

struct IdentificationOptions {
    std::vector<Estimator> estimators = {Estimator::Arx, Estimator::OutputError};
    std::optional<ForceHold> hold; ///< empty: the recording's, else first-order
    InitialState initialState = InitialState::Free;
    bool freeOffset = true; ///< a position offset (OE) or a constant column (ARX)
};

/// All that was found out about one recording.
struct Identification {
    WindowChoice choice;
    ForceHold hold = ForceHold::First;
    double sampleTime_s = 0;
    std::vector<Estimate> estimates; ///< in the order asked for
    Estimator recommended = Estimator::OutputError;
    Validity validity;
    /// By how much the other force hold would raise the log-likelihood of output error, correlation between
    /// residuals allowed for; absent when it was not tried. Above 10 the two are told apart.
    std::optional<double> otherHoldGain;
    std::vector<double> time_s, force, position; ///< the window that was used, for plots

    /// The recommended estimate, or null when there is none with parameters.
    [[nodiscard]] const Estimate* best() const;
    [[nodiscard]] const Estimate* find(Estimator estimator) const;
};

/// Chooses the window, runs every estimator asked for, and judges the measurement. Pure; never throws for
/// data.
[[nodiscard]] Identification identify(const Recording& recording, const IdentificationOptions& options = {});

} // namespace gripscope
