// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/frequency/frequency_response.h"
#include "core/math/fourier.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t shortestSection = 32, longestSection = 2048;
constexpr std::size_t fewestSections = 8;
constexpr std::size_t firstBin = 2;           ///< half the main lobe of a Hann window
constexpr double windowCorrelation = 1.0 / 6; ///< of two Hann windows that overlap by half
/// Of the largest line's power: less is rounding, not force.
constexpr double leastPower = 1e-20;

struct Spectra {
    std::vector<double> force, position;
    std::vector<Complex> cross; ///< conj(U) Y
    std::size_t sections = 0, neighbours = 0;
};

std::vector<double> hannWindow(std::size_t count)
{
    std::vector<double> window(count);
    for (std::size_t t = 0; t < count; ++t)
        window[t] =
            0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(t) / static_cast<double>(count));
    return window;
}

/// The transform of both channels at once, force as the real part and position as the imaginary one.
std::vector<Complex> windowed(std::span<const double> force, std::span<const double> position,
                              const std::vector<double>& window)
{
    Complex mean = 0;
    double weight = 0;
    for (std::size_t t = 0; t < window.size(); ++t) {
        mean += window[t] * Complex(force[t], position[t]);
        weight += window[t];
    }
    mean /= weight;
    std::vector<Complex> values(window.size());
    for (std::size_t t = 0; t < window.size(); ++t)
        values[t] = window[t] * (Complex(force[t], position[t]) - mean);
    powerOfTwoTransform(values);
    return values;
}

/// To unit size, so that neither products nor the two channels beside each other lose digits.
std::vector<double> scaled(std::span<const double> values, double& scale)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    scale = *high - *low;
    const double middle = *low + scale / 2;
    std::vector<double> result(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size() && scale > 0; ++i)
        result[i] = (values[i] - middle) / scale;
    return result;
}

Spectra averagedSpectra(const std::vector<double>& force, const std::vector<double>& position,
                        std::size_t section, std::span<const std::size_t> lost)
{
    const std::vector<double> window = hannWindow(section);
    Spectra sum{std::vector<double>(section / 2), std::vector<double>(section / 2),
                std::vector<Complex>(section / 2), 0, 0};
    bool before = false; // the section before this one counted
    for (std::size_t begin = 0; begin + section <= force.size(); begin += section / 2) {
        const auto gap = std::lower_bound(lost.begin(), lost.end(), begin);
        if (gap != lost.end() && *gap < begin + section) {
            before = false;
            continue;
        }
        const std::vector<Complex> both = windowed(std::span(force).subspan(begin, section),
                                                   std::span(position).subspan(begin, section), window);
        for (std::size_t q = 1; q < section / 2; ++q) {
            const Complex u = (both[q] + std::conj(both[section - q])) / 2.0;
            const Complex y = (both[q] - std::conj(both[section - q])) / Complex(0, 2);
            sum.force[q] += std::norm(u);
            sum.position[q] += std::norm(y);
            sum.cross[q] += std::conj(u) * y;
        }
        ++sum.sections;
        sum.neighbours += before ? 1 : 0;
        before = true;
    }
    return sum;
}

} // namespace

EmpiricalResponse empiricalResponse(std::span<const double> force, std::span<const double> position,
                                    double sampleTime_s, std::span<const std::size_t> lost)
{
    EmpiricalResponse result;
    if (force.size() < EmpiricalResponse::leastSamples || position.size() != force.size() ||
        !(sampleTime_s > 0))
        return result;
    const std::size_t section = std::clamp(std::bit_floor(force.size() / 7), shortestSection, longestSection);
    double forceScale = 0, positionScale = 0;
    const std::vector<double> u = scaled(force, forceScale);
    const std::vector<double> y = scaled(position, positionScale);
    if (!(forceScale > 0)) {
        result.status = EmpiricalResponse::Status::NotExcited;
        return result;
    }
    const Spectra spectra = averagedSpectra(u, y, section, lost);
    if (spectra.sections < fewestSections)
        return result;
    result.status = EmpiricalResponse::Status::Found;
    result.sectionSamples = section;
    result.sections = spectra.sections;
    const auto count = static_cast<double>(spectra.sections);
    const double shared = 2 * static_cast<double>(spectra.neighbours) * windowCorrelation * windowCorrelation;
    result.averages = count * count / (count + shared);
    constexpr double most = EmpiricalResponse::largestRelativeError;
    result.coherenceLimit = 1 / (1 + 2 * result.averages * most * most);
    const double strongest = *std::max_element(spectra.force.begin(), spectra.force.end());
    for (std::size_t q = firstBin; q < section / 2; ++q) {
        if (!(spectra.force[q] > leastPower * strongest))
            continue;
        EmpiricalLine line;
        line.frequency_Hz = static_cast<double>(q) / (static_cast<double>(section) * sampleTime_s);
        line.response = spectra.cross[q] / spectra.force[q] * (positionScale / forceScale);
        if (positionScale > 0 && spectra.position[q] > 0) // else what is left is rounding
            line.coherence =
                std::clamp(std::norm(spectra.cross[q]) / spectra.force[q] / spectra.position[q], 0.0, 1.0);
        if (line.coherence >= result.coherenceLimit)
            line.relativeError = std::sqrt((1 - line.coherence) / (2 * line.coherence * result.averages));
        result.lines.push_back(line);
    }
    return result;
}

} // namespace gripscope
