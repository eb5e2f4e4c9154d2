// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"
#include "core/store/statement.h"

namespace gripscope {

/// A recording as a row holds it: packed with zlib, with the SHA-256 of the unpacked bytes
/// (recording_codec.h).
struct PackedRecording {
    qint64 bytes = 0; ///< unpacked
    QString sha256;
    QByteArray packed;
};
[[nodiscard]] Expected<PackedRecording> packRecording(const Recording& recording);
/// StorageCorrupt when the bytes are not those that were packed; `what` names it: "The recording of ...".
[[nodiscard]] Expected<Recording> unpackRecording(const PackedRecording& packed, const QString& what);

/// The columns bytes, sha256, packed, in this order.
void bindPacked(Statement& row, const PackedRecording& packed);
[[nodiscard]] PackedRecording takePacked(Statement& row);

} // namespace gripscope
