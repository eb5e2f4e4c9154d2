// SPDX-License-Identifier: GPL-3.0-or-later
// Run lengths of EWMA and CUSUM charts: Fredholm equations of the second kind at Gauss and Legendre's places.
#include "core/math/distributions.h"
#include "core/math/gauss_legendre.h"
#include "core/quality/charts/run_length.h"

#include <Eigen/LU>

#include <cmath>

namespace gripscope {

namespace {

constexpr double longestRun = 1e12; // beyond, 1 - (chance to stay) has no digits left
constexpr int fewestPlaces = 48, mostPlaces = 480;
constexpr double placesPerDeviation = 3;

/// Even, so many that the kernel, which is one `deviation` wide, is followed; 0: too many.
int placesFor(double length, double deviation)
{
    const double wanted = placesPerDeviation * length / deviation;
    if (!(wanted <= mostPlaces))
        return 0;
    return std::max(fewestPlaces, 2 * int(std::ceil(wanted / 2)));
}

std::optional<RunLength> tellable(double points)
{
    // at least one point is drawn; a rounding below it is one
    if (!(points > 1 - 1e-6 && points < longestRun))
        return {};
    return RunLength{std::max(1.0, points), 0};
}

class EwmaKernel {
public:
    EwmaKernel(double weight, double shift) : m_weight(weight), m_shift(shift) {}
    /// Density of going to `to` from `from`.
    [[nodiscard]] double operator()(double from, double to) const
    {
        return normalDensity((to - (1 - m_weight) * from) / m_weight - m_shift) / m_weight;
    }
    /// 1 + int next(y) kernel(from, y) dy
    [[nodiscard]] double onward(double from, const QuadratureRule& rule, const Eigen::VectorXd& next) const
    {
        double sum = 1;
        for (Eigen::Index i = 0; i < next.size(); ++i)
            sum += rule.weights(i) * next(i) * (*this)(from, rule.places(i));
        return sum;
    }

private:
    double m_weight, m_shift;
};

/// At the places of `rule`, whose ends are the limits for ever.
Eigen::VectorXd settledRunLengths(const EwmaKernel& kernel, const QuadratureRule& rule)
{
    const Eigen::Index places = rule.places.size();
    Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(places, places);
    for (Eigen::Index from = 0; from < places; ++from)
        for (Eigen::Index to = 0; to < places; ++to)
            equations(from, to) -= rule.weights(to) * kernel(rule.places(from), rule.places(to));
    return equations.partialPivLu().solve(Eigen::VectorXd::Ones(places));
}

std::optional<double> oneSidedCusum(double reference, double decision, double shift)
{
    const int places = placesFor(decision, 1);
    if (places == 0)
        return {};
    const QuadratureRule rule = gaussLegendre(places).between(0, decision);
    // the last unknown is l(0)
    Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(places + 1, places + 1);
    for (Eigen::Index row = 0; row <= places; ++row) {
        const double from = row < places ? rule.places(row) : 0;
        const double drift = reference - from - shift;
        for (Eigen::Index to = 0; to < places; ++to)
            equations(row, to) -= rule.weights(to) * normalDensity(rule.places(to) + drift);
        equations(row, places) -= normalBelow(drift);
    }
    const Eigen::VectorXd lengths = equations.partialPivLu().solve(Eigen::VectorXd::Ones(places + 1));
    return lengths(places);
}

} // namespace

std::optional<RunLength> ewmaRunLength(double weight, double width, double shift, EwmaLimits limits)
{
    if (!(weight >= 0.01 && weight <= 1 && width > 0 && std::isfinite(shift)))
        return {};
    const double settled = width * std::sqrt(weight / (2 - weight));
    const int places = placesFor(2 * settled, weight);
    if (places == 0)
        return {};
    const QuadratureRule unit = gaussLegendre(places);
    const EwmaKernel kernel(weight, shift);
    QuadratureRule next = unit.between(-settled, settled);
    Eigen::VectorXd lengths = settledRunLengths(kernel, next);
    if (limits == EwmaLimits::Exact && weight < 1) {
        // Where the limits are within 1e-9 of what they come to, they are there.
        int step = int(std::ceil(std::log(1e-9) / (2 * std::log1p(-weight))));
        for (; step > 0; --step) {
            const double limit = settled * std::sqrt(-std::expm1(2 * step * std::log1p(-weight)));
            const QuadratureRule here = unit.between(-limit, limit);
            Eigen::VectorXd earlier(places);
            for (Eigen::Index i = 0; i < places; ++i)
                earlier(i) = kernel.onward(here.places(i), next, lengths);
            lengths = earlier;
            next = here;
        }
    }
    return tellable(kernel.onward(0, next, lengths));
}

std::optional<RunLength> cusumRunLength(double reference, double decision, double shift)
{
    if (!(reference >= 0 && decision > 0 && std::isfinite(shift)))
        return {};
    const std::optional<double> length = oneSidedCusum(reference, decision, shift);
    return length ? tellable(*length) : std::nullopt;
}

std::optional<RunLength> twoSidedCusumRunLength(double reference, double decision, double shift)
{
    const std::optional<RunLength> toward = cusumRunLength(reference, decision, std::abs(shift));
    if (!toward)
        return {};
    // The far side hardly ever signals; where its length is beyond telling it adds nothing.
    const std::optional<RunLength> away = cusumRunLength(reference, decision, -std::abs(shift));
    return tellable(1 / (1 / toward->points + (away ? 1 / away->points : 0)));
}

} // namespace gripscope
