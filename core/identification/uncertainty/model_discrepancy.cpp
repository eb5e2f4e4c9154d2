// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/math/distributions.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A window that determines m, b and k worse than this is too far from normal for the comparison.
constexpr double largestWindowError = 0.25;
constexpr std::size_t fewestParts = 3;
constexpr std::size_t fewestWindows = 4;
constexpr std::size_t mostWindows = 6;
constexpr double fewestSamples = 60;

/// One part in logarithms.
struct WindowPart {
    Eigen::Vector3d theta;
    Eigen::Matrix3d covariance;
    double degreesOfFreedom;
};

std::optional<WindowPart> partOf(const Estimate& e)
{
    if (e.status != EstimateStatus::Converged || !e.parameters || !e.covariance)
        return std::nullopt;
    const Eigen::Vector3d p = e.parameters->vector();
    if (!(p.minCoeff() > 0) || !p.allFinite())
        return std::nullopt;
    const Eigen::Vector3d inverse = p.cwiseInverse();
    const Eigen::Matrix3d covariance = inverse.asDiagonal() * *e.covariance * inverse.asDiagonal();
    const Eigen::Vector3d variances = covariance.diagonal();
    const double largest = largestWindowError * largestWindowError;
    if (!covariance.allFinite() || !(variances.minCoeff() > 0) || variances.maxCoeff() > largest)
        return std::nullopt;
    return WindowPart{p.array().log(), covariance, std::max(e.residuals.degreesOfFreedom, 3.0)};
}

/// p-value of the hypothesis that all parts have the same theta.
std::optional<double> agreement(const std::vector<WindowPart>& parts)
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    for (const WindowPart& part : parts) {
        const Eigen::Matrix3d weight = part.covariance.inverse();
        information += weight;
        weighted += weight * part.theta;
    }
    const Eigen::Vector3d mean = information.inverse() * weighted;
    double q = 0;
    double degreesOfFreedom = 0;
    for (const WindowPart& part : parts) {
        const Eigen::Vector3d d = part.theta - mean;
        const double nu = part.degreesOfFreedom;
        q += d.dot(part.covariance.inverse() * d) * (nu - 2) / nu;
        degreesOfFreedom += nu;
    }
    if (!std::isfinite(q) || q < 0)
        return std::nullopt;
    const double count = 3 * static_cast<double>(parts.size() - 1);
    return fisherAbove(q / count, count, degreesOfFreedom);
}

void estimateSpread(const std::vector<WindowPart>& parts, ModelDiscrepancy& out)
{
    const auto count = static_cast<double>(parts.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    for (const WindowPart& part : parts) {
        mean += part.theta / count;
        noise += part.covariance / count;
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const WindowPart& part : parts)
        spread += (part.theta - mean) * (part.theta - mean).transpose() / (count - 1);
    const Eigen::Vector3d scale = spread.diagonal().cwiseMax(noise.diagonal()).cwiseSqrt();
    const Eigen::Matrix3d excess = positivePart(spread - noise, scale);
    if (!excess.allFinite())
        return;
    out.covariance = excess;
    const Eigen::Array3d ratio = excess.diagonal().cwiseQuotient(scale.cwiseAbs2()).cwiseMin(1.0);
    out.degreesOfFreedom = ((count - 1) * ratio.square()).max(1.0);
}

Finding percentDigits(double share)
{
    return Finding::number(100 * share, 'g', 2);
}

} // namespace

ModelDiscrepancy discrepancyBetween(std::span<const Estimate> estimates)
{
    ModelDiscrepancy out;
    std::vector<WindowPart> parts;
    for (const Estimate& estimate : estimates) {
        if (const std::optional<WindowPart> part = partOf(estimate))
            parts.push_back(*part);
    }
    if (parts.size() < fewestParts) {
        out.words = Words::say("too few parts determine m, b and k well enough to be compared");
        return out;
    }
    out.parts = static_cast<int>(parts.size());
    out.agreementP = agreement(parts);
    if (!out.agreementP || *out.agreementP >= discrepancyLevel) {
        out.words = Words::say("%1 parts agree on m, b and k within their noise").arg(out.parts);
        return out;
    }
    estimateSpread(parts, out);
    const Eigen::Vector3d u = out.covariance.diagonal().cwiseSqrt();
    out.words =
        Words::say("%1 parts disagree beyond their noise by %2 % in m, %3 % in b and %4 % in k")
            .arg(QString::number(out.parts), percentDigits(u(0)), percentDigits(u(1)), percentDigits(u(2)));
    return out;
}

std::vector<Window> discrepancyWindows(std::size_t samples, double sampleTime_s,
                                       const MassDampingStiffness& parameters)
{
    const double m = parameters.m;
    const double b = parameters.b;
    const double k = parameters.k;
    if (!(m > 0) || !(b > 0) || !(k > 0) || !(sampleTime_s > 0))
        return {};
    const double swing = 2 * std::numbers::pi * std::sqrt(m / k);
    const double timeConstant = 2 * m / b + b / k; // at least that of the slower motion
    const double needed =
        std::max({fewestSamples, 4 * timeConstant / sampleTime_s, 2 * swing / sampleTime_s});
    const auto available = static_cast<double>(samples);
    if (!(available >= static_cast<double>(fewestWindows) * needed))
        return {};
    const auto count = std::min<std::size_t>(mostWindows, static_cast<std::size_t>(available / needed));
    const std::size_t length = samples / count;
    std::vector<Window> windows;
    for (std::size_t i = 0; i < count; ++i)
        windows.push_back({i * length, length});
    return windows;
}

ModelDiscrepancy modelDiscrepancy(std::size_t samples, double sampleTime_s, const Estimate& whole,
                                  const std::function<Estimate(Window)>& estimate)
{
    ModelDiscrepancy none;
    if (!whole.parameters) {
        none.words = Words::say("there is no estimate whose parts could be compared");
        return none;
    }
    const std::vector<Window> windows = discrepancyWindows(samples, sampleTime_s, *whole.parameters);
    if (windows.empty()) {
        none.words = Words::say("the record is too short to compare parts of it; squeeze longer");
        return none;
    }
    std::vector<Estimate> estimates(windows.size());
    shareAmongThreads(static_cast<std::int64_t>(windows.size()), 0, [&](std::int64_t i) {
        estimates[static_cast<std::size_t>(i)] = estimate(windows[static_cast<std::size_t>(i)]);
    });
    return discrepancyBetween(estimates);
}

} // namespace gripscope
