// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/fourier.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

using Complex = std::complex<double>;

/// std::complex multiplies through a check for infinities, which costs most of the time here.
Complex product(Complex a, Complex b)
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

void reverseBits(std::vector<Complex>& values)
{
    for (std::size_t i = 1, j = 0; i < values.size(); ++i) {
        std::size_t bit = values.size() >> 1U;
        for (; (j & bit) != 0; bit >>= 1U)
            j ^= bit;
        j ^= bit;
        if (i < j)
            std::swap(values[i], values[j]);
    }
}

} // namespace

std::size_t powerOfTwoAtLeast(std::size_t count)
{
    return std::bit_ceil(std::max<std::size_t>(count, 1));
}

void powerOfTwoTransform(std::vector<Complex>& values, bool inverse)
{
    const std::size_t count = values.size();
    reverseBits(values);
    std::vector<Complex> turns(count / 2);
    const double sign = inverse ? 2 : -2;
    for (std::size_t i = 0; i < turns.size(); ++i)
        turns[i] =
            std::polar(1.0, sign * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count));
    for (std::size_t half = 1; half < count; half *= 2) {
        const std::size_t stride = count / (2 * half);
        for (std::size_t begin = 0; begin < count; begin += 2 * half) {
            for (std::size_t i = 0; i < half; ++i) {
                const Complex odd = product(values[begin + half + i], turns[i * stride]);
                const Complex even = values[begin + i];
                values[begin + i] = even + odd;
                values[begin + half + i] = even - odd;
            }
        }
    }
}

std::vector<Complex> fourierTransform(std::span<const double> values)
{
    const std::uint64_t count = values.size();
    if (count == 0)
        return {};
    // q t = (q^2 + t^2 - (q - t)^2) / 2 turns the transform into a convolution. The angle pi t^2 / n is taken
    // modulo 2 pi in whole numbers, so that nothing is rounded for large t.
    std::vector<Complex> chirp(count);
    for (std::uint64_t t = 0; t < count; ++t) {
        const auto turn = static_cast<double>(t * t % (2 * count));
        chirp[t] = std::polar(1.0, -std::numbers::pi * turn / static_cast<double>(count));
    }
    const std::size_t padded = powerOfTwoAtLeast(2 * values.size());
    std::vector<Complex> signal(padded), kernel(padded);
    for (std::size_t t = 0; t < values.size(); ++t) {
        signal[t] = values[t] * chirp[t];
        kernel[t] = std::conj(chirp[t]);
        kernel[(padded - t) % padded] = std::conj(chirp[t]);
    }
    powerOfTwoTransform(signal);
    powerOfTwoTransform(kernel);
    for (std::size_t i = 0; i < padded; ++i)
        signal[i] = product(signal[i], kernel[i]);
    powerOfTwoTransform(signal, true);
    std::vector<Complex> bins(values.size() / 2 + 1);
    const double scale = 1 / (static_cast<double>(padded) * std::sqrt(static_cast<double>(count)));
    for (std::size_t q = 0; q < bins.size(); ++q)
        bins[q] = scale * product(signal[q], chirp[q % values.size()]);
    return bins;
}

std::vector<double> autocorrelation(std::span<const double> values, std::size_t largestLag)
{
    if (values.empty())
        return {};
    largestLag = std::min(largestLag, values.size() - 1);
    const std::size_t padded = powerOfTwoAtLeast(values.size() + largestLag + 1);
    std::vector<Complex> spectrum(padded);
    std::copy(values.begin(), values.end(), spectrum.begin());
    powerOfTwoTransform(spectrum);
    for (Complex& bin : spectrum)
        bin = std::norm(bin);
    powerOfTwoTransform(spectrum);
    std::vector<double> lags(largestLag + 1);
    for (std::size_t lag = 0; lag < lags.size(); ++lag)
        lags[lag] = spectrum[lag].real() / static_cast<double>(padded);
    return lags;
}

} // namespace gripscope
