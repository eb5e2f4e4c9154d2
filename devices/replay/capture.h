// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <span>
#include <vector>

namespace gripscope {

/// A capture (.gscap): raw reports with the time they came, byte for byte, good or bad. See
/// devices/PROTOCOL.md.
enum class CaptureKind : std::uint16_t { Input = 0, Feature = 1, Output = 2 };

struct CaptureRecord {
    std::uint64_t time_us = 0; ///< since the capture began; never decreases
    CaptureKind kind = CaptureKind::Input;
    std::vector<std::uint8_t> bytes; ///< at most 128
    friend bool operator==(const CaptureRecord&, const CaptureRecord&) = default;
};

[[nodiscard]] QByteArray captureHeader();
[[nodiscard]] QByteArray encodeRecord(std::uint64_t time_us, CaptureKind kind,
                                      std::span<const std::uint8_t> bytes);

/// All whole records. A file cut short in a record (the program died) gives those before it. BadInput with
/// the place FILE:BYTE for anything else, FileUnreadable.
[[nodiscard]] Expected<std::vector<CaptureRecord>> parseCapture(const QByteArray& bytes, const QString& name);
[[nodiscard]] Expected<std::vector<CaptureRecord>> readCapture(const QString& file);

} // namespace gripscope
