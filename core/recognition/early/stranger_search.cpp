// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/early/stranger_search.h"

#include "core/identification/output_error/output_error_model.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

constexpr int mostSearchSteps = 8;
/// In logarithms: a step this small changes no evidence.
constexpr double settled = 1e-3;

/// The record at one theta under the pole that suits it best.
struct Judged {
    double cost = std::numeric_limits<double>::infinity(); ///< -2 ln of the profiled density
    ReducedRecord record;
    double variance = 0;
};

Judged judge(const LinearizedRecord& at, std::span<const double> poles, double ridge)
{
    Judged best;
    if (!at.finite)
        return best;
    const auto rows = static_cast<double>(at.products.rows());
    const auto stretches = static_cast<double>(at.products.stretches());
    for (const double pole : poles) {
        const ReducedRecord record = reduceRecord(at.products, pole, ridge);
        const double cost = rows * std::log(record.residual) - stretches * std::log1p(-pole * pole);
        if (cost < best.cost)
            best = {cost, record, record.residual / rows};
    }
    return best;
}

} // namespace

LinearizedRecord linearize(const OutputErrorProblem& problem, const Eigen::Vector3d& theta)
{
    LinearizedRecord record{theta, LaggedProducts(problem.nuisanceCount() + 4), true};
    forEachLinearizedRow(problem, theta, {}, [&](std::ptrdiff_t time, const Eigen::RowVectorXd& row) {
        record.finite = record.finite && row.allFinite();
        record.products.add(time, row);
    });
    record.finite = record.finite && record.products.rows() > record.products.columns();
    return record;
}

LinearizedRecord searchStranger(const OutputErrorProblem& problem, std::span<const Eigen::Vector3d> starts,
                                const ThetaRange& range, std::span<const double> poles, double ridge)
{
    LinearizedRecord found;
    Judged here;
    for (const Eigen::Vector3d& start : starts) {
        LinearizedRecord at = linearize(problem, range.nearest(start));
        const Judged judged = judge(at, poles, ridge);
        if (judged.cost < here.cost) {
            found = std::move(at);
            here = judged;
        }
    }
    if (!found.finite)
        return found;
    const Eigen::Vector3d precision = range.variance().cwiseInverse();
    double damping = 0;
    for (int step = 0; step < mostSearchSteps; ++step) {
        Eigen::Matrix3d information = here.record.information;
        information.diagonal() = (1 + damping) * information.diagonal() + here.variance * precision;
        const Eigen::Vector3d change = information.ldlt().solve(here.record.slope);
        const Eigen::Vector3d theta = range.nearest(found.theta + change.cwiseMax(-1).cwiseMin(1));
        if ((theta - found.theta).cwiseAbs().maxCoeff() < settled)
            break;
        LinearizedRecord at = linearize(problem, theta);
        const Judged judged = judge(at, poles, ridge);
        if (judged.cost < here.cost) {
            const double gain = here.cost - judged.cost;
            found = std::move(at);
            here = judged;
            damping /= 10;
            if (gain < settled)
                break;
        } else {
            damping = std::max(10 * damping, 0.1);
        }
    }
    return found;
}

} // namespace gripscope
