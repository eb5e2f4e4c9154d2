// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/motion_terms.h"
#include "core/identification/result/identification_result.h"
#include "core/signal/recording/units.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace gripscope {

/// The unit of a motion's parameter, where those of m, b and k are these: "N", "s", "N/mm^3", "1".
[[nodiscard]] QString unitOf(MotionParameter parameter, const ParameterUnits& units);

/// The unit that comparableUnits() gives it, and the factor that takes a number in the channels' units there.
struct ComparableUnit {
    QString unit;
    double factor = 1;
};
[[nodiscard]] ComparableUnit comparableUnit(MotionParameter parameter, const QString& forceUnit,
                                            const QString& positionUnit);

/// It is the recommended one, and has an answer.
[[nodiscard]] bool isRecommended(const Identification& identification, const Estimate& estimate);

/// A parameter that an identification tells, as a person is told it.
struct DeterminedParameter {
    MotionParameter parameter = MotionParameter::Mass;
    double value = 0;
    std::optional<CoverageInterval> interval; ///< of 95 %; absent where no errors are known
    bool isLowerBound = false;                ///< at least `value`, and that is all
    QString unit;
};

/// All of the recommended estimate, in the order of MotionParameter and in comparable units: m, b and k as
/// far as the record tells them, then what its model has besides. With the intervals of the budget where it
/// has them, else of the estimate's noise. Empty where nothing was determined.
[[nodiscard]] std::vector<DeterminedParameter> determinedParameters(const Identification& identification,
                                                                    const QString& forceUnit,
                                                                    const QString& positionUnit);
/// Of one of its estimates beside the recommended one: with intervals of its noise alone.
[[nodiscard]] std::vector<DeterminedParameter>
determinedParameters(const Estimate& estimate, const QString& forceUnit, const QString& positionUnit);

} // namespace gripscope
