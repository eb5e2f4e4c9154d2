// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "core/base/places.h"
#include "core/base/printable.h"

#include <QCoreApplication>

namespace gripscope {

namespace {

struct Wording {
    const char* name;
    const char* text; ///< %1, %2... stand for the arguments
};

Wording wording(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Usage:
        return {"usage", QT_TRANSLATE_NOOP("Error", "%1")};
    case ErrorCode::FileUnreadable:
        return {"file_unreadable",
                QT_TRANSLATE_NOOP("Error",
                                  "%1: the file cannot be read (%2). Check the name and its permissions.")};
    case ErrorCode::FileUnwritable:
        return {"file_unwritable",
                QT_TRANSLATE_NOOP("Error", "%1: the file cannot be written (%2). Check the folder, its "
                                           "permissions and the free space.")};
    case ErrorCode::BadInput:
        return {"bad_input", QT_TRANSLATE_NOOP("Error", "%1: %2; %3")};
    case ErrorCode::NotSupportedYet:
        return {"not_supported_yet", QT_TRANSLATE_NOOP("Error", "%1 is not supported yet.")};
    case ErrorCode::DeviceNotFound:
        return {"device_not_found", QT_TRANSLATE_NOOP("Error", "No gripper answers at %1. %2")};
    case ErrorCode::DeviceAmbiguous:
        return {"device_ambiguous",
                QT_TRANSLATE_NOOP("Error", "More than one gripper is connected: %1. Name one of them.")};
    case ErrorCode::DevicePermission:
        return {"device_permission",
                QT_TRANSLATE_NOOP("Error", "The gripper at %1 may not be opened by this user. %2")};
    case ErrorCode::DeviceLost:
        return {"device_lost",
                QT_TRANSLATE_NOOP("Error",
                                  "The gripper at %1 went away (%2). Check the cable, then connect again.")};
    case ErrorCode::DeviceRefused:
        return {"device_refused", QT_TRANSLATE_NOOP("Error", "The gripper refused to %1: %2.")};
    case ErrorCode::DeviceTimeout:
        return {"device_timeout",
                QT_TRANSLATE_NOOP("Error",
                                  "The gripper did not %1 within %2 s. Check the cable, then try again.")};
    case ErrorCode::ArmingRefused:
        return {"arming_refused", QT_TRANSLATE_NOOP("Error", "The gripper was not armed: %1.")};
    case ErrorCode::Stopped:
        return {"stopped", QT_TRANSLATE_NOOP("Error", "The gripper was stopped: %1.")};
    case ErrorCode::StopNotObeyed:
        return {"stop_not_obeyed",
                QT_TRANSLATE_NOOP("Error", "The gripper did not obey Stop. Switch off its power.")};
    case ErrorCode::LimitExceeded:
        return {"limit_exceeded",
                QT_TRANSLATE_NOOP("Error",
                                  "%1 of %2 is above the limit of %3 (%4). Nothing was moved; choose less.")};
    case ErrorCode::NotArmed:
        return {"not_armed",
                QT_TRANSLATE_NOOP("Error", "The gripper is not armed, so it did not %1. Arm it first.")};
    case ErrorCode::StorageOpen:
        return {"storage_open", QT_TRANSLATE_NOOP("Error", "The library %1 cannot be opened (%2).")};
    case ErrorCode::StorageFailed:
        return {"storage_failed",
                QT_TRANSLATE_NOOP("Error", "The library could not %1 (%2). Nothing of it was stored.")};
    case ErrorCode::StorageUnknown:
        return {"storage_unknown",
                QT_TRANSLATE_NOOP("Error", "Whether the library did %1 is not known (%2). Look whether it is "
                                           "there before you do it again.")};
    case ErrorCode::StorageNewer:
        return {"storage_newer",
                QT_TRANSLATE_NOOP("Error", "The library %1 has version %2; this program knows up to %3. Use "
                                           "a newer program; the library was not changed.")};
    case ErrorCode::StorageCorrupt:
        return {"storage_corrupt",
                QT_TRANSLATE_NOOP("Error", "%1 is damaged in the library (%2). Restore it from a copy.")};
    case ErrorCode::NotFound:
        return {"not_found", QT_TRANSLATE_NOOP("Error", "There is no %1.")};
    case ErrorCode::UnitsDiffer:
        return {"units_differ", QT_TRANSLATE_NOOP("Error", "The units are %1, but %2 are needed. Name the "
                                                           "units of the channels, or use another library.")};
    case ErrorCode::Cancelled:
        return {"cancelled", QT_TRANSLATE_NOOP("Error", "%1 was cancelled.")};
    }
    return {"unknown", ""};
}

} // namespace

QString Error::name() const
{
    return QString::fromLatin1(wording(code).name);
}

QString Error::argument(std::size_t index) const
{
    return index < arguments.size() ? arguments[index].describe() : QString();
}

QString Error::describe() const
{
    const QString text = QCoreApplication::translate("Error", wording(code).text);
    return withPlacesFilled(
        text, [this](std::size_t place) { return printableLines(argument(place - 1), longestArgument); });
}

} // namespace gripscope
