// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/protocol/report.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

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

/// Force or position: value = number in the report x scale + offset, in `unit`.
struct ProfileChannel {
    ProfileField field;
    double scale = 1;
    double offset = 0;
    QString unit;
    /// Numbers as in the report, at and beyond which the sensor is at the end of its range.
    std::optional<double> saturatesBelow, saturatesAbove;

    [[nodiscard]] double value(double number) const { return number * scale + offset; }
    [[nodiscard]] bool saturated(double number) const
    {
        return (saturatesBelow && number <= *saturatesBelow) || (saturatesAbove && number >= *saturatesAbove);
    }
    friend bool operator==(const ProfileChannel&, const ProfileChannel&) = default;
};

/// A counter by which losses are seen.
struct ProfileSequence {
    ProfileField field;
    bool countsSamples = false; ///< the number of the report's first sample; else one up with every report
    friend bool operator==(const ProfileSequence&, const ProfileSequence&) = default;
};

/// The device's clock at the first sample of the report.
struct ProfileTime {
    ProfileField field;
    double scale = 1; ///< units in one count
    QString unit = QStringLiteral("us");

    [[nodiscard]] double secondsPerCount() const;
    friend bool operator==(const ProfileTime&, const ProfileTime&) = default;
};

struct ProfileFlag {
    unsigned bit = 0;
    std::uint16_t meaning = 0; ///< one of SampleStatus
    bool whenSet = true;       ///< false: it holds while the bit is clear
    friend bool operator==(const ProfileFlag&, const ProfileFlag&) = default;
};

struct ProfileStatus {
    ProfileField field;
    std::vector<ProfileFlag> flags;
    friend bool operator==(const ProfileStatus&, const ProfileStatus&) = default;
};

/// By what a lost report is noticed.
enum class LossEvidence { SequenceNumber, Clock, None };

/// What the bytes of another maker's gripper mean. Made by readProfile() only, or put together by a form that
/// has it checked (findProfileProblems); everything else relies on its fields being within the report.
///
/// Format 1 is for listening: nothing is ever written to such a gripper.
struct GripperProfile {
    QString name, maker, notes;
    std::uint16_t vendor = 0, product = 0;
    std::optional<std::uint8_t> reportId;
    std::size_t reportLength = 0; ///< with the report ID
    double samplesPerSecond = 0;
    std::size_t samples = 1; ///< pairs of force and position in a report, oldest first
    std::size_t stride = 0;  ///< bytes from one to the next; 0 where there is one
    ForceHold hold = ForceHold::Zero;
    double forceLag_s = 0;
    ProfileChannel force, position;
    std::optional<ProfileSequence> sequence;
    std::optional<ProfileTime> time;
    std::optional<ProfileStatus> status;

    [[nodiscard]] double sampleTime_s() const { return 1.0 / samplesPerSecond; }
    [[nodiscard]] double reportTime_s() const { return static_cast<double>(samples) / samplesPerSecond; }
    /// The clock ticks often enough to tell one report from the next; a coarser one is not used at all.
    [[nodiscard]] bool clockIsFine() const;
    [[nodiscard]] LossEvidence lossEvidence() const;
    /// "1209:0002".
    [[nodiscard]] QString usbNumbers() const;

    friend bool operator==(const GripperProfile&, const GripperProfile&) = default;
};

/// Every field there is, with its name in the JSON document ("force"), in the order of the document.
struct NamedField {
    QString name;
    const ProfileField* field; ///< into the profile
    bool repeats;              ///< with every sample of the report
};
[[nodiscard]] std::vector<NamedField> fieldsOf(const GripperProfile& profile);

/// "moving", "force_saturated"...; empty for a bit that profiles do not know.
[[nodiscard]] QString flagName(std::uint16_t meaning);
[[nodiscard]] std::uint16_t flagFromName(const QString& name); ///< 0: not known
[[nodiscard]] QStringList flagNames();

} // namespace gripscope
