// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"
#include "devices/profile/profile_json.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Of scales and offsets: with 32 bits of counts the readings stay in range (recording_limits.h).
constexpr double largestFactor = 1e12;

class Checks {
public:
    explicit Checks(const GripperProfile& profile) : m_profile(profile), m_fields(fieldsOf(profile)) {}

    std::vector<ProfileProblem> all()
    {
        checkDevice();
        checkReport();
        for (const NamedField& field : m_fields)
            checkField(field);
        checkChannel(u"force"_s, m_profile.force, newtonsPer(m_profile.force.unit).has_value(),
                     Words::tr("uN, mN, N or kN"));
        checkChannel(u"position"_s, m_profile.position, metresPer(m_profile.position.unit).has_value(),
                     Words::tr("nm, um, mm, cm or m"));
        checkCounters();
        checkFlags();
        if (m_problems.empty()) // where fields are is known only then
            checkOverlaps();
        return m_problems;
    }

private:
    void report(const QString& pointer, const QString& found, const QString& expected)
    {
        m_problems.push_back({pointer, found, expected});
    }
    static QString at(const QString& field, const QString& name)
    {
        return u"/fields/"_s + field + u'/' + name;
    }
    [[nodiscard]] std::size_t lastShift(const NamedField& field) const
    {
        return field.repeats ? (m_profile.samples - 1) * m_profile.stride : 0;
    }

    void checkDevice();
    void checkReport();
    void checkField(const NamedField& named);
    void checkPlace(const NamedField& named);
    void checkChannel(const QString& name, const ProfileChannel& channel, bool unitKnown,
                      const QString& units);
    void checkCounters();
    void checkFlags();
    void checkOverlaps();
    void mark(const NamedField& named, std::size_t shift, std::vector<int>& owners);

    const GripperProfile& m_profile;
    const std::vector<NamedField> m_fields;
    std::vector<ProfileProblem> m_problems;
};

void Checks::checkDevice()
{
    if (m_profile.vendor == protocol::vendorId && m_profile.product == protocol::productId)
        report(
            u"/device"_s, m_profile.usbNumbers(),
            Words::tr("the numbers of another gripper: this one speaks Gripscope's own protocol and needs no "
                      "profile"));
}

void Checks::checkReport()
{
    if (!isSampleTime(m_profile.sampleTime_s()))
        report(u"/report/samples_per_second"_s, QString::number(m_profile.samplesPerSecond),
               Words::tr("a sample time of %1").arg(sampleTimeExpectation().describe()));
    if (m_profile.samples > 1 && m_profile.stride == 0)
        report(u"/report"_s, Words::tr("%1 samples without a stride").arg(m_profile.samples),
               Words::tr("a stride, the bytes from one sample to the next"));
}

void Checks::checkField(const NamedField& named)
{
    const ProfileField& field = *named.field;
    const auto typeBits = static_cast<unsigned>(8 * field.size());
    if (field.type == FieldType::F32 && (field.firstBit > 0 || field.bits > 0))
        report(at(named.name, u"bits"_s), Words::tr("bits of an f32"),
               Words::tr("a whole number type, or neither first_bit nor bits"));
    else if (field.firstBit >= typeBits || field.firstBit + field.bits > typeBits)
        report(
            at(named.name, u"first_bit"_s),
            Words::tr("bits %1 to %2").arg(field.firstBit).arg(field.firstBit + std::max(1U, field.bits) - 1),
            Words::tr("bits within the %1 of %2, 0 to %3")
                .arg(typeBits)
                .arg(toString(field.type))
                .arg(typeBits - 1));
    checkPlace(named);
}

void Checks::checkPlace(const NamedField& named)
{
    const std::size_t end = named.field->end() + lastShift(named);
    if (m_profile.reportId && named.field->byte == 0)
        report(at(named.name, u"byte"_s), u"0"_s, Words::tr("1 or more: byte 0 is the report ID"));
    else if (end > m_profile.reportLength)
        report(at(named.name, u"byte"_s),
               Words::tr("%1, so that the field ends behind byte %2").arg(named.field->byte).arg(end - 1),
               Words::tr("a field that ends at byte %1 at the latest, as the report is %2 bytes long")
                   .arg(static_cast<qint64>(m_profile.reportLength) - 1)
                   .arg(m_profile.reportLength));
}

void Checks::checkChannel(const QString& name, const ProfileChannel& channel, bool unitKnown,
                          const QString& units)
{
    if (!unitKnown)
        report(at(name, u"unit"_s), u'"' + channel.unit + u'"',
               Words::tr("a unit of %1: %2").arg(name, units));
    if (channel.scale == 0 || !std::isfinite(channel.scale))
        report(at(name, u"scale"_s), QString::number(channel.scale),
               Words::tr("a number other than 0: all values would be the same"));
    else if (std::abs(channel.scale) > largestFactor)
        report(at(name, u"scale"_s), QString::number(channel.scale),
               Words::tr("a number of at most %1").arg(largestFactor));
    if (std::abs(channel.offset) > largestFactor)
        report(at(name, u"offset"_s), QString::number(channel.offset),
               Words::tr("a number of at most %1").arg(largestFactor));
    if (channel.saturatesBelow && channel.saturatesAbove &&
        *channel.saturatesBelow >= *channel.saturatesAbove)
        report(at(name, u"saturates_below"_s), QString::number(*channel.saturatesBelow),
               Words::tr("less than saturates_above, which is %1").arg(*channel.saturatesAbove));
}

void Checks::checkCounters()
{
    const auto unsignedOnly = [&](const QString& name, const ProfileField& field) {
        if (field.isSigned())
            report(at(name, u"type"_s), toString(field.type),
                   Words::tr("u8, u16, u24 or u32: it counts upwards"));
    };
    // Fewer bits come round before a lost report can be told from one that came twice.
    constexpr unsigned fewest = 3;
    if (m_profile.sequence) {
        unsignedOnly(u"sequence"_s, m_profile.sequence->field);
        if (m_profile.sequence->field.width() < fewest)
            report(at(u"sequence"_s, u"bits"_s), QString::number(m_profile.sequence->field.width()),
                   Words::tr("at least %1 bits").arg(fewest));
    }
    if (!m_profile.time)
        return;
    const ProfileTime& time = *m_profile.time;
    unsignedOnly(u"time"_s, time.field);
    const double round_s = time.secondsPerCount() * (time.field.most() + 1);
    if (round_s < 4 * m_profile.reportTime_s())
        report(at(u"time"_s, u"type"_s), Words::tr("a clock that comes round every %1 s").arg(round_s),
               Words::tr("one that takes at least four reports, %1 s").arg(4 * m_profile.reportTime_s()));
}

void Checks::checkFlags()
{
    if (!m_profile.status)
        return;
    const ProfileStatus& status = *m_profile.status;
    for (std::size_t i = 0; i < status.flags.size(); ++i)
        if (status.flags[i].bit >= status.field.width())
            report(u"/fields/status/flags/%1/bit"_s.arg(i), QString::number(status.flags[i].bit),
                   Words::tr("a bit of the %1, 0 to %2")
                       .arg(toString(status.field.type))
                       .arg(status.field.width() - 1));
}

void Checks::checkOverlaps()
{
    std::vector<int> owners(8 * m_profile.reportLength, -1); // of every bit, an index into m_fields
    for (const NamedField& named : m_fields) {
        const std::size_t count = named.repeats ? m_profile.samples : 1;
        for (std::size_t i = 0; i < count; ++i)
            mark(named, i * m_profile.stride, owners);
    }
}

/// Puts the field's bits down as its own; tells when one is another's already.
void Checks::mark(const NamedField& named, std::size_t shift, std::vector<int>& owners)
{
    const ProfileField& field = *named.field;
    const auto self = static_cast<int>(&named - m_fields.data());
    for (unsigned bit = field.firstBit; bit < field.firstBit + field.width(); ++bit) {
        const std::size_t inBytes = field.bigEndian ? field.size() - 1 - bit / 8 : bit / 8;
        int& owner = owners[8 * (field.byte + shift + inBytes) + bit % 8];
        const int before = std::exchange(owner, self);
        if (before < 0)
            continue;
        const NamedField& other = m_fields[static_cast<std::size_t>(before)];
        if (field.sharesBytes || other.field->sharesBytes)
            continue;
        const QString pointer = at(named.name, u"byte"_s);
        if (!m_problems.empty() && m_problems.back().pointer == pointer)
            return; // once is enough
        report(pointer,
               Words::tr("%1, where %2 has bits already")
                   .arg(field.byte)
                   .arg(before == self ? Words::tr("the sample before") : other.name),
               Words::tr("bits of its own, or \"shares_bytes\": true where that is meant"));
        return;
    }
}

} // namespace

std::vector<ProfileProblem> findProfileProblems(const GripperProfile& profile)
{
    return Checks(profile).all();
}

} // namespace gripscope
