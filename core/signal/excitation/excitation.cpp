// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/excitation/excitation.h"

#include "core/base/words.h"
#include "core/math/gaussian.h"
#include "core/signal/recording/recording_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// In the order of the enumerators.
constexpr std::array knownKinds{
    ExcitationKind::Step,     ExcitationKind::Prbs,          ExcitationKind::Multisine,
    ExcitationKind::Chirp,    ExcitationKind::InverseRepeat, ExcitationKind::FourLevel,
    ExcitationKind::PrbsSine, ExcitationKind::PrbsHold,      ExcitationKind::Levels};
constexpr std::array<const char*, knownKinds.size()> kindNames{
    "step", "prbs", "multisine", "chirp", "inverse-repeat", "four-level", "prbs-sine", "prbs-hold", "levels"};

/// Harmonics times samples that a multisine may cost: about a second.
constexpr double largestMultisineWork = 4e8;
constexpr std::size_t largestSampleCount = mostSamples;

/// Feedback taps (bit masks) of shift registers of 3 to 31 bits whose sequence has the greatest length,
/// 2^bits - 1: primitive polynomials over GF(2), for a register that shifts right and feeds the parity of the
/// taps back.
constexpr int shortestRegister = 3;
constexpr std::array<std::uint32_t, 29> taps{
    0x6,       0xC,       0x14,       0x30,       0x60,      0xB8,     0x110,     0x240,
    0x500,     0xE08,     0x1C80,     0x3802,     0x6000,    0xD008,   0x12000,   0x20400,
    0x72000,   0x90000,   0x140000,   0x300000,   0x420000,  0xE10000, 0x1200000, 0x2000023,
    0x4000013, 0x9000000, 0x14000000, 0x20000029, 0x48000000};

constexpr std::uint64_t sequenceLength(std::size_t index)
{
    return (std::uint64_t(1) << (shortestRegister + index)) - 1;
}

/// Galois form: one shift, and the taps folded in when a one leaves.
class ShiftRegister {
public:
    ShiftRegister(std::size_t index, std::uint64_t seed) : m_taps(taps[index])
    {
        // Every state but zero occurs once in the sequence, so the state is the place within it.
        std::mt19937_64 engine(seed);
        m_state = static_cast<std::uint32_t>(engine() % sequenceLength(index)) + 1;
    }
    bool next()
    {
        const bool bit = (m_state & 1U) != 0;
        m_state >>= 1U;
        if (bit)
            m_state ^= m_taps;
        return bit;
    }

private:
    std::uint32_t m_taps = 0;
    std::uint32_t m_state = 1;
};

/// The shortest register of 5 bits and more whose sequence has so many bits.
std::size_t registerFor(std::size_t bits)
{
    std::size_t index = 5 - shortestRegister;
    while (index + 1 < taps.size() && sequenceLength(index) < bits)
        ++index;
    return index;
}

std::size_t samplesPerBit(const ExcitationOptions& options)
{
    const double samples = std::round(options.bit_s / options.sampleTime_s);
    return static_cast<std::size_t>(std::clamp(samples, 1.0, static_cast<double>(options.samples)));
}

std::size_t periodsOf(const ExcitationOptions& options)
{
    // Eight measure the noise with enough degrees of freedom (periodic.h).
    const std::size_t usual = options.kind == ExcitationKind::InverseRepeat ? 8 : 1;
    return options.periods > 0 ? options.periods : usual;
}

/// The longest register whose inverse-repeat sequence fits often enough.
std::optional<std::size_t> inverseRepeatRegister(const ExcitationOptions& options)
{
    const std::size_t bits = options.samples / samplesPerBit(options) / periodsOf(options);
    std::optional<std::size_t> longest;
    for (std::size_t index = 0; index < taps.size() && 2 * sequenceLength(index) <= bits; ++index)
        longest = index;
    return longest;
}

/// How many samples of a multisine or a chirp are one period.
std::size_t sinePeriod(const ExcitationOptions& options)
{
    return options.kind == ExcitationKind::Multisine ? options.samples / periodsOf(options) : options.samples;
}

/// The highest frequency of multisine and chirp as a multiple of 1 / their length, at most half the sample
/// rate.
double highestHarmonic(const ExcitationOptions& options)
{
    const auto samples = static_cast<double>(sinePeriod(options));
    return std::min(samples * options.sampleTime_s / (2 * options.bit_s), samples / 2);
}

std::vector<double> prbs(const ExcitationOptions& options)
{
    const std::size_t perBit = samplesPerBit(options);
    ShiftRegister shiftRegister(registerFor((options.samples + perBit - 1) / perBit), options.seed);
    std::vector<double> force(options.samples);
    double value = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (i % perBit == 0)
            value = shiftRegister.next() ? options.peak : -options.peak;
        force[i] = value;
    }
    return force;
}

std::vector<double> fourLevel(const ExcitationOptions& options)
{
    const std::size_t perLevel = samplesPerBit(options);
    const std::size_t levels = (options.samples + perLevel - 1) / perLevel;
    ShiftRegister shiftRegister(registerFor(2 * levels), options.seed);
    std::vector<double> force(options.samples);
    double value = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (i % perLevel == 0) {
            const double outer = shiftRegister.next() ? 1 : -1;
            const double inner = shiftRegister.next() ? 1 : -1;
            value = options.peak * (2 * outer + inner) / 3;
        }
        force[i] = value;
    }
    return force;
}

std::vector<double> multisine(const ExcitationOptions& options)
{
    std::vector<double> force(sinePeriod(options), 0.0);
    GaussianNoise random(options.seed);
    const auto harmonics =
        static_cast<std::size_t>(std::max(1.0, std::floor(highestHarmonic(options) + 1e-9)));
    std::vector<double> cosine(force.size());
    std::vector<double> sine(force.size());
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(force.size());
        cosine[i] = std::cos(angle);
        sine[i] = std::sin(angle);
    }
    for (std::size_t harmonic = 1; harmonic <= harmonics; ++harmonic) {
        const double phase = 2 * std::numbers::pi * random.uniform();
        const double a = std::cos(phase);
        const double b = std::sin(phase);
        for (std::size_t i = 0, at = 0; i < force.size(); ++i) {
            force[i] += a * cosine[at] - b * sine[at];
            at += harmonic;
            at -= at >= force.size() ? force.size() : 0;
        }
    }
    double largest = 0;
    for (const double value : force)
        largest = std::max(largest, std::abs(value));
    for (double& value : force)
        value *= largest > 0 ? options.peak / largest : 0;
    const std::size_t period = force.size();
    force.resize(options.samples);
    for (std::size_t i = period; i < force.size(); ++i)
        force[i] = force[i - period];
    return force;
}

/// Bits of the sequence as they are and turned over by turns. The sequence has an odd number of bits, so that
/// after two of them every bit has been both.
std::vector<double> inverseRepeat(const ExcitationOptions& options)
{
    const std::size_t perBit = samplesPerBit(options);
    ShiftRegister shiftRegister(*inverseRepeatRegister(options), options.seed);
    std::vector<double> force(options.samples);
    double value = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (i % perBit == 0) {
            const bool turned = i / perBit % 2 == 1;
            value = shiftRegister.next() != turned ? options.peak : -options.peak;
        }
        force[i] = value;
    }
    return force;
}

std::vector<double> chirp(const ExcitationOptions& options)
{
    std::vector<double> force(options.samples);
    const auto samples = static_cast<double>(options.samples);
    const double sweep = highestHarmonic(options) - 1;
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double part = static_cast<double>(i) / samples;
        force[i] = options.peak * std::sin(2 * std::numbers::pi * part * (1 + sweep * part / 2));
    }
    return force;
}

/// Two levels for half the record, then `slow` of the share of the rest that is over.
template <typename Slow>
std::vector<double> prbsThen(const ExcitationOptions& options, const Slow& slow)
{
    ExcitationOptions first = options;
    first.samples = (options.samples + 1) / 2;
    std::vector<double> force = prbs(first);
    const auto rest = static_cast<double>(options.samples - first.samples);
    for (std::size_t i = first.samples; i < options.samples; ++i)
        force.push_back(options.peak * slow(static_cast<double>(i - first.samples) / rest));
    return force;
}

double slowSine(double share)
{
    return std::sin(2 * std::numbers::pi * share);
}

double rampAndHold(double share)
{
    constexpr double ramp = 0.25; // of the second half
    return std::min(1.0, 2 * share / ramp - 1);
}

std::vector<double> levelsInTurn(const ExcitationOptions& options)
{
    const double perLevel = options.bit_s / options.sampleTime_s;
    std::vector<double> force(options.samples);
    for (std::size_t i = 0; i < force.size(); ++i) {
        constexpr double rounding = 1e-9; // of times that are whole numbers of levels
        const auto level = static_cast<std::size_t>(static_cast<double>(i) / perLevel + rounding);
        force[i] = options.peak * options.levels[level % options.levels.size()];
    }
    return force;
}

std::optional<Finding> levelProblem(const ExcitationOptions& options)
{
    if (options.levels.empty())
        return Words::say(
            "There are no levels yet: take those of a file, or let the program search the best two.");
    if (options.levels.size() > mostLevels)
        return Words::say("there are %1 levels; at most %2 can be squeezed with")
            .arg(options.levels.size())
            .arg(mostLevels);
    if (!std::ranges::all_of(options.levels, [](double level) { return std::abs(level) <= 1 + 1e-9; }))
        return Words::say("each level must be from -1 to 1, in parts of the peak");
    constexpr double shortest = 1 - 1e-6; // of a sample
    if (options.bit_s < shortest * options.sampleTime_s)
        return Words::say("The gripper takes a sample every %1 ms, and these levels are shorter: choose a "
                          "longer shortest push.")
            .arg(1e3 * options.sampleTime_s);
    return std::nullopt;
}

/// In samples, where a level has a whole number of them.
std::optional<std::size_t> turnOfLevels(const ExcitationOptions& options)
{
    const double perLevel = options.bit_s / options.sampleTime_s;
    const double whole = std::round(perLevel);
    if (std::abs(perLevel - whole) > 1e-6 * whole)
        return std::nullopt;
    return options.levels.size() * static_cast<std::size_t>(std::min(whole, double(options.samples)));
}

tl::unexpected<Error> refuse(const Finding& reason)
{
    return failure(ErrorCode::Usage, {reason});
}

} // namespace

std::span<const ExcitationKind> excitationKinds()
{
    return knownKinds;
}

QString toString(ExcitationKind kind)
{
    const auto found = std::ranges::find(knownKinds, kind);
    return found == knownKinds.end()
               ? QString()
               : QString::fromLatin1(kindNames[static_cast<std::size_t>(found - knownKinds.begin())]);
}

std::optional<ExcitationKind> excitationKindFromString(const QString& text)
{
    const auto found =
        std::ranges::find_if(knownKinds, [&](ExcitationKind kind) { return toString(kind) == text; });
    return found == knownKinds.end() ? std::nullopt : std::optional(*found);
}

std::optional<Error> ExcitationOptions::validate() const
{
    const auto usage = [](const Finding& reason) { return Error{ErrorCode::Usage, {reason}}; };
    if (!std::isfinite(peak) || peak < 0)
        return usage(Words::say("peak must be a number from 0 up"));
    if (!std::isfinite(bias))
        return usage(Words::say("bias must be a number"));
    if (!isSampleTime(sampleTime_s))
        return usage(Words::say("the sample time must be %1").arg(sampleTimeExpectation()));
    if (samples == 0 || samples > largestSampleCount)
        return usage(Words::say("samples must be from 1 to %1").arg(largestSampleCount));
    if (!std::isfinite(bit_s) || bit_s <= 0)
        return usage(Words::say("the bit time must be above 0 s"));
    if (oneSided && bias + peak < 0)
        return usage(Words::say("bias plus peak must not be negative: a one-sided grip can only push"));
    if (kind == ExcitationKind::InverseRepeat && !inverseRepeatRegister(*this))
        return usage(
            Words::say(
                "%1 periods of the shortest inverse-repeat sequence, of 14 bits, do not fit: take more "
                "samples, shorter bits or fewer periods")
                .arg(periodsOf(*this)));
    if (kind == ExcitationKind::Levels)
        if (const std::optional<Finding> problem = levelProblem(*this))
            return usage(*problem);
    if (kind == ExcitationKind::Multisine && sinePeriod(*this) == 0)
        return usage(Words::say("there are more periods than samples"));
    if (kind == ExcitationKind::Multisine &&
        static_cast<double>(samples) * highestHarmonic(*this) > largestMultisineWork)
        return usage(Words::say("this multisine has too many harmonics: take fewer samples or a longer bit"));
    return std::nullopt;
}

std::optional<std::size_t> excitationPeriod(const ExcitationOptions& options)
{
    if (options.validate())
        return std::nullopt;
    if (options.kind == ExcitationKind::InverseRepeat)
        return 2 * sequenceLength(*inverseRepeatRegister(options)) * samplesPerBit(options);
    if (options.kind == ExcitationKind::Multisine && periodsOf(options) > 1)
        return sinePeriod(options);
    if (options.kind == ExcitationKind::Levels)
        if (const auto turn = turnOfLevels(options); turn && 2 * *turn <= options.samples)
            return turn;
    return std::nullopt;
}

Expected<std::vector<double>> makeExcitation(const ExcitationOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    std::vector<double> force;
    switch (options.kind) {
    case ExcitationKind::Step:
        force.assign(options.samples, options.peak);
        break;
    case ExcitationKind::Prbs:
        force = prbs(options);
        break;
    case ExcitationKind::Multisine:
        force = multisine(options);
        break;
    case ExcitationKind::Chirp:
        force = chirp(options);
        break;
    case ExcitationKind::InverseRepeat:
        force = inverseRepeat(options);
        break;
    case ExcitationKind::FourLevel:
        force = fourLevel(options);
        break;
    case ExcitationKind::PrbsSine:
        force = prbsThen(options, slowSine);
        break;
    case ExcitationKind::PrbsHold:
        force = prbsThen(options, rampAndHold);
        break;
    case ExcitationKind::Levels:
        force = levelsInTurn(options);
        break;
    }
    for (double& value : force) {
        value += options.bias;
        if (options.oneSided)
            value = std::max(value, 0.0);
        if (!std::isfinite(value))
            return refuse(Words::say("bias and peak are too large"));
    }
    return force;
}

} // namespace gripscope
