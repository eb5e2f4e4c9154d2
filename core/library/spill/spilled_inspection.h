// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/records/inspection_record.h"

#include <QByteArray>

namespace gripscope {

/// An inspection that waits in a file to be stored.
struct SpilledInspection {
    NewInspection inspection;
    qint64 place = 0; ///< there
};

/// All that the library stores of an inspection, as bytes: deflated, a u64 n (big-endian), a JSON document of
/// n bytes, and the recording as encodeInSeries(), if there is one. What is only shown (simulated responses,
/// residuals) is not in it. A field that NewInspection gets belongs here too: a test compares the rows.
/// Usage: what no library would take either, or more than can be kept.
[[nodiscard]] Expected<QByteArray> packInspection(const NewInspection& inspection);
/// What all that is unpacked of one file may take in memory: more than a full one of any gripper's.
inline constexpr qint64 mostOfOneFile = 400'000'000;
/// StorageCorrupt for anything else. `memory` is what it may take, and is less by that afterwards.
[[nodiscard]] Expected<NewInspection> unpackInspection(const QByteArray& bytes, qint64& memory);

} // namespace gripscope
