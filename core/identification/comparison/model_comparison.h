// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/identification/model/estimate.h"
#include "core/identification/model/evidence.h"
#include "core/identification/output_error/output_error.h"

#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// One model of the squeeze among others. `id`: linear (as asked for), cubic_spring, without_offset,
/// with_offset, delay, other_hold, smooth_force, or the name of an estimator with further terms (friction,
/// zener, friction+zener, ...).
struct ComparedModel {
    QString id;
    Finding words;
    Estimate estimate;
    int parameters = 0; ///< all that were fitted: of the motion, of the start, of the noise
    int noiseOrder = 0; ///< of the autoregressive model of its residuals
    double logLikelihood = 0;
    double criterion = 0; ///< BIC; the lowest is best
    double delta = 0;     ///< above the best one's
    double weight = 0;    ///< exp(-delta / 2), all weights adding up to 1
    double change = 0;    ///< largest change of m, b or k from the linear model's, in standard errors
    std::optional<double> delay_s; ///< of `delay`: beyond the declared lag
};

/// Models ranked by the Bayesian information criterion BIC = -2 ln L + p ln N (Schwarz 1978). L is the
/// Gaussian likelihood of the model's residuals under their own autoregressive noise (order by BIC, up to
/// 20), since residuals are seldom white and a likelihood that takes them for white is sure of far too much.
/// What is known of the gripper's own friction is part of the data.
struct ModelComparison {
    std::vector<ComparedModel> ranked; ///< best first
    QString criterion;                 ///< "BIC"
    bool decisive = false;             ///< another model than the linear one is better, and it matters
    /// Twice the logarithm of the likelihood (white noise) that a part which goes on yielding gains, where
    /// its search found a way that does not end: it yields more slowly than the record is long.
    double unsettledYielding = 0;
    Finding sentence; ///< the outcome in words; empty when nothing could be compared
    [[nodiscard]] const ComparedModel* find(const QString& id) const;
};

/// `linear` is the output-error estimate with `options`; `motions` those of the same record with further
/// terms, `otherHold` that of estimateOtherHold(). The others
/// are estimated here: the offset the other way, a further delay between the channels (by Gauss-Newton), and
/// for straight forces one that is smooth between its samples (straightAsSpline()). A model is claimed to be
/// better only where the criterion is decisively lower and m, b or k differ by more than two standard errors,
/// the smaller of the two models' each where it explains more. Not among the ranked: one that does not settle
/// within 30 iterations (the others need 3 to 12), and the one without an offset that is beyond doubt.
/// `knownFriction`: the gripper's own, where somebody measured it.
[[nodiscard]] ModelComparison compareModels(const std::vector<double>& force,
                                            const std::vector<double>& position,
                                            const OutputErrorOptions& options, const Estimate& linear,
                                            const Estimate& otherHold,
                                            const std::vector<Estimate>& motions = {},
                                            const std::optional<GripperFriction>& knownFriction = {});

} // namespace gripscope
