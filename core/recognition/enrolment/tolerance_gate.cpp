// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/decompositions.h"
#include "core/math/distributions.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/quantity_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <vector>

namespace gripscope {

namespace {

constexpr int draws = 10'000;
constexpr double wholeNodes = 16; ///< up to here every whole number of degrees of freedom is a node
constexpr double nodeRatio = 1.2; ///< above, the next is so many times the last
constexpr double asGoodAsKnown = 1e5;

/// Chi-square with any degrees of freedom above 1 (Marsaglia and Tsang, A simple method for generating gamma
/// variables, 2000).
double chiSquared(GaussianNoise& noise, double degreesOfFreedom)
{
    const double d = degreesOfFreedom / 2 - 1.0 / 3;
    const double c = 1 / std::sqrt(9 * d);
    while (true) {
        const double x = noise();
        const double root = 1 + c * x;
        if (root <= 0)
            continue;
        const double value = root * root * root;
        if (std::log(1 - noise.uniform()) < x * x / 2 + d - d * value + d * std::log(value))
            return 2 * d * value;
    }
}

/// Eigenvalues of a Wishart matrix of unit mean, by Bartlett's decomposition.
LogVector wishartEigenvalues(GaussianNoise& noise, double degreesOfFreedom, int dimensions)
{
    LogMatrix factor = LogMatrix::Zero(dimensions, dimensions);
    for (int i = 0; i < dimensions; ++i) {
        for (int j = 0; j < i; ++j)
            factor(i, j) = noise();
        factor(i, i) = std::sqrt(chiSquared(noise, degreesOfFreedom - i));
    }
    const LogMatrix matrix = factor * factor.transpose() / degreesOfFreedom;
    return smallSymmetricAxes(matrix).values;
}

/// Quantile 1 - rate of chi-square distributions, from a table: a gate asks for thousands.
class ChiSquaredQuantiles {
public:
    explicit ChiSquaredQuantiles(double rate) : m_rate(rate)
    {
        for (int node = 0; node < nodes; ++node)
            m_table[std::size_t(node)] = exact(std::exp(node * step));
    }

    [[nodiscard]] double operator()(double degreesOfFreedom) const
    {
        const double place = std::log(degreesOfFreedom) / step;
        if (!(place >= 0 && place < nodes - 1))
            return exact(degreesOfFreedom);
        const auto below = std::size_t(place);
        const double share = place - double(below);
        return (1 - share) * m_table[below] + share * m_table[below + 1];
    }

private:
    static constexpr int nodes = 200;
    static constexpr double step = 0.02; // from 1 to 53 degrees of freedom, to 1e-4

    [[nodiscard]] double exact(double degreesOfFreedom) const
    {
        return chiSquaredQuantileAbove(m_rate, degreesOfFreedom);
    }

    double m_rate;
    std::array<double, nodes> m_table{};
};

/// Quantile of sum_i (z_i - shift_i)^2 / eigenvalue_i, z ~ N(0, I), by the chi-square distribution of the
/// same mean, variance and skewness.
double contentQuantile(const LogVector& eigenvalues, const LogVector& shift,
                       const ChiSquaredQuantiles& quantiles)
{
    std::array<double, 3> moments{};
    for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
        const double weight = 1 / eigenvalues(i);
        double power = weight;
        for (int order = 1; order <= 3; ++order, power *= weight)
            moments[std::size_t(order - 1)] += power * (1 + order * shift(i) * shift(i));
    }
    const double h = moments[1] * moments[1] * moments[1] / (moments[2] * moments[2]);
    return (quantiles(h) - h) * std::sqrt(moments[1] / h) + moments[0];
}

double simulatedGate(int squeezes, double degreesOfFreedom, double rate, double confidence, int dimensions)
{
    constexpr std::uint64_t seed = 1;
    GaussianNoise noise(seed);
    const ChiSquaredQuantiles quantiles(rate);
    std::vector<double> gates(draws);
    for (double& gate : gates) {
        const LogVector eigenvalues = wishartEigenvalues(noise, degreesOfFreedom, dimensions);
        LogVector shift(dimensions);
        for (Eigen::Index i = dimensions; i > 0; --i) // the last first
            shift(i - 1) = noise();
        shift /= std::sqrt(double(squeezes));
        gate = contentQuantile(eigenvalues, shift, quantiles);
    }
    const auto place = std::min<std::ptrdiff_t>(draws - 1, std::ptrdiff_t(std::ceil(confidence * draws)));
    std::nth_element(gates.begin(), gates.begin() + place, gates.end());
    return gates[std::size_t(place)];
}

/// Simulated gates, each once in the life of the program.
double rememberedGate(int squeezes, double degreesOfFreedom, double rate, double confidence, int dimensions)
{
    static std::mutex guard;
    static std::map<std::tuple<int, double, double, double, int>, double> known;
    const std::tuple key(squeezes, degreesOfFreedom, rate, confidence, dimensions);
    const std::lock_guard lock(guard);
    const auto found = known.find(key);
    if (found != known.end())
        return found->second;
    constexpr std::size_t most = 10'000; // what a few libraries need; then it starts again
    if (known.size() >= most)
        known.clear();
    return known[key] = simulatedGate(squeezes, degreesOfFreedom, rate, confidence, dimensions);
}

/// The nodes about a number of degrees of freedom.
std::pair<double, double> nodesAbout(double degreesOfFreedom)
{
    if (degreesOfFreedom <= wholeNodes) {
        const double below = std::floor(degreesOfFreedom + 1e-6);
        return {below, degreesOfFreedom - below < 1e-6 ? below : below + 1};
    }
    double below = wholeNodes;
    while (below * nodeRatio <= degreesOfFreedom)
        below *= nodeRatio;
    return {below, below * nodeRatio};
}

} // namespace

std::optional<double> toleranceGate(int squeezes, double degreesOfFreedom, double rate, double confidence,
                                    int dimensions)
{
    const bool possible = squeezes >= 1 && dimensions >= 1 && dimensions <= mostDimensions &&
                          degreesOfFreedom >= dimensions && rate > 0 && rate < 1 && confidence > 0 &&
                          confidence < 1;
    if (!possible)
        return {};
    const auto nodes = nodesAbout(std::min(degreesOfFreedom, asGoodAsKnown));
    const double below = rememberedGate(squeezes, nodes.first, rate, confidence, dimensions);
    if (nodes.first == nodes.second)
        return below;
    const double above = rememberedGate(squeezes, nodes.second, rate, confidence, dimensions);
    // The logarithm is nearly straight in 1/v.
    const double v = std::min(degreesOfFreedom, asGoodAsKnown);
    const double share = (1 / nodes.first - 1 / v) / (1 / nodes.first - 1 / nodes.second);
    const double gate = std::exp((1 - share) * std::log(below) + share * std::log(above));
    return std::isfinite(gate) ? std::optional(gate) : std::nullopt;
}

} // namespace gripscope
