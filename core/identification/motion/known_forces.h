// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/motion/motion.h"
#include "core/identification/motion/motion_model.h"
#include "core/identification/output_error/completed_record.h"

#include <optional>
#include <vector>

namespace gripscope {

/// A motion's problem with every force known. At lost samples these are what output error finds; where the
/// terms have no mass or no spring, which output error does not know, straight lines where it finds nothing.
struct KnownForces {
    CompletedRecord completed;
    MotionProblem problem;
    double errorFactor = 1; ///< by which the errors grow because lost forces had to be found

    /// Nothing was lost, or what was lost has been found; else `completed.outputError` says why not.
    [[nodiscard]] bool areKnown() const
    {
        return completed.lost.empty() || completed.outputError.parameters.has_value();
    }
};

[[nodiscard]] KnownForces knownForces(const std::vector<double>& force, const std::vector<double>& position,
                                      const MotionOptions& options);

/// The lost forces once more, from positions without what the further terms of `found` add to the motion of
/// its m, b and k. Nothing where no sample was lost, or where output error finds no forces.
[[nodiscard]] std::optional<KnownForces> knownForcesAgain(const KnownForces& known, const Estimate& found,
                                                          const MotionOptions& options);

} // namespace gripscope
