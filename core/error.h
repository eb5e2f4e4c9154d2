// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace gripscope {

/// What went wrong, as a value. The code says it to programs, the arguments carry what a person needs to know
/// (file, line, found, expected...), and describe() puts both into words.
enum class ErrorCode {
    Usage,            ///< the request itself makes no sense: reason
    FileUnreadable,   ///< file, reason
    FileUnwritable,   ///< file, reason
    BadInput,         ///< place (FILE:LINE:COLUMN), what was found, what was expected
    NotSupportedYet,  ///< what
    DeviceNotFound,   ///< address, what to do
    DeviceAmbiguous,  ///< the addresses that match
    DevicePermission, ///< address, what to do
    DeviceLost,       ///< address, reason
    DeviceRefused,    ///< what was asked, reason
    DeviceTimeout,    ///< what was asked, seconds waited
    LimitExceeded,    ///< quantity, value asked, limit, whose limit
    NotArmed,         ///< what was asked
    StorageOpen,      ///< file, reason
    StorageFailed,    ///< what was being done, reason
    StorageNewer,     ///< file, its version, the newest version known here
    StorageCorrupt,   ///< what, reason
    NotFound,         ///< what
    UnitsDiffer,      ///< units found, units expected
    Cancelled,        ///< what
};

struct Error {
    ErrorCode code = ErrorCode::Usage;
    QStringList arguments;

    /// Stable lower-case name for JSON documents and logs, such as "bad_input".
    [[nodiscard]] QString name() const;
    /// A sentence for a person: what happened, where, what to do. Translated where a translator is installed.
    [[nodiscard]] QString describe() const;

    friend bool operator==(const Error&, const Error&) = default;
};

template <typename T>
using Expected = tl::expected<T, Error>;

/// `return failure(ErrorCode::NotFound, {name});`
[[nodiscard]] inline tl::unexpected<Error> failure(ErrorCode code, QStringList arguments)
{
    return tl::unexpected<Error>(Error{code, std::move(arguments)});
}

} // namespace gripscope
