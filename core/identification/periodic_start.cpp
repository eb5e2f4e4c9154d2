// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic_response.h"
#include "core/identification/periodic_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// Force, position and position's standard deviation of one harmonic.
struct MeasuredLine {
    double radiansPerSample = 0;
    Complex force, position;
    double variance = 0;
};

std::vector<MeasuredLine> measuredLines(const PeriodicProblem& problem)
{
    std::vector<MeasuredLine> lines;
    for (const LocalFit& fit : problem.lines) {
        const std::vector<Complex>& position = problem.spectrum.position;
        const double power = fit.residual(fit.gather(position)).squaredNorm();
        lines.push_back({problem.spectrum.radiansPerSample(fit.bin), fit.atHarmonic(problem.spectrum.force),
                         fit.atHarmonic(position),
                         fit.varianceFactor * power / fit.degreesOfFreedom + problem.noiseFloor});
    }
    return lines;
}

/// What hold and lag do to the continuous 1 / (K - M w^2 + j w B), folding left out.
Complex holdAndLag(double w, ForceHold hold, double rest)
{
    const double half = std::sin(w / 2) / (w / 2);
    const Complex held = hold == ForceHold::Zero ? half * std::polar(1.0, -w / 2) : Complex(half * half);
    return held * std::polar(1.0, w * rest);
}

/// Weighted with |G|^2 |U| / deviation, which makes the errors of 1/G those of the position.
std::optional<Eigen::Vector3d> linearStart(const std::vector<MeasuredLine>& lines,
                                           const PeriodicProblem& problem)
{
    // Sums of the two normal equations: real part K - M w^2, imaginary part w B.
    double s0 = 0, s2 = 0, s4 = 0, r0 = 0, r2 = 0, imaginary = 0;
    for (const MeasuredLine& line : lines) {
        const double w = line.radiansPerSample;
        if (!(std::norm(line.position) > 0))
            continue;
        const Complex inverse = line.force / line.position * holdAndLag(w, problem.hold, problem.rest);
        const double share = std::norm(line.position) / std::sqrt(std::norm(line.force) * line.variance);
        const double weight = share * share;
        s0 += weight;
        s2 += weight * w * w;
        s4 += weight * w * w * w * w;
        r0 += weight * inverse.real();
        r2 += weight * w * w * inverse.real();
        imaginary += weight * w * inverse.imag();
    }
    const double determinant = s0 * s4 - s2 * s2;
    const Eigen::Vector3d found{(s2 * r0 - s0 * r2) / determinant, imaginary / s2,
                                (s4 * r0 - s2 * r2) / determinant};
    if (!found.allFinite() || !(found.minCoeff() > 0))
        return std::nullopt;
    return Eigen::Vector3d(found.array().log());
}

/// Cost and best compliance for a shape, the position's noise alone counted.
struct Ranked {
    double cost = 0;
    Eigen::Vector3d theta;
};

std::optional<Ranked> ranked(const Eigen::Vector3d& theta, const std::vector<MeasuredLine>& lines,
                             const PeriodicProblem& problem, bool refitCompliance)
{
    const PeriodicResponse response(theta, problem.hold, problem.rest);
    if (!response.finite())
        return std::nullopt;
    double modelPower = 0, product = 0, power = 0;
    for (const MeasuredLine& line : lines) {
        const Complex model = response.at(line.radiansPerSample, line.force).position;
        modelPower += std::norm(model) / line.variance;
        product += (std::conj(model) * line.position).real() / line.variance;
        power += std::norm(line.position) / line.variance;
    }
    const double gain = refitCompliance ? product / modelPower : 1;
    const double cost = power - 2 * gain * product + gain * gain * modelPower;
    if (!(gain > 0) || !std::isfinite(cost) || !std::isfinite(gain))
        return std::nullopt;
    return Ranked{cost, theta - Eigen::Vector3d::Constant(std::log(gain))};
}

} // namespace

std::vector<Eigen::Vector3d> periodicStarts(const PeriodicProblem& problem,
                                            const std::optional<Eigen::Vector3d>& given)
{
    const std::vector<MeasuredLine> lines = measuredLines(problem);
    if (lines.empty())
        return {};
    std::vector<Ranked> candidates;
    const auto consider = [&](const Eigen::Vector3d& theta, bool refitCompliance) {
        if (const std::optional<Ranked> candidate = ranked(theta, lines, problem, refitCompliance))
            candidates.push_back(*candidate);
    };
    if (const std::optional<Eigen::Vector3d> linear = linearStart(lines, problem))
        consider(*linear, true);
    if (given)
        consider(*given, true);
    constexpr int frequencies = 10;
    const double lowest = lines.front().radiansPerSample / 2;
    const double highest = std::min(2 * lines.back().radiansPerSample, 2 * std::numbers::pi);
    for (int i = 0; i < frequencies; ++i) {
        const double w = lowest * std::pow(highest / lowest, static_cast<double>(i) / (frequencies - 1));
        for (const double damping : {0.05, 0.3, 1.0, 3.0})
            consider({0, std::log(2 * damping * w), 2 * std::log(w)}, true);
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
    std::vector<Eigen::Vector3d> starts;
    for (const Ranked& candidate : candidates)
        starts.push_back(candidate.theta);
    return starts;
}

} // namespace gripscope
