// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/sql/statement.h"
#include "core/signal/recording/recording.h"

#include <QByteArray>

namespace gripscope {

/// A recording as a row holds it: the size and SHA-256 of its encodeRecording(), and, deflated, its
/// encodeInSeries(); programs before version 12 of the schema deflated the former.
struct PackedRecording {
    qint64 bytes = 0;
    QString sha256;
    QByteArray packed;
};
[[nodiscard]] Expected<PackedRecording> packRecording(const Recording& recording);
/// StorageCorrupt when the bytes are not those that were packed; `what` names it: "The recording of ...".
[[nodiscard]] Expected<Recording> unpackRecording(const PackedRecording& packed, const QString& what);

/// The columns bytes, sha256, packed, in this order.
void bindPacked(Statement& row, const PackedRecording& packed);
[[nodiscard]] PackedRecording takePacked(Statement& row);

/// The bytes of a recording as the library keeps them, every number bit for bit. All values little-endian,
/// doubles as IEEE 754 binary64, texts as a 32-bit count of bytes followed by UTF-8:
///
///     "GSRB"  u16 version (1, or 2 to 4 with a measuring chain at the end)
///     f64 sampleTime_s   f64 forceLag_s   u8 hold (0: not said, 1: zero-order, 2: first-order)
///     text forceUnit   text positionUnit
///     u32 n   n times (text key, text value)           provenance, sorted by key
///     u64 samples   u8 columns (1: sequence, 2: status)
///     f64 time_s[samples]   f64 force[samples]   f64 position[samples]
///     u64 sequence[samples]  if columns & 1      u16 status[samples]  if columns & 2
///
/// and in version 2, written only for a chain that is not the default, so that all else stays readable to
/// programs that know version 1 alone:
///
///     f64 forceLagUncertainty_s, forceScaleUncertainty, positionScaleUncertainty, frameCompliance,
///         frameComplianceUncertainty      u8 has a baseline (0, 1)
///     f64 parameters[3]   f64 standardErrors[3]        if it has one
///
/// Version 3 has f64 forceNoiseDeviation after frameComplianceUncertainty, version 4, for a gripper whose own
/// friction is known, f64 value and standardError of that behind it.
///
/// Usage when the channels differ in length.
[[nodiscard]] Expected<QByteArray> encodeRecording(const Recording& recording);
/// The same with "GSRP", and each column as packedSeries(), which deflates far better.
[[nodiscard]] Expected<QByteArray> encodeInSeries(const Recording& recording);
/// Either of the two. StorageCorrupt when the bytes are not exactly one such block.
[[nodiscard]] Expected<Recording> decodeRecording(const QByteArray& bytes);

} // namespace gripscope
