// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profile_note.h"

#include "devices/profile/profile_json.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString title()
{
    return QString::fromLatin1(profileNote.data(), static_cast<qsizetype>(profileNote.size()));
}

} // namespace

QString toNote(const ProfiledDevice& device)
{
    return title() + u"serial: "_s + device.serial.simplified() + u'\n' +
           QString::fromUtf8(writeProfile(device.profile));
}

std::optional<ProfiledDevice> profiledDeviceOf(const QString& note)
{
    const QString serial = u"serial: "_s;
    const QString line = note.section(u'\n', 1, 1);
    if (!note.startsWith(title()) || !line.startsWith(serial))
        return std::nullopt;
    const ProfileReading reading = readProfile(note.section(u'\n', 2).toUtf8());
    if (!reading.profile)
        return std::nullopt;
    return ProfiledDevice{*reading.profile, line.mid(serial.size())};
}

} // namespace gripscope
