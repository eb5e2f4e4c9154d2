// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/periodic/periodic_search.h"
#include "core/math/fourier.h"
#include "core/math/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

namespace {

/// Bins beside a harmonic: with 24 the variance is known to 20 % and costs the estimate 2 % in its standard
/// error; more would reach over too much of the spectrum.
constexpr std::size_t mostBeside = 24;
/// Five degrees of freedom at the least: the variance of an estimate weighted with them must exist (over 2).
constexpr std::size_t fewestBeside = 8;
/// How far the bins may lie from the harmonic, as a share of its frequency: noise that falls with the square
/// of the frequency differs by a factor of 25 over this range, which makes the intervals of what rests on the
/// lowest harmonic a tenth too wide; half of it would leave too few bins there.
constexpr double reach = 2.0 / 3;
/// A trend leaks 1 / q, which a straight line follows to 1 % where the bins reach less than a third of q.
constexpr double trendReach = 3;

constexpr double smallestAmplitude = 0.01;
/// Power over the noise's variance: noise alone exceeds it in one of 3,000 harmonics with five degrees of
/// freedom, in far fewer with more.
constexpr double smallestPower = 20;
constexpr std::size_t mostLines = 20'000;

/// The mean of the last period less that of the first one, by the time between: the slope of a straight line,
/// whatever repeats. Where there are enough, the very first period, which may hold the start's transient, is
/// left out.
double slopeBetweenPeriods(std::span<const double> values, std::size_t periods)
{
    const std::size_t period = values.size() / periods;
    const std::size_t first = periods > 4 ? 1 : 0;
    const std::size_t between = (periods - 1 - first) * period;
    if (between == 0)
        return 0;
    double sum = 0;
    for (std::size_t i = 0; i < period; ++i)
        sum += values[(periods - 1) * period + i] - values[first * period + i];
    return sum / static_cast<double>(period) / static_cast<double>(between);
}

std::vector<std::complex<double>> binsWithout(double slope, std::span<const double> values)
{
    const double middle = static_cast<double>(values.size() - 1) / 2;
    double mean = 0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    std::vector<double> rest(values.size());
    for (std::size_t t = 0; t < rest.size(); ++t)
        rest[t] = values[t] - mean - slope * (static_cast<double>(t) - middle);
    return fourierTransform(rest);
}

/// The nearest bins that are no harmonics, nearest first, as far as `reach` and `mostBeside` allow.
std::vector<std::size_t> binsBeside(std::size_t bin, std::size_t periods, std::size_t binCount)
{
    std::vector<std::size_t> found;
    const auto farthest = static_cast<std::size_t>(reach * static_cast<double>(bin));
    for (std::size_t distance = 1; distance < binCount; ++distance) {
        if (found.size() >= mostBeside || (distance > farthest && found.size() >= fewestBeside))
            break;
        if (distance % periods == 0)
            continue;
        if (bin > distance)
            found.push_back(bin - distance);
        // The last bin may be half the sample rate, which is real.
        if (bin + distance + 1 < binCount)
            found.push_back(bin + distance);
    }
    return found;
}

} // namespace

double PeriodicSpectrum::radiansPerSample(std::size_t bin) const
{
    return 2 * std::numbers::pi * static_cast<double>(bin) / static_cast<double>(samples);
}

PeriodicSpectrum periodicSpectrum(std::span<const double> force, std::span<const double> position,
                                  std::size_t periods)
{
    PeriodicSpectrum spectrum;
    spectrum.samples = force.size();
    spectrum.periods = periods;
    spectrum.forceSlope = slopeBetweenPeriods(force, periods);
    spectrum.positionSlope = slopeBetweenPeriods(position, periods);
    spectrum.force = binsWithout(spectrum.forceSlope, force);
    spectrum.position = binsWithout(spectrum.positionSlope, position);
    return spectrum;
}

Eigen::VectorXcd LocalFit::gather(std::span<const std::complex<double>> bins) const
{
    Eigen::VectorXcd out(static_cast<Eigen::Index>(beside.size()));
    for (std::size_t i = 0; i < beside.size(); ++i)
        out(static_cast<Eigen::Index>(i)) = bins[beside[i]];
    return out;
}

std::complex<double> LocalFit::atHarmonic(std::span<const std::complex<double>> bins) const
{
    std::complex<double> value = bins[bin];
    for (std::size_t i = 0; i < beside.size(); ++i)
        value -= interpolation(static_cast<Eigen::Index>(i)) * bins[beside[i]];
    return value;
}

Eigen::VectorXcd LocalFit::residual(const Eigen::VectorXcd& gathered) const
{
    return gathered - basis * (basis.transpose() * gathered);
}

LocalFit localFit(std::size_t bin, std::size_t periods, std::size_t binCount)
{
    LocalFit fit;
    fit.bin = bin;
    fit.beside = binsBeside(bin, periods, binCount);
    if (fit.beside.size() < fewestBeside)
        return fit;
    const auto rows = static_cast<Eigen::Index>(fit.beside.size());
    const auto distance = [&](std::size_t at) { return static_cast<double>(at) - static_cast<double>(bin); };
    double farthest = 0;
    for (const std::size_t at : fit.beside)
        farthest = std::max(farthest, std::abs(distance(at)));
    const bool trend = static_cast<double>(bin) < trendReach * farthest;
    Eigen::MatrixXd functions(rows, trend ? 3 : 2);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const std::size_t at = fit.beside[static_cast<std::size_t>(i)];
        functions(i, 0) = 1;
        functions(i, 1) = distance(at) / farthest;
        if (trend)
            functions(i, 2) = static_cast<double>(bin) / static_cast<double>(at);
    }
    Eigen::VectorXd atHarmonic = Eigen::VectorXd::Zero(functions.cols());
    atHarmonic(0) = 1;
    if (trend)
        atHarmonic(2) = 1;
    fit.basis = orthonormalColumns(functions);
    fit.interpolation = fit.basis * (inverseOfTriangle(triangleOf(functions)).transpose() * atHarmonic);
    fit.degreesOfFreedom = static_cast<double>(rows - functions.cols());
    fit.varianceFactor = 1 + fit.interpolation.squaredNorm();
    return fit;
}

std::vector<LocalFit> excitedLines(const PeriodicSpectrum& spectrum)
{
    const std::size_t binCount = spectrum.force.size();
    double largest = 0;
    for (std::size_t bin = spectrum.periods; bin + 1 < binCount; bin += spectrum.periods)
        largest = std::max(largest, std::abs(spectrum.force[bin]));
    std::vector<LocalFit> lines;
    for (std::size_t bin = spectrum.periods; bin + 1 < binCount; bin += spectrum.periods) {
        const double amplitude = std::abs(spectrum.force[bin]);
        if (!(amplitude > smallestAmplitude * largest))
            continue;
        LocalFit fit = localFit(bin, spectrum.periods, binCount);
        if (fit.degreesOfFreedom < 3)
            continue;
        const double variance = fit.varianceFactor * fit.residual(fit.gather(spectrum.force)).squaredNorm() /
                                fit.degreesOfFreedom;
        if (!(std::norm(fit.atHarmonic(spectrum.force)) > smallestPower * variance))
            continue;
        lines.push_back(std::move(fit));
        if (lines.size() == mostLines)
            break;
    }
    return lines;
}

} // namespace gripscope
