// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

enum class ExcitationKind {
    Step,
    Prbs,
    Multisine,
    Chirp,
    InverseRepeat,
    FourLevel,
    PrbsSine,
    PrbsHold,
    Levels
};

inline constexpr std::size_t mostLevels = 20'000;

/// All of them, in the order of the enumerators.
[[nodiscard]] std::span<const ExcitationKind> excitationKinds();

[[nodiscard]] QString toString(ExcitationKind kind);
[[nodiscard]] std::optional<ExcitationKind> excitationKindFromString(const QString& text);

/// A force to be commanded. A one-sided grip can only push, so a squeeze is `bias` plus a signal within
/// +-`peak`, cut at zero when `oneSided`.
///   Step: bias + peak from the first sample on.
///   Prbs: pseudo-random binary sequence of a maximum-length shift register, bias +- peak, each bit `bit_s`
///   long
///         (rounded to whole samples, at least one); the seed picks the start within the sequence.
///   Multisine: equal amplitudes on the harmonics of the record up to 1 / (2 bit_s), random phases from the
///   seed,
///         scaled so that its largest value is `peak`. With `periods` it repeats so often: the harmonics are
///         those of samples / periods.
///   Chirp: linear sweep from 1 / record length to 1 / (2 bit_s).
///   InverseRepeat: a maximum-length binary sequence and its negative by turns, bias +- peak, each bit
///   `bit_s`
///         long: a period of 2 (2^n - 1) bits, the longest of which `periods` fit into the record, and as
///         many more as fit. It has odd harmonics only, so that what the answer holds at even ones is not
///         linear; what differs from period to period is noise (Godfrey, Perturbation Signals, 1993). The
///         seed picks the start. For the estimator `periodic`.
///   FourLevel: as Prbs, two bits of the sequence a level: bias +- peak and bias +- peak / 3, each level
///   `bit_s`
///         long. Tells friction from stiffness, which two levels hide, for a third more error of m.
///   PrbsSine: half the record as Prbs, then one slow sine over the rest: it takes the part slowly over all
///   of
///         its way, which tells friction best.
///   PrbsHold: half the record as Prbs, then a ramp from -peak to peak over an eighth of the record, held to
///         the end: a part that goes on yielding shows how far and how fast.
///   Levels: bias + peak times each of `levels` in turn, for `bit_s` each, and from the first again after the
///         last: a force that somebody has (ForceLevels). Each sample has the level of its time; nothing is
///         rounded.
struct ExcitationOptions {
    ExcitationKind kind = ExcitationKind::Prbs;
    double peak = 10; ///< force unit
    double bias = 20; ///< force unit
    double bit_s = 0.005;
    double sampleTime_s = 0.0005;
    std::size_t samples = 2000;
    std::uint64_t seed = 1;
    bool oneSided = true;
    std::size_t periods = 0;         ///< InverseRepeat, Multisine; 0: 8 of the former, one of the latter
    std::vector<double> levels = {}; ///< Levels: each from -1 to 1, at most mostLevels

    /// Nothing when the options make sense; else what does not, in words that name the option.
    [[nodiscard]] std::optional<Error> validate() const;
};

/// After how many samples the excitation repeats; nothing when it does not (within the record), or when an
/// inverse-repeat sequence of so many periods does not fit.
[[nodiscard]] std::optional<std::size_t> excitationPeriod(const ExcitationOptions& options);

/// The commanded force, one value a sample. Pure: the same options give the same values on every machine.
[[nodiscard]] Expected<std::vector<double>> makeExcitation(const ExcitationOptions& options);

} // namespace gripscope
