// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_response.h"
#include "core/identification/periodic/periodic_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// e = Y - X and its derivatives by theta, on the used bins; zero elsewhere.
struct EquationError {
    std::vector<Complex> error;
    std::array<std::vector<Complex>, 3> gradient;

    EquationError(const PeriodicProblem& problem, const PeriodicResponse& response,
                  const Eigen::Vector2d& start)
    {
        const std::size_t count = problem.usedBins.empty() ? 0 : problem.usedBins.back() + 1;
        error.resize(count);
        for (std::vector<Complex>& column : gradient)
            column.resize(count);
        for (const std::size_t bin : problem.usedBins) {
            const PeriodicResponse::Value value =
                response.at(problem.spectrum.radiansPerSample(bin), problem.spectrum.force[bin], start);
            error[bin] = problem.spectrum.position[bin] - value.position;
            for (std::size_t i = 0; i < gradient.size(); ++i)
                gradient[i][bin] = -value.gradient(static_cast<Eigen::Index>(i));
        }
    }
};

using Gradient = Eigen::Matrix<Complex, 3, 1>;

Eigen::Matrix3d outer(const Gradient& g)
{
    return (g.conjugate() * g.transpose()).real();
}

void addLine(const LocalFit& line, const EquationError& equation, double noiseFloor,
             const double* givenVariance, PeriodicCost& cost)
{
    const double freedom = line.degreesOfFreedom;
    const double weight = (freedom - 1) / freedom;
    const Eigen::VectorXcd residual = line.residual(line.gather(equation.error));
    const double perPower = line.varianceFactor / freedom;
    const double measured = perPower * residual.squaredNorm() + noiseFloor;
    const double variance = givenVariance != nullptr ? *givenVariance : measured;
    const double deviation = std::sqrt(variance);
    const Complex r = line.atHarmonic(equation.error) / deviation;
    Gradient known;
    Gradient whole;
    for (std::size_t i = 0; i < equation.gradient.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        known(row) = line.atHarmonic(equation.gradient[i]) / deviation;
        whole(row) = known(row);
        if (givenVariance == nullptr)
            whole(row) -= r * (perPower * residual.dot(line.gather(equation.gradient[i])).real() / variance);
    }
    cost.variances.push_back(measured);
    cost.value += weight * std::norm(r);
    cost.curvature += weight * outer(whole);
    cost.gradient += weight * (whole.conjugate() * r).real();
    cost.information += weight * outer(known);
    cost.scatter += weight * (freedom - 1) / (freedom - 2) * outer(known);
}

} // namespace

PeriodicProblem::PeriodicProblem(PeriodicSpectrum itsSpectrum, ForceHold itsHold, double itsRest,
                                 double positionRange)
    : spectrum(std::move(itsSpectrum)), lines(excitedLines(spectrum)), hold(itsHold), rest(itsRest)
{
    std::vector<bool> used(spectrum.force.size());
    double largest = 0;
    for (const LocalFit& line : lines) {
        used[line.bin] = true;
        for (const std::size_t bin : line.beside)
            used[bin] = true;
        largest = std::max(largest, std::abs(spectrum.position[line.bin]));
    }
    for (std::size_t bin = 0; bin < used.size(); ++bin) {
        if (used[bin])
            usedBins.push_back(bin);
    }
    constexpr double rounding = 1e-10;
    noiseFloor = rounding * rounding * largest * largest + 1e-200;
    startScale = positionRange / std::sqrt(static_cast<double>(std::max<std::size_t>(spectrum.samples, 1)));
}

PeriodicCost periodicCost(const PeriodicProblem& problem, const Eigen::Vector3d& theta,
                          const Eigen::Vector2d& start, const std::vector<double>* variances)
{
    PeriodicCost cost;
    const PeriodicResponse response(theta, problem.hold, problem.rest);
    if (!response.finite())
        return cost;
    const EquationError equation(problem, response, start);
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        addLine(problem.lines[i], equation, problem.noiseFloor,
                variances != nullptr ? &(*variances)[i] : nullptr, cost);
    cost.finite = std::isfinite(cost.value) && cost.curvature.allFinite() && cost.gradient.allFinite() &&
                  cost.information.allFinite() && cost.scatter.allFinite();
    return cost;
}

Eigen::Vector2d fitStart(const PeriodicProblem& problem, const Eigen::Vector3d& theta,
                         const Eigen::Vector2d& lastStart)
{
    const PeriodicResponse response(theta, problem.hold, problem.rest);
    if (!response.finite() || !(problem.startScale > 0))
        return Eigen::Vector2d::Zero();
    const std::size_t count = problem.usedBins.empty() ? 0 : problem.usedBins.back() + 1;
    std::vector<Complex> error(count);
    std::array<std::vector<Complex>, 2> columns{std::vector<Complex>(count), std::vector<Complex>(count)};
    for (const std::size_t bin : problem.usedBins) {
        const double radians = problem.spectrum.radiansPerSample(bin);
        const Eigen::Matrix<Complex, 2, 1> byStart = response.byStart(radians);
        columns[0][bin] = byStart(0) * problem.startScale;
        columns[1][bin] = byStart(1) * problem.startScale;
        error[bin] =
            problem.spectrum.position[bin] - response.at(radians, problem.spectrum.force[bin]).position;
    }
    const Eigen::Vector2d last = lastStart / problem.startScale;
    Eigen::Matrix2d normal = Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const LocalFit& line : problem.lines) {
        const Eigen::VectorXcd residual = line.residual(line.gather(error));
        Eigen::MatrixXcd own(residual.size(), 2);
        for (Eigen::Index i = 0; i < 2; ++i)
            own.col(i) = line.residual(line.gather(columns[static_cast<std::size_t>(i)]));
        const double variance =
            (residual - own * last).squaredNorm() / line.degreesOfFreedom + problem.noiseFloor;
        // A bin stands beside several lines; each has one bin's weight in the end.
        const double weight = 2 / variance * static_cast<double>(problem.spectrum.periods - 1) /
                              static_cast<double>(line.beside.size());
        normal += weight * (own.adjoint() * own).real();
        right += weight * (own.adjoint() * residual).real();
    }
    if (!normal.allFinite() || !right.allFinite())
        return Eigen::Vector2d::Zero();
    // A 2 x 2 system with the identity added: its determinant is at least 1.
    const double determinant = normal(0, 0) * normal(1, 1) - normal(0, 1) * normal(1, 0);
    const Eigen::Vector2d solution{normal(1, 1) * right(0) - normal(0, 1) * right(1),
                                   normal(0, 0) * right(1) - normal(1, 0) * right(0)};
    const Eigen::Vector2d start = solution / determinant * problem.startScale;
    return start.allFinite() ? start : Eigen::Vector2d::Zero().eval();
}

} // namespace gripscope
