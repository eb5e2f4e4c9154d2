// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/identification/output_error/output_error.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace gripscope {

/// The model y = x(m, b, k, x0, v0, offset) of output error, linearised at an estimate: column by column what
/// a small change does to the position, one row a sample, in units of `positionScale`.
///
/// An effect that was left out of the model and adds c(t) to the position moves the least-squares estimate of
/// (ln m, ln b, ln k) by (S'S)^-1 S' c, everything that x0, v0 and offset take up projected out of both (the
/// omitted-variable formula; linear, as all of the law of propagation of uncertainty, JCGM 100, 5.1.2).
struct LinearizedRecord {
    Eigen::MatrixXd nuisances;         ///< rows x (0..3): x0, v0, offset, those that are free
    Eigen::MatrixXd sensitivities;     ///< rows x 3: d y / d (ln m, ln b, ln k)
    std::vector<std::size_t> rows;     ///< the sample each row stands for
    std::vector<double> velocity;      ///< d y / d lag at every sample: what a wrong lag adds a second
    std::vector<double> forceAtSample; ///< the force at the time of every position, as it is held
    double positionScale = 1;
    [[nodiscard]] bool usable() const { return !rows.empty(); }
};

/// At `estimate` (its parameters, x0, v0 and offset), of a force with the hold and lag of `options`. Not
/// usable when there are no parameters, fewer rows than columns, or numbers beyond the range. For an estimate
/// with a cubic spring the linear spring's columns stand in. Forces marked as lost count as known here, which
/// makes the effects of the others a little too small or too large, never the noise. O(N).
[[nodiscard]] LinearizedRecord linearizedRecord(const Estimate& estimate, const std::vector<double>& force,
                                                const OutputErrorOptions& options);

/// What each effect (a value a sample, position unit per unit of the effect) does to (ln m, ln b, ln k): a
/// column an effect. Empty when the record is not usable or the columns of m, b and k depend on one another.
[[nodiscard]] Eigen::Matrix3Xd shiftsBy(const LinearizedRecord& record,
                                        std::span<const std::vector<double>> effects);

/// (S'S)^-1 S' of LinearizedRecord, a row a row of the record: what a unit of position there does to (ln m,
/// ln b, ln k).
[[nodiscard]] Eigen::MatrixXd influences(const LinearizedRecord& record);

/// The triangle of [nuisances, sensitivities, effects, residual], rows filtered by `noise` (each stretch
/// between lost samples on its own; its first rows are left out), and how many rows went into it.
struct EffectTriangle {
    Eigen::MatrixXd triangle;
    double rows = 0;
};
[[nodiscard]] EffectTriangle effectTriangle(const LinearizedRecord& record,
                                            std::span<const std::vector<double>> effects,
                                            const std::vector<double>& residual,
                                            const std::vector<double>& noise);

/// The samples that, joined by straight lines, act as the natural cubic spline through `force` does: u - M /
/// 12, M the spline's second derivative a sample squared. Between two samples the spline bends away from the
/// chord by a parabola whose mean is -M / 12, so that the impulse over every step is kept; what the
/// parabola's shape does within the step is of the order T^4. A force that was sampled, not commanded, is
/// smooth: on straight lines its parts of angular frequency w come out too small by (w T)^2 / 12.
[[nodiscard]] std::vector<double> straightAsSpline(const std::vector<double>& force);

} // namespace gripscope
