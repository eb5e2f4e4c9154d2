// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "ui/charts/region_plot.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Above, F is chi-square over 3 to five digits, and the quantile's series grows long.
constexpr double manyDegreesOfFreedom = 1e6;
/// Beyond, a determinant is rounding.
constexpr double largestCorrelation = 1 - 1e-12;

double radiusOf(double degreesOfFreedom)
{
    const double degrees = std::clamp(degreesOfFreedom, 1.0, manyDegreesOfFreedom);
    return std::sqrt(3 * fisherQuantile(0.95, 3, degrees));
}

bool usable(const Eigen::Matrix3d& covariance)
{
    for (int i = 0; i < 3; ++i) {
        if (!(covariance(i, i) > 0))
            return false;
        for (int j = 0; j < i; ++j) {
            const double scale = std::sqrt(covariance(i, i)) * std::sqrt(covariance(j, j));
            if (!(std::abs(covariance(i, j)) <= largestCorrelation * scale))
                return false;
        }
    }
    return covariance.allFinite();
}

/// `center` may differ from the estimate's own parameters by what was taken off all estimators alike.
std::optional<EstimateRegion> regionAround(const Identification& identification, const Estimate& best,
                                           const Eigen::Vector3d& center, const Eigen::Matrix3d& covariance,
                                           double degreesOfFreedom)
{
    if (!(center.minCoeff() > 0))
        return std::nullopt;
    EstimateRegion region;
    region.estimator = best.estimator;
    region.covariance = covariance;
    for (int i = 0; i < 3; ++i) {
        region.covariance.row(i) *= 100 / center[i];
        region.covariance.col(i) *= 100 / center[i];
    }
    if (!usable(region.covariance))
        return std::nullopt;
    region.radius = radiusOf(degreesOfFreedom);
    for (const Estimate& other : identification.estimates) {
        if (other.estimator == best.estimator || other.status != EstimateStatus::Converged ||
            !other.parameters)
            continue;
        EstimateRegion::Point point{other.estimator, {}};
        const Eigen::Vector3d off = other.parameters->vector() - best.parameters->vector();
        for (int i = 0; i < 3; ++i)
            point.percent[std::size_t(i)] = 100 * off[i] / center[i];
        if (std::all_of(point.percent.begin(), point.percent.end(),
                        [](double value) { return std::isfinite(value); }))
            region.others.push_back(point);
    }
    return region;
}

} // namespace

double EstimateRegion::correlation(int i, int j) const
{
    return std::clamp(covariance(i, j) / std::sqrt(covariance(i, i)) / std::sqrt(covariance(j, j)), -1.0,
                      1.0);
}

double EstimateRegion::extent(int parameter) const
{
    return radius * std::sqrt(covariance(parameter, parameter));
}

QList<QPointF> EstimateRegion::outline(int horizontal, int vertical, int points) const
{
    // The Cholesky factor of the pair takes the unit circle to its ellipse.
    const double r = correlation(horizontal, vertical);
    const double across = extent(horizontal), up = extent(vertical);
    QList<QPointF> outline;
    outline.reserve(points + 1);
    for (int i = 0; i <= points; ++i) {
        const double angle = 2 * std::numbers::pi * (i % points) / points;
        outline << QPointF(across * std::cos(angle),
                           up * (r * std::cos(angle) + std::sqrt(1 - r * r) * std::sin(angle)));
    }
    return outline;
}

std::optional<EstimateRegion> estimateRegion(const Identification& identification)
{
    const Estimate* best = identification.best();
    if (!best || !best->parameters || !best->covariance)
        return std::nullopt;
    return regionAround(identification, *best, best->parameters->vector(), *best->covariance,
                        best->residuals.degreesOfFreedom);
}

std::optional<EstimateRegion> estimateRegion(const Identification& identification,
                                             const UncertaintyBudget& budget)
{
    const Estimate* best = identification.best();
    if (!best || !best->parameters || !budget.parameters)
        return std::nullopt;
    double degreesOfFreedom = manyDegreesOfFreedom;
    for (const CombinedUncertainty& one : budget.combined)
        degreesOfFreedom = std::min(degreesOfFreedom, one.degreesOfFreedom.value_or(degreesOfFreedom));
    return regionAround(identification, *best, budget.parameters->vector(), budget.covariance,
                        degreesOfFreedom);
}

QString correlationWords(const EstimateRegion& region)
{
    const QString names = u"mbk"_s;
    int worst = 0, with = 1;
    for (const auto& [i, j] : {std::pair(0, 2), std::pair(1, 2)})
        if (std::abs(region.correlation(i, j)) > std::abs(region.correlation(worst, with)))
            worst = i, with = j;
    const double r = region.correlation(worst, with);
    if (std::abs(r) < 0.5)
        return QCoreApplication::translate("gripscope::EstimateRegion",
                                           "m, b and k are known almost independently of each other.");
    return (r > 0 ? QCoreApplication::translate("gripscope::EstimateRegion",
                                                "%1 and %2 err together: if %1 is too high, so is %2.")
                  : QCoreApplication::translate("gripscope::EstimateRegion",
                                                "%1 and %2 err against each other: if %1 is too high, %2 "
                                                "is too low."))
        .arg(names[worst], names[with]);
}

} // namespace gripscope
