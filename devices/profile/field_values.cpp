// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/field_values.h"

#include "core/base/words.h"
namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString flagsThatHold(const ProfileStatus& status, std::uint32_t bits)
{
    QStringList words;
    for (const ProfileFlag& flag : status.flags)
        if (((bits >> flag.bit & 1U) != 0) == flag.whenSet)
            words << flagName(flag.meaning);
    return words.join(u", "_s);
}

FieldValue valueOf(const GripperProfile& profile, const NamedField& named, std::size_t index,
                   protocol::ReportView report)
{
    const std::size_t shift = index * profile.stride;
    FieldValue value{named.name, index, named.field->byte + shift, named.field->end() + shift, 0, 0, {}, {}};
    value.number = value.value = named.field->number(report, shift);
    if (named.repeats) {
        const ProfileChannel& channel = named.name == u"force" ? profile.force : profile.position;
        value.value = channel.value(value.number);
        value.unit = channel.unit;
    } else if (named.name == u"time") {
        value.value = value.number * profile.time->secondsPerCount();
        value.unit = u"s"_s;
    } else if (named.name == u"status") {
        value.words = flagsThatHold(*profile.status, named.field->count(report));
    }
    return value;
}

} // namespace

std::vector<FieldValue> fieldValues(const GripperProfile& profile, protocol::ReportView report)
{
    std::vector<FieldValue> values;
    const bool otherId = profile.reportId && (report.empty() || report[0] != *profile.reportId);
    if (otherId || report.size() != profile.reportLength)
        return values;
    for (const NamedField& named : fieldsOf(profile)) {
        const std::size_t count = named.repeats ? profile.samples : 1;
        for (std::size_t i = 0; i < count; ++i)
            values.push_back(valueOf(profile, named, i, report));
    }
    return values;
}

QString ownersOfByte(const GripperProfile& profile, std::size_t byte)
{
    QStringList owners;
    if (profile.reportId && byte == 0)
        owners << Words::tr("report ID");
    for (const NamedField& named : fieldsOf(profile)) {
        const std::size_t count = named.repeats ? profile.samples : 1;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t first = named.field->byte + i * profile.stride;
            if (byte >= first && byte < first + named.field->size())
                owners << (count > 1 ? u"%1 %2"_s.arg(named.name).arg(i + 1) : named.name);
        }
    }
    return owners.join(u", "_s);
}

} // namespace gripscope
