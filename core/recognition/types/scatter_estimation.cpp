// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/scatter_estimation.h"

#include "core/math/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <array>
#include <map>
#include <utility>

namespace gripscope {

namespace {

/// Sums before they are divided.
struct Sums {
    PartScatter scatter;
    double inverse = 0;
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    double noiseWeight = 0;

    void add(const std::vector<LogSqueeze>& squeezes)
    {
        const std::vector<PartSqueezes> parts = byPart(squeezes);
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const PartSqueezes& part : parts)
            mean += meanOf(part) / double(parts.size());
        // 1 - 1/n: what a squeeze's own noise leaves of itself in its distance from the mean.
        const double weight = 1 - 1.0 / double(parts.size());
        for (const PartSqueezes& part : parts) {
            const Eigen::Vector3d partMean = meanOf(part);
            scatter.between += (partMean - mean) * (partMean - mean).transpose();
            for (const LogSqueeze* squeeze : part) {
                const Eigen::Vector3d difference = squeeze->x - partMean;
                scatter.within += difference * difference.transpose();
                addNoise(*squeeze, part.size() > 1 || weight == 0 ? 1 : weight);
            }
            scatter.withinDegrees += int(part.size()) - 1;
            inverse += weight / double(part.size());
        }
        scatter.betweenDegrees += int(parts.size()) - 1;
    }

private:
    void addNoise(const LogSqueeze& squeeze, double weight)
    {
        if (!squeeze.noise)
            return;
        noise += weight * *squeeze.noise;
        noiseWeight += weight;
    }
};

} // namespace

std::vector<PartSqueezes> byPart(const std::vector<LogSqueeze>& squeezes)
{
    std::vector<PartSqueezes> parts;
    std::map<int, std::size_t> places;
    for (const LogSqueeze& squeeze : squeezes) {
        const auto known = squeeze.part < 0 ? places.end() : places.find(squeeze.part);
        if (known != places.end()) {
            parts[known->second].push_back(&squeeze);
            continue;
        }
        if (squeeze.part >= 0)
            places[squeeze.part] = parts.size();
        parts.push_back({&squeeze});
    }
    return parts;
}

Eigen::Vector3d meanOf(const PartSqueezes& squeezes)
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const LogSqueeze* squeeze : squeezes)
        mean += squeeze->x / double(squeezes.size());
    return mean;
}

PartScatter partScatter(const std::vector<std::vector<LogSqueeze>>& types)
{
    Sums sums;
    for (const std::vector<LogSqueeze>& squeezes : types)
        if (!squeezes.empty())
            sums.add(squeezes);
    PartScatter& scatter = sums.scatter;
    if (scatter.betweenDegrees > 0) {
        scatter.between /= scatter.betweenDegrees;
        scatter.meanInverse = sums.inverse / scatter.betweenDegrees;
    }
    if (scatter.withinDegrees > 0)
        scatter.within /= scatter.withinDegrees;
    if (sums.noiseWeight > 0)
        scatter.noise = sums.noise / sums.noiseWeight;
    return scatter;
}

namespace {

constexpr int entries = 6;
constexpr std::array<std::pair<int, int>, entries> entryAt{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

constexpr int mostIterations = 40;
constexpr double convergedStep = 1e-9;
/// Keeps S + C invertible where both are zero; the pooled covariance is one.
constexpr double leastLikelyVariance = 1e-9;

using Information = Eigen::Matrix<double, entries, entries>;
using Entries = Eigen::Matrix<double, entries, 1>;

/// tr(P E_a Q E_b) with E_a = e_i e_j' + e_j e_i' (e_i e_i' on the diagonal), for symmetric P and Q.
double traceOf(const Eigen::Matrix3d& p, int a, const Eigen::Matrix3d& q, int b)
{
    const auto [i, j] = entryAt[std::size_t(a)];
    const auto [k, l] = entryAt[std::size_t(b)];
    double sum = p(l, i) * q(j, k);
    if (i != j)
        sum += p(l, j) * q(i, k);
    if (k != l)
        sum += p(k, i) * q(j, l);
    if (i != j && k != l)
        sum += p(k, j) * q(i, l);
    return sum;
}

Eigen::Matrix3d fromEntries(const Entries& values)
{
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for (int a = 0; a < entries; ++a) {
        const auto [i, j] = entryAt[std::size_t(a)];
        result(i, j) = values(a);
        result(j, i) = values(a);
    }
    return result;
}

/// X_a += P E_a P
void addProducts(std::array<Eigen::Matrix3d, entries>& sums, const Eigen::Matrix3d& p)
{
    for (int a = 0; a < entries; ++a) {
        const auto [i, j] = entryAt[std::size_t(a)];
        if (i == j)
            sums[std::size_t(a)] += p.col(i) * p.col(i).transpose();
        else
            sums[std::size_t(a)] += p.col(i) * p.col(j).transpose() + p.col(j) * p.col(i).transpose();
    }
}

/// Score and expected information of the entries of S, summed over types.
struct Derivatives {
    Eigen::Matrix3d score = Eigen::Matrix3d::Zero(); ///< half its product with E_a, traced, is the score
    Information information = Information::Zero();

    void add(const std::vector<WhitenedSqueeze>& squeezes, const Eigen::Matrix3d& between)
    {
        if (squeezes.size() < 2)
            return; // one squeeze says only where its type is
        std::vector<Eigen::Matrix3d> precisions;
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
        for (const WhitenedSqueeze& squeeze : squeezes) {
            Eigen::Matrix3d covariance = between + squeeze.noise;
            covariance.diagonal().array() += leastLikelyVariance;
            precisions.push_back(covariance.inverse());
            sum += precisions.back();
            weighted += precisions.back() * squeeze.x;
        }
        const Eigen::Matrix3d meanCovariance = sum.inverse();
        const Eigen::Vector3d mean = meanCovariance * weighted;
        std::array<Eigen::Matrix3d, entries> products;
        products.fill(Eigen::Matrix3d::Zero());
        for (std::size_t j = 0; j < squeezes.size(); ++j) {
            const Eigen::Matrix3d& p = precisions[j];
            const Eigen::Matrix3d q = p * meanCovariance * p;
            const Eigen::Vector3d residual = p * (squeezes[j].x - mean);
            score += residual * residual.transpose() - p + q;
            addProducts(products, p);
            for (int a = 0; a < entries; ++a)
                for (int b = 0; b <= a; ++b)
                    information(a, b) +=
                        (traceOf(p, a, p, b) - traceOf(p, a, q, b) - traceOf(q, a, p, b)) / 2;
        }
        for (int a = 0; a < entries; ++a)
            for (int b = 0; b <= a; ++b)
                information(a, b) += (meanCovariance * products[std::size_t(a)] * meanCovariance)
                                         .cwiseProduct(products[std::size_t(b)])
                                         .sum() /
                                     2;
    }

    [[nodiscard]] Entries gradient() const
    {
        Entries result;
        for (int a = 0; a < entries; ++a) {
            const auto [i, j] = entryAt[std::size_t(a)];
            result(a) = i == j ? score(i, j) / 2 : score(i, j);
        }
        return result;
    }
};

Eigen::Matrix3d withoutNegativeParts(const Eigen::Matrix3d& matrix)
{
    const SymmetricAxes eigen = symmetricAxes(matrix);
    return eigen.directions * eigen.values.cwiseMax(0).asDiagonal() * eigen.directions.transpose();
}

} // namespace

double expectedSquare(const SymmetricCovariance& covariance, const Eigen::Matrix3d& p)
{
    double sum = 0;
    for (int a = 0; a < entries; ++a)
        for (int b = 0; b < entries; ++b)
            sum += covariance(a, b) * traceOf(p, a, p, b);
    return sum;
}

SymmetricCovariance wishartCovariance(const Eigen::Matrix3d& v, double degreesOfFreedom)
{
    SymmetricCovariance result;
    for (int a = 0; a < entries; ++a) {
        for (int b = 0; b < entries; ++b) {
            const auto [i, j] = entryAt[std::size_t(a)];
            const auto [k, l] = entryAt[std::size_t(b)];
            result(a, b) = (v(i, k) * v(j, l) + v(i, l) * v(j, k)) / degreesOfFreedom;
        }
    }
    return result;
}

SymmetricCovariance transformed(const SymmetricCovariance& covariance, const Eigen::Matrix3d& t)
{
    Information map; // column b: entries of T E_b T'
    for (int b = 0; b < entries; ++b) {
        Entries unit = Entries::Zero();
        unit(b) = 1;
        const Eigen::Matrix3d moved = t * fromEntries(unit) * t.transpose();
        for (int a = 0; a < entries; ++a)
            map(a, b) = moved(entryAt[std::size_t(a)].first, entryAt[std::size_t(a)].second);
    }
    return map * covariance * map.transpose();
}

ScatterLikelihood maximizeLikelihood(const std::vector<std::vector<WhitenedSqueeze>>& types,
                                     const Eigen::Matrix3d& start)
{
    ScatterLikelihood result;
    result.between = withoutNegativeParts(start);
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        Derivatives derivatives;
        for (const std::vector<WhitenedSqueeze>& type : types)
            derivatives.add(type, result.between);
        const Information information = derivatives.information.selfadjointView<Eigen::Lower>();
        const Eigen::LDLT<Information> solver(information);
        if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0))
            return result;
        result.uncertainty = solver.solve(Information::Identity());
        const Eigen::Matrix3d step = fromEntries(solver.solve(derivatives.gradient()));
        if (!step.allFinite())
            return result;
        const Eigen::Matrix3d next = withoutNegativeParts(result.between + step);
        const double moved = (next - result.between).norm();
        result.between = next;
        if (moved < convergedStep) {
            result.converged = result.uncertainty.allFinite();
            return result;
        }
    }
    // At the edge of what S may be the steps only shorten slowly; the place is good, if not exact.
    result.converged = result.uncertainty.allFinite();
    return result;
}

} // namespace gripscope
