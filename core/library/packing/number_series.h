// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// Numbers one after another as bytes that deflate packs well, to be read back bit for bit. Whole numbers are
/// taken as differences of the order (0, 1 or 2) that leaves the least, zigzag (0, -1, 1, -2... as 0, 1, 2,
/// 3...), and byte by byte: all lowest bytes, then all next ones, up to the highest that is not zero
/// everywhere. Numbers with a fraction become whole in the one of three ways that leaves the least:
/// - multiples k of a step q, where k q is each of them to the last bit: counts of a converter in its unit
/// - their places in a table of the different values, where few are different or all are alike: calibrated
///   counts, levels of a command
/// - their bits, ordered as the numbers are: times on an even clock, anything else
/// Deflating is left to the caller, who may have several of them. O(N log N).
[[nodiscard]] QByteArray packedSeries(std::span<const double> values);
[[nodiscard]] QByteArray packedSeries(std::span<const std::uint64_t> values);

/// `count` numbers from the front of `bytes`, which is shortened by them. Nothing where they are not such, or
/// are fewer: a count may say anything, so not more memory is taken than a thousandfold of what is there.
[[nodiscard]] std::optional<std::vector<double>> takeDoubles(QByteArrayView& bytes, std::uint64_t count);
[[nodiscard]] std::optional<std::vector<std::uint64_t>> takeIntegers(QByteArrayView& bytes,
                                                                     std::uint64_t count);

} // namespace gripscope
