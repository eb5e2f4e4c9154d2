// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace gripscope {

enum class FieldType { U8, U16, U24, U32, I8, I16, I24, I32, F32 };
[[nodiscard]] QString toString(FieldType type);
[[nodiscard]] std::optional<FieldType> fieldTypeFromString(const QString& text);
[[nodiscard]] QStringList fieldTypeNames();

/// Where a number is in a report, and how it is written there.
struct ProfileField {
    std::size_t byte = 0; ///< the first of its bytes; where there is a report ID it is byte 0
    FieldType type = FieldType::U8;
    bool bigEndian = false;
    unsigned firstBit = 0;    ///< lowest bit of the whole number that belongs to the field
    unsigned bits = 0;        ///< how many do; 0: all
    bool sharesBytes = false; ///< other fields may use the same bits

    [[nodiscard]] std::size_t size() const; ///< bytes
    [[nodiscard]] std::size_t end() const { return byte + size(); }
    [[nodiscard]] unsigned width() const; ///< bits in use
    [[nodiscard]] bool isSigned() const;
    /// As the number stands in the report, `shift` bytes further on (0 or a multiple of the profile's
    /// stride); the caller has checked that it lies within.
    [[nodiscard]] double number(protocol::ReportView report, std::size_t shift = 0) const;
    /// The same for a field that is unsigned and whole.
    [[nodiscard]] std::uint32_t count(protocol::ReportView report, std::size_t shift = 0) const;
    /// Writes the nearest number the field can hold; the report's other bits stay. False: it had to be cut.
    bool put(double value, std::span<std::uint8_t> report, std::size_t shift = 0) const;
    [[nodiscard]] double least() const;
    [[nodiscard]] double most() const;

    friend bool operator==(const ProfileField&, const ProfileField&) = default;
};

} // namespace gripscope
