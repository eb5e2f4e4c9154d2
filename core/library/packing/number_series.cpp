// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/packing/number_series.h"

#include "core/base/byte_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

using Whole = std::vector<std::uint64_t>; ///< counted modulo 2^64

constexpr int bytesOfWhole = 8;
enum class Form : std::uint8_t { Bits, Multiples, Places };

std::optional<std::uint64_t> takeWhole(QByteArrayView& in)
{
    if (in.size() < bytesOfWhole)
        return {};
    const auto value = qFromBigEndian<std::uint64_t>(in.data());
    in = in.sliced(bytesOfWhole);
    return value;
}

std::optional<std::uint8_t> takeByte(QByteArrayView& in)
{
    if (in.isEmpty())
        return {};
    const auto value = static_cast<std::uint8_t>(in.front());
    in = in.sliced(1);
    return value;
}

std::uint64_t zigzag(std::uint64_t value)
{
    return (value << 1) ^ (0 - (value >> 63));
}

std::uint64_t unzigzag(std::uint64_t value)
{
    return (value >> 1) ^ (0 - (value & 1));
}

void difference(Whole& values)
{
    for (std::size_t i = values.size(); i-- > 1;)
        values[i] -= values[i - 1];
}

void accumulate(Whole& values)
{
    for (std::size_t i = 1; i < values.size(); ++i)
        values[i] += values[i - 1];
}

/// Bits that are needed for all of them.
std::uint64_t bitsOf(const Whole& values)
{
    std::uint64_t bits = 0;
    for (const std::uint64_t value : values)
        bits += static_cast<std::uint64_t>(std::bit_width(zigzag(value)));
    return bits;
}

/// Order of the differences, how many planes, the planes.
QByteArray packWhole(Whole values)
{
    constexpr int orders = 3;
    Whole best = values;
    std::uint8_t bestOrder = 0;
    for (std::uint8_t order = 1; order < orders; ++order) {
        difference(values);
        if (bitsOf(values) < bitsOf(best)) {
            best = values;
            bestOrder = order;
        }
    }
    std::uint64_t all = 0;
    for (std::uint64_t& value : best) {
        value = zigzag(value);
        all |= value;
    }
    const int planes = (std::bit_width(all) + 7) / 8;
    QByteArray out;
    out.reserve(2 + planes * static_cast<qsizetype>(best.size()));
    out.append(static_cast<char>(bestOrder)).append(static_cast<char>(planes));
    for (int plane = 0; plane < planes; ++plane)
        for (const std::uint64_t value : best)
            out.append(static_cast<char>(value >> (8 * plane) & 0xff));
    return out;
}

std::optional<Whole> unpackWhole(QByteArrayView& in, std::uint64_t count)
{
    const auto order = takeByte(in);
    const auto planes = takeByte(in);
    if (!order || !planes || *order > 2 || *planes > bytesOfWhole)
        return {};
    // Without a plane all are zero, and nothing says how many there are.
    const std::uint64_t room = *planes > 0 ? static_cast<std::uint64_t>(in.size()) / *planes
                                           : 1000 * (static_cast<std::uint64_t>(in.size()) + 1'000'000);
    if (count > room)
        return {};
    Whole values(count, 0);
    for (int plane = 0; plane < *planes; ++plane) {
        for (std::size_t i = 0; i < count; ++i)
            values[i] |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(in[static_cast<qsizetype>(i)]))
                         << (8 * plane);
        in = in.sliced(static_cast<qsizetype>(count));
    }
    for (std::uint64_t& value : values)
        value = unzigzag(value);
    for (int i = 0; i < *order; ++i)
        accumulate(values);
    return values;
}

/// The bits as a number that grows as the number itself does.
std::uint64_t orderedBits(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return bits >> 63 ? ~bits : bits | std::uint64_t(1) << 63;
}

double fromOrderedBits(std::uint64_t ordered)
{
    return std::bit_cast<double>(ordered >> 63 ? ordered & ~(std::uint64_t(1) << 63) : ~ordered);
}

Whole orderedBits(std::span<const double> values)
{
    Whole bits;
    bits.reserve(values.size());
    for (const double value : values)
        bits.push_back(orderedBits(value));
    return bits;
}

/// k where each value is k times `step`, bit for bit.
std::optional<Whole> multiplesOf(double step, std::span<const double> values)
{
    constexpr double largest = 1e15; // whole numbers are exact below
    Whole multiples;
    multiples.reserve(values.size());
    for (const double value : values) {
        const double k = std::round(value / step);
        if (!(std::abs(k) < largest))
            return {};
        const auto whole = static_cast<std::int64_t>(k); // without the sign that a zero may have
        if (std::bit_cast<std::uint64_t>(static_cast<double>(whole) * step) !=
            std::bit_cast<std::uint64_t>(value))
            return {};
        multiples.push_back(static_cast<std::uint64_t>(whole));
    }
    return multiples;
}

/// The smallest difference between two of them, but for rounding; 0 where all are alike.
double finestStep(const std::vector<double>& sorted)
{
    const double rounding = 1e-9 * std::max(std::abs(sorted.front()), std::abs(sorted.back()));
    double finest = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (const double step = sorted[i] - sorted[i - 1]; step > rounding && (finest == 0 || step < finest))
            finest = step;
    return finest;
}

struct Multiples {
    double step = 0;
    Whole values;
};

/// A difference of two values says the step to some digits, the largest value to the last but one or two.
std::optional<Multiples> findMultiples(const std::vector<double>& sorted, std::span<const double> values)
{
    const double rough = finestStep(sorted);
    const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
    const double count = std::round(largest / rough);
    if (!(rough > 0) || !std::isfinite(count) || count < 1)
        return {};
    double step = largest / count;
    constexpr int around = 2; // units in the last place
    for (int i = 0; i < around; ++i)
        step = std::nextafter(step, 0.0);
    for (int i = -around; i <= around;
         ++i, step = std::nextafter(step, std::numeric_limits<double>::infinity()))
        if (std::optional<Whole> found = multiplesOf(step, values))
            return Multiples{step, std::move(*found)};
    return {};
}

ByteWriter begun(Form form)
{
    return ByteWriter().number(static_cast<quint8>(form));
}

QByteArray asPlaces(std::span<const double> values)
{
    Whole table = orderedBits(values);
    std::sort(table.begin(), table.end());
    table.erase(std::unique(table.begin(), table.end()), table.end());
    Whole places;
    places.reserve(values.size());
    for (const double value : values)
        places.push_back(static_cast<std::uint64_t>(
            std::lower_bound(table.begin(), table.end(), orderedBits(value)) - table.begin()));
    ByteWriter out = begun(Form::Places);
    out.number(quint64(table.size()));
    return out.plain(packWhole(std::move(table))).plain(packWhole(std::move(places))).bytes();
}

qsizetype packedSize(const QByteArray& bytes)
{
    return qCompress(bytes).size();
}

std::optional<std::vector<double>> takeMultiples(QByteArrayView& in, std::uint64_t count)
{
    const auto step = takeWhole(in);
    const auto whole = step ? unpackWhole(in, count) : std::nullopt;
    if (!whole)
        return {};
    std::vector<double> values;
    values.reserve(whole->size());
    for (const std::uint64_t k : *whole)
        values.push_back(static_cast<double>(static_cast<std::int64_t>(k)) * std::bit_cast<double>(*step));
    return values;
}

std::optional<std::vector<double>> takePlaces(QByteArrayView& in, std::uint64_t count)
{
    const auto different = takeWhole(in);
    if (!different || *different > count)
        return {};
    const auto table = unpackWhole(in, *different);
    const auto places = table ? unpackWhole(in, count) : std::nullopt;
    if (!places)
        return {};
    std::vector<double> values;
    values.reserve(places->size());
    for (const std::uint64_t place : *places) {
        if (place >= table->size())
            return {};
        values.push_back(fromOrderedBits((*table)[place]));
    }
    return values;
}

} // namespace

QByteArray packedSeries(std::span<const std::uint64_t> values)
{
    return packWhole(Whole(values.begin(), values.end()));
}

QByteArray packedSeries(std::span<const double> values)
{
    QByteArray best = begun(Form::Bits).plain(packWhole(orderedBits(values))).bytes();
    const bool finite =
        std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    if (values.empty() || !finite)
        return best;
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    QByteArray other;
    if (const auto multiples = findMultiples(sorted, values)) {
        other = begun(Form::Multiples)
                    .number(std::bit_cast<quint64>(multiples->step))
                    .plain(packWhole(multiples->values))
                    .bytes();
    } else {
        other = asPlaces(values);
    }
    return packedSize(other) < packedSize(best) ? other : best;
}

std::optional<std::vector<std::uint64_t>> takeIntegers(QByteArrayView& bytes, std::uint64_t count)
{
    return unpackWhole(bytes, count);
}

std::optional<std::vector<double>> takeDoubles(QByteArrayView& bytes, std::uint64_t count)
{
    const auto form = takeByte(bytes);
    if (!form)
        return {};
    switch (static_cast<Form>(*form)) {
    case Form::Multiples:
        return takeMultiples(bytes, count);
    case Form::Places:
        return takePlaces(bytes, count);
    case Form::Bits:
        break;
    default:
        return {};
    }
    const auto bits = unpackWhole(bytes, count);
    if (!bits)
        return {};
    std::vector<double> values;
    values.reserve(bits->size());
    for (const std::uint64_t ordered : *bits)
        values.push_back(fromOrderedBits(ordered));
    return values;
}

} // namespace gripscope
