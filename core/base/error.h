// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <QString>
#include <tl/expected.hpp>

#include <optional>
#include <utility>

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
    ArmingRefused,    ///< why this program did not arm the gripper
    Stopped,          ///< why this program, or the gripper itself, stopped it
    StopNotObeyed,    ///< nothing to add
    LimitExceeded,    ///< quantity, value asked, limit, whose limit
    NotArmed,         ///< what was asked
    StorageOpen,      ///< file, reason
    StorageFailed,    ///< what was being done, reason
    StorageUnknown,   ///< what was being done, reason: it may or may not be stored
    StorageNewer,     ///< file, its version, the newest version known here
    StorageCorrupt,   ///< what, reason
    NotFound,         ///< what
    UnitsDiffer,      ///< units found, units expected
    Cancelled,        ///< what
};

struct Error {
    ErrorCode code = ErrorCode::Usage;
    Findings arguments;

    /// Stable lower-case name for JSON documents and logs, such as "bad_input".
    [[nodiscard]] QString name() const;
    /// The argument at `index` in words; empty where there is none.
    [[nodiscard]] QString argument(std::size_t index) const;
    /// A sentence for a person: what happened, where, what to do. Translated where a translator is installed.
    [[nodiscard]] QString describe() const;

    friend bool operator==(const Error&, const Error&) = default;
};

template <typename T>
using Expected = tl::expected<T, Error>;

/// `return failure(ErrorCode::NotFound, {name});`
[[nodiscard]] inline tl::unexpected<Error> failure(ErrorCode code, Findings arguments)
{
    return tl::unexpected<Error>(Error{code, std::move(arguments)});
}

namespace detail {
template <typename T>
[[nodiscard]] const Error* errorOf(const Expected<T>& result)
{
    return result ? nullptr : &result.error();
}
[[nodiscard]] inline const Error* errorOf(const std::optional<Error>& problem)
{
    return problem ? &*problem : nullptr;
}
} // namespace detail

#define GRIPSCOPE_JOIN_(a, b) a##b
#define GRIPSCOPE_JOIN(a, b) GRIPSCOPE_JOIN_(a, b)
#define GRIPSCOPE_RETURN_IF_ERROR_(result, ...)                                                              \
    do {                                                                                                     \
        const auto result = (__VA_ARGS__);                                                                   \
        if (::gripscope::detail::errorOf(result) != nullptr)                                                 \
            return tl::make_unexpected(*::gripscope::detail::errorOf(result));                               \
    } while (false)
#define GRIPSCOPE_ASSIGN_OR_RETURN_(result, declaration, ...)                                                \
    auto result = (__VA_ARGS__);                                                                             \
    if (!result)                                                                                             \
        return tl::make_unexpected(std::move(result).error());                                               \
    declaration = *std::move(result)

/// `RETURN_IF_ERROR(check(recipe));`: hands the error of an Expected, or an optional<Error>, to the caller.
#define RETURN_IF_ERROR(...) GRIPSCOPE_RETURN_IF_ERROR_(GRIPSCOPE_JOIN(result_, __COUNTER__), __VA_ARGS__)
/// `ASSIGN_OR_RETURN(const Person person, people.named(name));`: declares the value, or hands the error on.
#define ASSIGN_OR_RETURN(declaration, ...)                                                                   \
    GRIPSCOPE_ASSIGN_OR_RETURN_(GRIPSCOPE_JOIN(result_, __COUNTER__), declaration, __VA_ARGS__)

} // namespace gripscope
