// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/scatter.h"

#include "core/math/decompositions.h"
#include "core/recognition/types/own_spread.h"
#include "core/recognition/types/scatter_estimation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// No instrument repeats better than to a ten-thousandth. It keeps squeezes that are copies of each other (a
/// file enrolled twice) from giving a covariance of zero.
constexpr double leastScatter = 1e-4;

/// Keeps the covariance invertible in double precision when m, b and k of many squeezes go exactly together.
constexpr double leastShrinkage = 1e-10;

/// Where no C differs from the average by more than this share of the scatter, likelihood gains nothing.
constexpr double alikeNoise = 0.1;

/// Fewer degrees of freedom say too little about the entries of S (six of p = 3) to weigh squeezes by it.
double enoughForLikelihood(Eigen::Index p)
{
    return double(p * (p + 1)) / 2 + 2;
}

/// The expected square of a Wishart matrix of unit mean is this over its degrees of freedom.
double squareTimesDegrees(Eigen::Index p)
{
    return double(p * (p + 1));
}

/// Zeros of the size of the squeezes; of m, b, k where there are none.
Scatter nothingKnown(const std::vector<std::vector<LogSqueeze>>& types)
{
    Scatter scatter;
    for (const std::vector<LogSqueeze>& squeezes : types) {
        if (squeezes.empty())
            continue;
        const Eigen::Index p = squeezes.front().x.size();
        scatter.between = scatter.noise = scatter.total = scatter.factor = LogMatrix::Zero(p, p);
        scatter.noiseFactor = LogMatrix::Identity(p, p);
        scatter.uncertainty = SymmetricCovariance::Zero(p * (p + 1) / 2, p * (p + 1) / 2);
        return scatter;
    }
    return scatter;
}

LogMatrix lowerFactor(const LogMatrix& covariance)
{
    return covariance.llt().matrixL();
}

/// L^-1 M L^-T
LogMatrix whitened(const LogMatrix& matrix, const LogMatrix& factor)
{
    const auto lower = factor.triangularView<Eigen::Lower>();
    const LogMatrix half = lower.solve(matrix);
    const LogMatrix full = lower.solve(half.transpose().eval());
    return (full + full.transpose()) / 2;
}

/// The pooled covariance of whole squeezes, S + C, and how uncertain it is, in its own metric.
void pool(const PartScatter& parts, Scatter& scatter)
{
    LogMatrix pooled;
    if (parts.withinDegrees == 0) {
        pooled = parts.between;
        scatter.degreesOfFreedom = parts.betweenDegrees;
    } else if (parts.betweenDegrees == 0) {
        pooled = parts.within;
        scatter.degreesOfFreedom = parts.withinDegrees;
    } else {
        pooled = parts.between + (1 - parts.meanInverse) * parts.within;
    }
    pooled.diagonal() = pooled.diagonal().cwiseMax(leastScatter * leastScatter);
    const double v = parts.betweenDegrees + parts.withinDegrees;
    double power = v * v * v;
    for (Eigen::Index i = 3; i < pooled.rows(); ++i)
        power *= v;
    scatter.shrinkage = std::max(leastShrinkage, 1 / (1 + power));
    scatter.total = (1 - scatter.shrinkage) * pooled;
    scatter.total.diagonal() = pooled.diagonal();
    scatter.factor = lowerFactor(scatter.total);
    if (scatter.degreesOfFreedom > 0) {
        scatter.uncertainty =
            wishartCovariance(LogMatrix::Identity(pooled.rows(), pooled.rows()), scatter.degreesOfFreedom);
        return;
    }
    scatter.uncertainty = wishartCovariance(whitened(parts.between, scatter.factor), parts.betweenDegrees) +
                          wishartCovariance((1 - parts.meanInverse) * whitened(parts.within, scatter.factor),
                                            parts.withinDegrees);
    scatter.degreesOfFreedom = degreesOfFreedom(scatter, scatter.total);
}

void separateParts(const PartScatter& parts, Scatter& scatter)
{
    if (parts.withinDegrees == 0)
        return;
    scatter.regrip = parts.within;
    if (parts.betweenDegrees == 0)
        return;
    const SmallSymmetricAxes eigen =
        smallSymmetricAxes(whitened(parts.between - parts.meanInverse * parts.within, scatter.factor));
    const LogMatrix half =
        scatter.factor * eigen.directions * eigen.values.cwiseMax(0).cwiseSqrt().asDiagonal();
    scatter.partToPart = half * half.transpose();
}

/// Takes the known noise out of the total: S, G and G C G'.
void separateNoise(const LogMatrix& noise, Scatter& scatter)
{
    const SmallSymmetricAxes eigen = smallSymmetricAxes(whitened(noise, scatter.factor));
    const LogVector shares = eigen.values.cwiseMax(0); // of the total that is noise
    const LogMatrix axes = scatter.factor * eigen.directions;
    scatter.between = axes * (1 - shares.array()).cwiseMax(0).matrix().asDiagonal() * axes.transpose();
    scatter.noise = axes * shares.cwiseMin(1).asDiagonal() * axes.transpose();
    const LogVector roots = shares.cwiseMax(1).cwiseSqrt().cwiseInverse();
    scatter.noiseFactor = axes * roots.asDiagonal() * axes.inverse();
}

LogMatrix scaledNoise(const Scatter& scatter, const LogMatrix& noise)
{
    return scatter.noiseFactor * noise * scatter.noiseFactor.transpose();
}

bool noiseIsAlike(const std::vector<std::vector<LogSqueeze>>& types, const LogMatrix& average,
                  const LogMatrix& factor)
{
    for (const std::vector<LogSqueeze>& squeezes : types)
        for (const LogSqueeze& squeeze : squeezes)
            if (squeeze.noise && whitened(*squeeze.noise - average, factor).norm() > alikeNoise)
                return false;
    return true;
}

/// S by restricted maximum likelihood, where squeezes of unlike noise make it better than the pooled
/// difference.
void refine(const std::vector<std::vector<LogSqueeze>>& types, Scatter& scatter)
{
    std::vector<std::vector<WhitenedSqueeze>> whitenedTypes;
    for (const std::vector<LogSqueeze>& squeezes : types) {
        std::vector<WhitenedSqueeze> type;
        for (const LogSqueeze& squeeze : squeezes) {
            const LogMatrix noise = squeeze.noise ? scaledNoise(scatter, *squeeze.noise) : scatter.noise;
            type.push_back({scatter.factor.triangularView<Eigen::Lower>().solve(squeeze.x),
                            whitened(noise, scatter.factor)});
        }
        whitenedTypes.push_back(std::move(type));
    }
    const ScatterLikelihood found =
        maximizeLikelihood(whitenedTypes, whitened(scatter.between, scatter.factor));
    if (!found.converged)
        return;
    const LogMatrix between = scatter.factor * found.between * scatter.factor.transpose();
    const LogMatrix total = between + scatter.noise;
    const Eigen::LLT<LogMatrix> cholesky(total);
    if (cholesky.info() != Eigen::Success || !total.allFinite())
        return;
    // The uncertainty belongs to the coordinates of the new total.
    const LogMatrix turn = LogMatrix(cholesky.matrixL()).triangularView<Eigen::Lower>().solve(scatter.factor);
    scatter.uncertainty = transformed(found.uncertainty, turn);
    scatter.between = between;
    scatter.total = total;
    scatter.factor = cholesky.matrixL();
    scatter.degreesOfFreedom = degreesOfFreedom(scatter, total);
}

/// All but whether the scatter is alike in m, b and k.
Scatter estimateCovariances(const std::vector<std::vector<LogSqueeze>>& types)
{
    Scatter scatter = nothingKnown(types);
    const PartScatter parts = partScatter(types);
    if (parts.betweenDegrees + parts.withinDegrees == 0)
        return scatter;
    pool(parts, scatter);
    separateParts(parts, scatter);
    scatter.between = scatter.total;
    scatter.noiseKnown = parts.noise.has_value();
    if (!parts.noise)
        return scatter;
    separateNoise(*parts.noise, scatter);
    if (parts.withinDegrees == 0 && scatter.degreesOfFreedom >= enoughForLikelihood(scatter.total.rows()) &&
        !noiseIsAlike(types, *parts.noise, scatter.factor))
        refine(types, scatter);
    return scatter;
}

} // namespace

Scatter estimateScatter(const std::vector<std::vector<LogSqueeze>>& types, bool alike)
{
    Scatter scatter = estimateCovariances(types);
    if (alike)
        scatter.alikeVariance = alikeVariance(scatter);
    return scatter;
}

LogMatrix covarianceOfSqueeze(const Scatter& scatter, const std::optional<LogMatrix>& noise)
{
    if (!noise)
        return scatter.total;
    if (!scatter.noiseKnown) {
        const SmallSymmetricAxes eigen = smallSymmetricAxes(whitened(*noise, scatter.factor));
        const LogMatrix axes = scatter.factor * eigen.directions;
        return axes * eigen.values.cwiseMax(1).asDiagonal() * axes.transpose();
    }
    const LogMatrix own = scatter.between + scaledNoise(scatter, *noise);
    const auto p = double(own.rows());
    const double enough = std::max(p, scatter.degreesOfFreedom / 2);
    if (scatter.degreesOfFreedom < p || degreesOfFreedom(scatter, own) >= enough)
        return own;
    double low = 0, high = 1;
    for (int halving = 0; halving < 10; ++halving) {
        const double middle = (low + high) / 2;
        (degreesOfFreedom(scatter, own + middle * scatter.noise) >= enough ? high : low) = middle;
    }
    return own + high * scatter.noise;
}

double degreesOfFreedom(const Scatter& scatter, const LogMatrix& covariance)
{
    constexpr double most = 1e6; // as good as known
    const Eigen::LLT<LogMatrix> cholesky(whitened(covariance, scatter.factor));
    if (cholesky.info() != Eigen::Success)
        return 0;
    const LogMatrix precision = cholesky.solve(LogMatrix::Identity(covariance.rows(), covariance.rows()));
    const double square = expectedSquare(scatter.uncertainty, precision);
    const double known = squareTimesDegrees(covariance.rows());
    const double found = square * most > known ? known / square : most;
    // A squeeze like those enrolled has v, not v less a rounding error: at v = p a gate depends on it.
    const double v = scatter.degreesOfFreedom;
    return std::abs(found - v) < 1e-9 * v ? v : found;
}

TypeMean estimateMean(const Scatter& scatter, const std::vector<LogSqueeze>& squeezes)
{
    const Eigen::Index p = scatter.total.rows();
    TypeMean result;
    const std::vector<PartSqueezes> parts = byPart(squeezes);
    const bool weighted = scatter.noiseKnown && parts.size() == squeezes.size();
    if (!weighted) {
        result.mean = LogVector::Zero(p);
        double inverse = 0;
        for (const PartSqueezes& part : parts) {
            result.mean += meanOf(part) / double(parts.size());
            inverse += 1 / double(part.size()) / double(parts.size());
        }
        const LogMatrix within = scatter.regrip.value_or(LogMatrix::Zero(p, p));
        const LogMatrix ofPart =
            scatter.partToPart ? LogMatrix(*scatter.partToPart + inverse * within) : scatter.total;
        result.covariance = (scatter.regrip && !scatter.partToPart ? LogMatrix(inverse * within) : ofPart) /
                            double(parts.size());
        return result;
    }
    LogMatrix sum = LogMatrix::Zero(p, p);
    LogVector weightedSum = LogVector::Zero(p);
    const auto lower = scatter.factor.triangularView<Eigen::Lower>();
    for (const LogSqueeze& squeeze : squeezes) {
        const LogMatrix covariance =
            squeeze.noise ? LogMatrix(scatter.between + scaledNoise(scatter, *squeeze.noise)) : scatter.total;
        const LogMatrix precision = whitened(covariance, scatter.factor).inverse();
        sum += precision;
        weightedSum += precision * lower.solve(squeeze.x - squeezes.front().x);
    }
    const LogMatrix inverse = sum.inverse();
    result.mean = squeezes.front().x + scatter.factor * inverse * weightedSum;
    result.covariance = scatter.factor * inverse * scatter.factor.transpose();
    return result;
}

} // namespace gripscope
