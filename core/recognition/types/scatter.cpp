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

/// Fewer degrees of freedom say too little about the six entries of S to weigh squeezes by it.
constexpr double enoughForLikelihood = 8;

/// p (p + 1): the expected square of a Wishart matrix of unit mean is this over its degrees of freedom.
constexpr double squareTimesDegrees = 12;

Eigen::Matrix3d lowerFactor(const Eigen::Matrix3d& covariance)
{
    return covariance.llt().matrixL();
}

/// L^-1 M L^-T
Eigen::Matrix3d whitened(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& factor)
{
    const auto lower = factor.triangularView<Eigen::Lower>();
    const Eigen::Matrix3d half = lower.solve(matrix);
    const Eigen::Matrix3d full = lower.solve(half.transpose().eval());
    return (full + full.transpose()) / 2;
}

/// The pooled covariance of whole squeezes, S + C, and how uncertain it is, in its own metric.
void pool(const PartScatter& parts, Scatter& scatter)
{
    Eigen::Matrix3d pooled;
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
    scatter.shrinkage = std::max(leastShrinkage, 1 / (1 + v * v * v));
    scatter.total = (1 - scatter.shrinkage) * pooled;
    scatter.total.diagonal() = pooled.diagonal();
    scatter.factor = lowerFactor(scatter.total);
    if (scatter.degreesOfFreedom > 0) {
        scatter.uncertainty = wishartCovariance(Eigen::Matrix3d::Identity(), scatter.degreesOfFreedom);
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
    const SymmetricAxes eigen =
        symmetricAxes(whitened(parts.between - parts.meanInverse * parts.within, scatter.factor));
    const Eigen::Matrix3d half =
        scatter.factor * eigen.directions * eigen.values.cwiseMax(0).cwiseSqrt().asDiagonal();
    scatter.partToPart = half * half.transpose();
}

/// Takes the known noise out of the total: S, G and G C G'.
void separateNoise(const Eigen::Matrix3d& noise, Scatter& scatter)
{
    const SymmetricAxes eigen = symmetricAxes(whitened(noise, scatter.factor));
    const Eigen::Vector3d shares = eigen.values.cwiseMax(0); // of the total that is noise
    const Eigen::Matrix3d axes = scatter.factor * eigen.directions;
    scatter.between = axes * (1 - shares.array()).cwiseMax(0).matrix().asDiagonal() * axes.transpose();
    scatter.noise = axes * shares.cwiseMin(1).asDiagonal() * axes.transpose();
    const Eigen::Vector3d roots = shares.cwiseMax(1).cwiseSqrt().cwiseInverse();
    scatter.noiseFactor = axes * roots.asDiagonal() * axes.inverse();
}

Eigen::Matrix3d scaledNoise(const Scatter& scatter, const Eigen::Matrix3d& noise)
{
    return scatter.noiseFactor * noise * scatter.noiseFactor.transpose();
}

bool noiseIsAlike(const std::vector<std::vector<LogSqueeze>>& types, const Eigen::Matrix3d& average,
                  const Eigen::Matrix3d& factor)
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
            const Eigen::Matrix3d noise =
                squeeze.noise ? scaledNoise(scatter, *squeeze.noise) : scatter.noise;
            type.push_back({scatter.factor.triangularView<Eigen::Lower>().solve(squeeze.x),
                            whitened(noise, scatter.factor)});
        }
        whitenedTypes.push_back(std::move(type));
    }
    const ScatterLikelihood found =
        maximizeLikelihood(whitenedTypes, whitened(scatter.between, scatter.factor));
    if (!found.converged)
        return;
    const Eigen::Matrix3d between = scatter.factor * found.between * scatter.factor.transpose();
    const Eigen::Matrix3d total = between + scatter.noise;
    const Eigen::LLT<Eigen::Matrix3d> cholesky(total);
    if (cholesky.info() != Eigen::Success || !total.allFinite())
        return;
    // The uncertainty belongs to the coordinates of the new total.
    const Eigen::Matrix3d turn =
        Eigen::Matrix3d(cholesky.matrixL()).triangularView<Eigen::Lower>().solve(scatter.factor);
    scatter.uncertainty = transformed(found.uncertainty, turn);
    scatter.between = between;
    scatter.total = total;
    scatter.factor = cholesky.matrixL();
    scatter.degreesOfFreedom = degreesOfFreedom(scatter, total);
}

/// All but whether the scatter is alike in m, b and k.
Scatter estimateCovariances(const std::vector<std::vector<LogSqueeze>>& types)
{
    Scatter scatter;
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
    if (parts.withinDegrees == 0 && scatter.degreesOfFreedom >= enoughForLikelihood &&
        !noiseIsAlike(types, *parts.noise, scatter.factor))
        refine(types, scatter);
    return scatter;
}

} // namespace

Scatter estimateScatter(const std::vector<std::vector<LogSqueeze>>& types)
{
    Scatter scatter = estimateCovariances(types);
    scatter.alikeVariance = alikeVariance(scatter);
    return scatter;
}

Eigen::Matrix3d covarianceOfSqueeze(const Scatter& scatter, const std::optional<Eigen::Matrix3d>& noise)
{
    if (!noise)
        return scatter.total;
    if (!scatter.noiseKnown) {
        const SymmetricAxes eigen = symmetricAxes(whitened(*noise, scatter.factor));
        const Eigen::Matrix3d axes = scatter.factor * eigen.directions;
        return axes * eigen.values.cwiseMax(1).asDiagonal() * axes.transpose();
    }
    const Eigen::Matrix3d own = scatter.between + scaledNoise(scatter, *noise);
    const double enough = std::max(3.0, scatter.degreesOfFreedom / 2);
    if (scatter.degreesOfFreedom < 3 || degreesOfFreedom(scatter, own) >= enough)
        return own;
    double low = 0, high = 1;
    for (int halving = 0; halving < 10; ++halving) {
        const double middle = (low + high) / 2;
        (degreesOfFreedom(scatter, own + middle * scatter.noise) >= enough ? high : low) = middle;
    }
    return own + high * scatter.noise;
}

double degreesOfFreedom(const Scatter& scatter, const Eigen::Matrix3d& covariance)
{
    constexpr double most = 1e6; // as good as known
    const Eigen::LLT<Eigen::Matrix3d> cholesky(whitened(covariance, scatter.factor));
    if (cholesky.info() != Eigen::Success)
        return 0;
    const Eigen::Matrix3d precision = cholesky.solve(Eigen::Matrix3d::Identity());
    const double square = expectedSquare(scatter.uncertainty, precision);
    const double found = square * most > squareTimesDegrees ? squareTimesDegrees / square : most;
    // A squeeze like those enrolled has v, not v less a rounding error: at v = 3 a gate depends on it.
    const double v = scatter.degreesOfFreedom;
    return std::abs(found - v) < 1e-9 * v ? v : found;
}

TypeMean estimateMean(const Scatter& scatter, const std::vector<LogSqueeze>& squeezes)
{
    TypeMean result;
    const std::vector<PartSqueezes> parts = byPart(squeezes);
    const bool weighted = scatter.noiseKnown && parts.size() == squeezes.size();
    if (!weighted) {
        double inverse = 0;
        for (const PartSqueezes& part : parts) {
            result.mean += meanOf(part) / double(parts.size());
            inverse += 1 / double(part.size()) / double(parts.size());
        }
        const Eigen::Matrix3d within = scatter.regrip.value_or(Eigen::Matrix3d::Zero());
        const Eigen::Matrix3d ofPart =
            scatter.partToPart ? Eigen::Matrix3d(*scatter.partToPart + inverse * within) : scatter.total;
        result.covariance =
            (scatter.regrip && !scatter.partToPart ? Eigen::Matrix3d(inverse * within) : ofPart) /
            double(parts.size());
        return result;
    }
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weightedSum = Eigen::Vector3d::Zero();
    const auto lower = scatter.factor.triangularView<Eigen::Lower>();
    for (const LogSqueeze& squeeze : squeezes) {
        const Eigen::Matrix3d covariance =
            squeeze.noise ? Eigen::Matrix3d(scatter.between + scaledNoise(scatter, *squeeze.noise))
                          : scatter.total;
        const Eigen::Matrix3d precision = whitened(covariance, scatter.factor).inverse();
        sum += precision;
        weightedSum += precision * lower.solve(squeeze.x - squeezes.front().x);
    }
    const Eigen::Matrix3d inverse = sum.inverse();
    result.mean = squeezes.front().x + scatter.factor * inverse * weightedSum;
    result.covariance = scatter.factor * inverse * scatter.factor.transpose();
    return result;
}

} // namespace gripscope
