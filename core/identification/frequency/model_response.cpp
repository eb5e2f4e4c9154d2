// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/frequency/frequency_response.h"
#include "core/identification/model/lag_alignment.h"
#include "core/identification/periodic/periodic_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// Of (ln m, ln b, ln k).
Eigen::Matrix3d relativeCovariance(const MassDampingStiffness& parameters, const Eigen::Matrix3d& covariance)
{
    const Eigen::Vector3d inverse = parameters.vector().cwiseInverse();
    return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

double standardError(const Eigen::Vector3d& gradient, const Eigen::Matrix3d& covariance)
{
    return std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
}

} // namespace

std::vector<ModelLine> modelResponse(const MassDampingStiffness& parameters,
                                     const std::optional<Eigen::Matrix3d>& covariance,
                                     const ResponseSampling& sampling, std::span<const double> frequencies_Hz)
{
    const double T = sampling.sampleTime_s;
    if (!(T > 0) || !(parameters.vector().minCoeff() > 0))
        return {};
    const Eigen::Vector3d theta(std::log(parameters.m / (T * T)), std::log(parameters.b / T),
                                std::log(parameters.k));
    const LagAlignment lag(sampling.lag_s, T);
    const PeriodicResponse response(theta, sampling.hold, lag.rest);
    if (!response.finite())
        return {};
    const Eigen::Matrix3d spread =
        relativeCovariance(parameters, covariance.value_or(Eigen::Matrix3d::Zero()));
    std::vector<ModelLine> lines;
    lines.reserve(frequencies_Hz.size());
    for (const double frequency : frequencies_Hz) {
        const double radians = 2 * std::numbers::pi * frequency * T;
        const PeriodicResponse::Value value = response.at(radians, 1);
        if (!(std::abs(value.position) > 0))
            continue; // below the smallest number
        const Eigen::Matrix<Complex, 3, 1> relative = value.gradient / value.position;
        ModelLine line;
        line.frequency_Hz = frequency;
        line.response =
            value.position *
            std::polar(1.0, std::remainder(radians * static_cast<double>(lag.samples), 2 * std::numbers::pi));
        line.relativeError = standardError(relative.real(), spread);
        line.phaseError = standardError(relative.imag(), spread);
        const double before = lines.empty() ? 0 : lines.back().phase;
        line.phase = before + std::remainder(std::arg(line.response) - before, 2 * std::numbers::pi);
        lines.push_back(line);
    }
    return lines;
}

std::vector<double> logarithmicFrequencies(double low_Hz, double high_Hz, std::size_t count)
{
    std::vector<double> result;
    if (!(low_Hz > 0) || !(high_Hz > low_Hz) || count < 2)
        return result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(low_Hz *
                         std::pow(high_Hz / low_Hz, static_cast<double>(i) / static_cast<double>(count - 1)));
    result.back() = high_Hz;
    return result;
}

} // namespace gripscope
