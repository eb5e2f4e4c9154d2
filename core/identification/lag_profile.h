// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lag_estimation.h"
#include "core/identification/output_error.h"

#include <optional>
#include <vector>

namespace gripscope {

/// Lags searched, in sample times: [middle - half, middle + half].
struct LagRange {
    double middle = 0, half = 2;
};

struct LagMinimum {
    double lag = 0; ///< sample times
    double sse = 0;
    double degreesOfFreedom = 0; ///< the lag counted as a parameter
    std::optional<double> error; ///< standard error in sample times; none where the profile does not rise
    bool atEnd = false;
};

/// The sum of squared residuals of output error, smallest in everything but the lag. Whole samples of lag are
/// taken by shifting the force against the position, within rows that are there for every lag of the range,
/// so that values for different lags compare.
class LagProfile {
public:
    /// The data must outlive it.
    LagProfile(const std::vector<double>& force, const std::vector<double>& position,
               const LagEstimationOptions& options, LagRange range);

    [[nodiscard]] std::optional<LagMinimum> minimum() const;
    [[nodiscard]] LagProfile withOtherHold() const;

private:
    struct Value {
        double sse = 0, degreesOfFreedom = 0;
        MassDampingStiffness parameters;
    };
    [[nodiscard]] std::optional<Value> at(double lag, std::optional<MassDampingStiffness> start) const;
    [[nodiscard]] std::optional<double> errorAt(double lag, const Value& best) const;

    const std::vector<double>& m_force;
    const std::vector<double>& m_position;
    OutputErrorOptions m_options;
    LagRange m_range;
};

} // namespace gripscope
