// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/conformity/part_limits.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// What was done to the types of a library. Each is one version of the library: 1, 2, 3... Version 0 is the
/// empty library, or what was in it before versions were kept.
enum class ChangeKind {
    NewType,
    Squeeze, ///< added to a type
    Drop,    ///< of a squeeze
    Undrop,  ///< a dropped squeeze counts again
    Recipe,
    Approve,
    Rename,
    Merge,
    Split,
    Retire,
    Reinstate,
    Code,    ///< what a scanner reads on its parts
    Limits,  ///< what m, b and k of its parts may be
    Restore, ///< of an earlier version
    Examples,
    Meeting ///< another library was merged into this one; what differed by that is of this version
};
[[nodiscard]] QString toString(ChangeKind kind);
[[nodiscard]] std::optional<ChangeKind> changeKindFromString(const QString& text);

/// Who asks for a change, and why.
struct ChangeNote {
    QString operatorName, reason;
};

/// What `other` of a change of squeezes says where the type was approved before: it no longer is.
inline constexpr char16_t approvalVoid[] = u"approval void";

struct LibraryChange {
    qint64 version = 0;
    QDateTime changed;
    QString station;
    ChangeKind kind = ChangeKind::NewType;
    QString type; ///< its name before the change; empty where all types are meant
    /// The new name, the type it went into, the new type, its code, its limits, the version restored, the
    /// file that was merged; approvalVoid.
    QString other;
    int squeezes = 0; ///< as many were added, dropped or moved
    QString operatorName, reason;
};
/// "Cola was merged into Pepsi, with 10 squeezes."
[[nodiscard]] QString inWords(const LibraryChange& change);

/// Approved types are recognised; enrolled ones wait for approval: new ones, and those that hold other
/// squeezes than were approved. A retired one is kept and can be put back into use; one that is gone was
/// merged into another, or is of a later version than the one that was restored.
enum class TypeStatus { Enrolled, Approved, Retired, Gone };
[[nodiscard]] QString toString(TypeStatus status);
[[nodiscard]] std::optional<TypeStatus> typeStatusFromString(const QString& text);

/// A type as it is from some version of the library on.
struct TypeState {
    QString typeId, name;
    TypeStatus status = TypeStatus::Enrolled;
    int recipeVersion = 1;  ///< of this type's recipes
    int squeezes = 0;       ///< accepted ones
    QString code = {};      ///< what a scanner reads on its parts; empty: none
    PartLimits limits = {}; ///< what its parts may be; empty: none
};

/// The types of a library at one version, by name, without those that are gone.
struct LibraryState {
    qint64 version = 0;
    std::vector<TypeState> types;
};

} // namespace gripscope
