// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <span>
#include <vector>

namespace gripscope {

/// A capture (.gscap): raw reports with the time they came, byte for byte, good or bad, and notes of what the
/// program did meanwhile. See devices/PROTOCOL.md.
enum class CaptureKind : std::uint16_t { Input = 0, Feature = 1, Output = 2, Note = 3 };

inline constexpr std::size_t longestCapturedReport = 128;
inline constexpr std::size_t longestCaptureNote = 65535;
inline constexpr std::uint64_t latestCapturedTime_us = 31'622'400'000'000; ///< a year
inline constexpr qsizetype captureRecordHead = 12; ///< bytes before those of the report

struct CaptureRecord {
    std::uint64_t time_us = 0; ///< since the session began; never decreases
    CaptureKind kind = CaptureKind::Input;
    std::vector<std::uint8_t> bytes; ///< a report, or a note in UTF-8
    friend bool operator==(const CaptureRecord&, const CaptureRecord&) = default;

    [[nodiscard]] QString note() const
    {
        return QString::fromUtf8(reinterpret_cast<const char*>(bytes.data()),
                                 static_cast<qsizetype>(bytes.size()));
    }
};

[[nodiscard]] QByteArray captureHeader();
[[nodiscard]] QByteArray encodeRecord(std::uint64_t time_us, CaptureKind kind,
                                      std::span<const std::uint8_t> bytes);
/// The twelve bytes before those of the report, to `to`.
void encodeRecordHead(std::uint64_t time_us, CaptureKind kind, std::size_t length, std::uint8_t* to);

/// All whole records. A file cut short in a record (the program died) gives those before it. BadInput with
/// the place FILE:BYTE for anything else, FileUnreadable. For whole sessions see CaptureReader.
[[nodiscard]] Expected<std::vector<CaptureRecord>> parseCapture(const QByteArray& bytes, const QString& name);
[[nodiscard]] Expected<std::vector<CaptureRecord>> readCapture(const QString& file);

} // namespace gripscope
