// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/profile_library.h"

#include "core/base/words.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const QString shippedFolder = u":/profiles"_s;
/// Layouts that only virtual grippers send, for the manual; no gripper is found by them.
const QString virtualFolder = u":/virtual_grippers"_s;

void loadFolder(const QString& folder, bool shipped, ProfileCollection& collection)
{
    for (const QString& name : QDir(folder).entryList({u"*.json"_s}, QDir::Files, QDir::Name)) {
        if (name.endsWith(u".schema.json"))
            continue;
        const QString file = folder + u'/' + name;
        Expected<GripperProfile> profile = readProfileFile(file);
        if (profile)
            collection.profiles.push_back({std::move(*profile), file, shipped});
        else
            collection.errors.push_back(profile.error());
    }
}

} // namespace

const KnownProfile* ProfileCollection::find(std::uint16_t vendor, std::uint16_t product) const
{
    for (const KnownProfile& known : profiles)
        if (known.profile.vendor == vendor && known.profile.product == product)
            return &known;
    return nullptr;
}

QString userProfileFolder()
{
    const QString named = qEnvironmentVariable("GRIPSCOPE_PROFILES");
    return named.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                                 u"/gripscope/profiles"_s
                           : named;
}

ProfileCollection loadProfiles()
{
    ProfileCollection collection;
    loadFolder(userProfileFolder(), false, collection);
    loadFolder(shippedFolder, true, collection);
    return collection;
}

Expected<GripperProfile> profileFor(std::uint16_t vendor, std::uint16_t product)
{
    const ProfileCollection known = loadProfiles();
    if (const KnownProfile* found = known.find(vendor, product))
        return found->profile;
    if (!known.errors.empty())
        return tl::unexpected<Error>(known.errors.front());
    GripperProfile numbers;
    numbers.vendor = vendor;
    numbers.product = product;
    return failure(
        ErrorCode::NotFound,
        {Words::tr("profile for a gripper %1: write one (the manual's page on profiles says how) and put "
                   "it into %2, or name it behind the address: ?profile=FILE")
             .arg(numbers.usbNumbers(), userProfileFolder())});
}

Expected<GripperProfile> namedProfile(const QString& name)
{
    if (!QFileInfo::exists(name) && !name.contains(u'/') && !name.contains(u'.'))
        for (const QString& folder : {shippedFolder, virtualFolder})
            if (const QString file = folder + u'/' + name + u".json"_s; QFileInfo::exists(file))
                return readProfileFile(file);
    return readProfileFile(name);
}

Expected<QString> installProfile(const QByteArray& json)
{
    const ProfileReading reading = readProfile(json);
    if (!reading.profile)
        return tl::unexpected<Error>(toError(reading.problems.front(), u"profile"_s));
    const QString folder = userProfileFolder();
    const QString file = folder + u'/' + reading.profile->usbNumbers().replace(u':', u'_') + u".json"_s;
    if (!QDir().mkpath(folder))
        return failure(ErrorCode::FileUnwritable, {folder, Words::tr("the folder cannot be made")});
    return writeWholeFile(file, json).map([&] { return file; });
}

Expected<void> writeWholeFile(const QString& file, const QByteArray& bytes)
{
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() || !out.commit())
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    return {};
}

} // namespace gripscope
