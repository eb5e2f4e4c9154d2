// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/library_change.h"

#include "core/base/words.h"

#include <array>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct KindName {
    ChangeKind kind;
    const char16_t* name;
};

constexpr std::array<KindName, 16> kindNames{{{ChangeKind::NewType, u"new_type"},
                                              {ChangeKind::Squeeze, u"squeeze"},
                                              {ChangeKind::Drop, u"drop"},
                                              {ChangeKind::Undrop, u"undrop"},
                                              {ChangeKind::Recipe, u"recipe"},
                                              {ChangeKind::Approve, u"approve"},
                                              {ChangeKind::Rename, u"rename"},
                                              {ChangeKind::Merge, u"merge"},
                                              {ChangeKind::Split, u"split"},
                                              {ChangeKind::Retire, u"retire"},
                                              {ChangeKind::Reinstate, u"reinstate"},
                                              {ChangeKind::Code, u"code"},
                                              {ChangeKind::Limits, u"limits"},
                                              {ChangeKind::Restore, u"restore"},
                                              {ChangeKind::Examples, u"examples"},
                                              {ChangeKind::Meeting, u"meeting"}}};

constexpr std::array allStatuses{TypeStatus::Enrolled, TypeStatus::Approved, TypeStatus::Retired,
                                 TypeStatus::Gone};

/// "1 squeeze", "10 squeezes".
QString squeezes(int count)
{
    return count == 1 ? Words::tr("1 squeeze") : Words::tr("%1 squeezes").arg(count);
}

/// The change of squeezes, and what follows from it.
QString withApproval(const QString& words, const LibraryChange& change)
{
    return change.other == QString::fromUtf16(approvalVoid) ? Words::tr("%1 Its approval is void.").arg(words)
                                                            : words;
}

} // namespace

QString toString(ChangeKind kind)
{
    for (const KindName& known : kindNames)
        if (known.kind == kind)
            return QString::fromUtf16(known.name);
    return {};
}

std::optional<ChangeKind> changeKindFromString(const QString& text)
{
    for (const KindName& known : kindNames)
        if (QString::fromUtf16(known.name) == text)
            return known.kind;
    return {};
}

QString toString(TypeStatus status)
{
    switch (status) {
    case TypeStatus::Enrolled:
        return u"enrolled"_s;
    case TypeStatus::Approved:
        return u"approved"_s;
    case TypeStatus::Retired:
        return u"retired"_s;
    case TypeStatus::Gone:
        return u"gone"_s;
    }
    return {};
}

std::optional<TypeStatus> typeStatusFromString(const QString& text)
{
    for (const TypeStatus status : allStatuses)
        if (toString(status) == text)
            return status;
    return {};
}

QString inWords(const LibraryChange& change)
{
    const QString& type = change.type;
    const QString& other = change.other;
    switch (change.kind) {
    case ChangeKind::NewType:
        return Words::tr("%1 was added as a new type.").arg(type);
    case ChangeKind::Squeeze:
        return withApproval(Words::tr("%1 was enrolled with %2 more.").arg(type, squeezes(change.squeezes)),
                            change);
    case ChangeKind::Drop:
        return withApproval(Words::tr("%2 of %1 was dropped.").arg(type, squeezes(change.squeezes)), change);
    case ChangeKind::Undrop:
        return withApproval(Words::tr("%2 of %1 counts again.").arg(type, squeezes(change.squeezes)), change);
    case ChangeKind::Recipe:
        return Words::tr("The recipe of %1 was changed.").arg(type);
    case ChangeKind::Approve:
        return Words::tr("%1 was approved.").arg(type);
    case ChangeKind::Rename:
        return Words::tr("%1 was renamed %2.").arg(type, other);
    case ChangeKind::Merge:
        return Words::tr("%1 was merged into %2, with %3.").arg(type, other, squeezes(change.squeezes));
    case ChangeKind::Split:
        return Words::tr("%3 of %1 became the new type %2.").arg(type, other, squeezes(change.squeezes));
    case ChangeKind::Retire:
        return Words::tr("%1 was retired: it is no longer recognised.").arg(type);
    case ChangeKind::Reinstate:
        return Words::tr("%1 was put back into use.").arg(type);
    case ChangeKind::Code:
        return other.isEmpty() ? Words::tr("%1 no longer has a code for scanners.").arg(type)
                               : Words::tr("%1 got the code %2 for scanners.").arg(type, other);
    case ChangeKind::Limits:
        return other.isEmpty() ? Words::tr("%1 no longer has tolerance limits.").arg(type)
                               : Words::tr("The tolerance limits of %1 are %2.").arg(type, other);
    case ChangeKind::Restore:
        return Words::tr("The library was put back to version %1.").arg(other);
    case ChangeKind::Examples:
        return Words::tr("The paper's example types were added.");
    case ChangeKind::Meeting:
        return Words::tr("The library %1 was merged into this one.").arg(other);
    }
    return {};
}

} // namespace gripscope
