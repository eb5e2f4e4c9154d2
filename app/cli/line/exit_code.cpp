// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/exit_code.h"

namespace gripscope::cli {

Exit exitFor(const Error& error)
{
    switch (error.code) {
    case ErrorCode::Usage:
    case ErrorCode::NotSupportedYet:
        return Exit::Usage;
    case ErrorCode::FileUnreadable:
    case ErrorCode::BadInput:
    case ErrorCode::NotFound:
    case ErrorCode::UnitsDiffer:
        return Exit::BadInput;
    case ErrorCode::DeviceNotFound:
    case ErrorCode::DeviceAmbiguous:
    case ErrorCode::DevicePermission:
    case ErrorCode::DeviceLost:
    case ErrorCode::DeviceRefused:
    case ErrorCode::DeviceTimeout:
    case ErrorCode::ArmingRefused:
    case ErrorCode::Stopped:
    case ErrorCode::StopNotObeyed:
    case ErrorCode::LimitExceeded:
    case ErrorCode::NotArmed:
    case ErrorCode::Cancelled:
        return Exit::Device;
    case ErrorCode::FileUnwritable:
    case ErrorCode::StorageOpen:
    case ErrorCode::StorageFailed:
    case ErrorCode::StorageUnknown:
    case ErrorCode::StorageNewer:
    case ErrorCode::StorageCorrupt:
        return Exit::Storage;
    }
    return Exit::Usage;
}

void ExitCode::add(Exit exit)
{
    const int code = static_cast<int>(exit);
    if (code != 0 && (m_value == 0 || code < m_value))
        m_value = code;
}

} // namespace gripscope::cli
