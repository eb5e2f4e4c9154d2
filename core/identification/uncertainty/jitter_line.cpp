// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/math/distributions.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Noise that grows with speed is charged where it is that improbable without: one record in a thousand.
constexpr double certainP = 0.001;

/// Least squares of r^2 = s^2 + t^2 v^2 over the rows.
struct JitterFound {
    double variance_s2 = 0; ///< t^2
    double meanSpeed2 = 0;
    bool certain = false;
};

JitterFound regress(const LinearizedRecord& record, const std::vector<double>& residual)
{
    JitterFound found;
    const auto count = static_cast<double>(record.rows.size());
    double meanError2 = 0;
    for (const std::size_t row : record.rows) {
        found.meanSpeed2 += record.velocity[row] * record.velocity[row] / count;
        meanError2 += residual[row] * residual[row] / count;
    }
    double square = 0;
    double product = 0;
    for (const std::size_t row : record.rows) {
        const double speed = record.velocity[row] * record.velocity[row] - found.meanSpeed2;
        square += speed * speed;
        product += speed * (residual[row] * residual[row] - meanError2);
    }
    if (!(square > 0))
        return found;
    found.variance_s2 = product / square;
    double scatter = 0; // of the slope, whatever the spread of r^2 about the line (White 1980)
    for (const std::size_t row : record.rows) {
        const double speed = record.velocity[row] * record.velocity[row] - found.meanSpeed2;
        const double rest = residual[row] * residual[row] - meanError2 - found.variance_s2 * speed;
        scatter += speed * speed * rest * rest;
    }
    const double deviation = std::sqrt(scatter) / square;
    found.certain = found.variance_s2 > normalQuantile(1 - certainP) * deviation;
    return found;
}

} // namespace

std::vector<BudgetLine> jitterLines(const Estimate& estimate, const LinearizedRecord& record)
{
    if (!record.usable() || estimate.residual.size() != record.velocity.size())
        return {};
    const JitterFound found = regress(record, estimate.residual);
    if (!found.certain || !std::isfinite(found.variance_s2))
        return {};
    // What the noise's line has on average is not counted again.
    const Eigen::MatrixXd influence = influences(record);
    Eigen::Matrix3d relative = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < record.rows.size(); ++i) {
        const double speed = record.velocity[record.rows[i]];
        const Eigen::Vector3d weight = influence.row(static_cast<Eigen::Index>(i)).transpose();
        relative += (speed * speed - found.meanSpeed2) * weight * weight.transpose();
    }
    relative = positivePart(relative * found.variance_s2);
    if (!relative.allFinite() || !(relative.trace() > 0))
        return {};
    return {lineOf(u"jitter"_s,
                   Words::say("the noise grows with the speed, as when samples are taken %1 us beside "
                              "their times (standard deviation)")
                       .arg(1e6 * std::sqrt(found.variance_s2), 'g', 2),
                   EvaluationType::A, estimate.parameters->vector(), relative)};
}

} // namespace gripscope
