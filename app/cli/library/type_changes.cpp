// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of `types` that change a library.
#include "app/cli/library/authorization.h"
#include "app/cli/library/type_commands.h"
#include "app/cli/library/type_library.h"

#include <functional>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Changes the library, where roles are in force with a supervisor's consent, and tells what was done.
int change(const CommandLine& line, const std::function<Expected<void>(Library&)>& work,
           Permission permission = Permission::ChangeTypes)
{
    return withLibrary(line, [&](Library& library) -> Expected<void> {
        ASSIGN_OR_RETURN(const auto acting, authorization(library, line.text(u"operator"_qs), permission));
        library.actAs(acting);
        return work(library).and_then([&] { return tellChange(library, line.isSet(u"json"_qs)); });
    });
}

/// The same for what is done to the type of --type.
int changeType(const CommandLine& line,
               const std::function<Expected<void>(Library&, const TypeRecord&)>& work,
               Permission permission = Permission::ChangeTypes)
{
    return change(
        line,
        [&](Library& library) -> Expected<void> {
            ASSIGN_OR_RETURN(const auto type, requireNamed(library, line.text(u"type"_qs)));
            return work(library, type);
        },
        permission);
}

/// What asks for a type and a reason, and no more.
int changeWithReason(CommandLine& line, const QStringList& arguments,
                     Expected<void> (Library::*work)(const QString&, const ChangeNote&))
{
    addTypeOption(line);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs, u"reason"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(
        line, [&](Library& library, const TypeRecord& type) { return (library.*work)(type.id, note(line)); });
}

/// What was made is told by its change.
constexpr auto ignoreValue = [](const auto&) {};

} // namespace

int renameType(const QStringList& arguments)
{
    CommandLine line(u"types rename"_qs, u"Gives a type another name. Inspections keep the old one."_qs);
    addTypeOption(line);
    line.option(u"to"_qs, u"NAME"_qs, u"The new name."_qs);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs, u"to"_qs, u"reason"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(line, [&](Library& library, const TypeRecord& type) {
        return library.renameType(type.id, line.text(u"to"_qs), note(line)).map(ignoreValue);
    });
}

int setTypeCode(const QStringList& arguments)
{
    CommandLine line(u"types code"_qs,
                     u"Sets what a scanner reads on the parts of a type; without --code it has none."_qs);
    addTypeOption(line);
    line.option(u"code"_qs, u"TEXT"_qs, u"A GTIN, a part number."_qs);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs, u"reason"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(line, [&](Library& library, const TypeRecord& type) -> Expected<void> {
        if (type.code == line.text(u"code"_qs).trimmed())
            return failure(ErrorCode::Usage, {u"%1 has that code already."_qs.arg(type.name)});
        return library.setTypeCode(type.id, line.text(u"code"_qs), note(line)).map(ignoreValue);
    });
}

int mergeTypes(const QStringList& arguments)
{
    CommandLine line(u"types merge"_qs,
                     u"Moves the accepted squeezes of a type into another, which then needs approval."_qs);
    addTypeOption(line);
    line.option(u"into"_qs, u"NAME"_qs, u"The type that stays."_qs);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs, u"into"_qs, u"reason"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(line, [&](Library& library, const TypeRecord& type) -> Expected<void> {
        ASSIGN_OR_RETURN(const auto into, requireNamed(library, line.text(u"into"_qs)));
        return library.mergeTypes(type.id, into.id, note(line)).map(ignoreValue);
    });
}

int splitType(const QStringList& arguments)
{
    CommandLine line(u"types split"_qs,
                     u"Moves some accepted squeezes of a type into a new one; both then need approval."_qs);
    addTypeOption(line);
    line.option(u"squeezes"_qs, u"KEYS"_qs,
                u"Their keys, separated by commas; \"types squeezes\" lists them."_qs);
    line.option(u"to"_qs, u"NAME"_qs, u"Name of the new type."_qs);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs, u"squeezes"_qs, u"to"_qs, u"reason"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(line, [&](Library& library, const TypeRecord& type) {
        return library.splitType(type.id, line.list(u"squeezes"_qs), line.text(u"to"_qs), note(line))
            .map(ignoreValue);
    });
}

int retireType(const QStringList& arguments)
{
    CommandLine line(u"types retire"_qs, u"Keeps a type with its squeezes, but recognises it no longer."_qs);
    return changeWithReason(line, arguments, &Library::retireType);
}

int reinstateType(const QStringList& arguments)
{
    CommandLine line(u"types reinstate"_qs, u"Puts a retired type back into use; it then needs approval."_qs);
    return changeWithReason(line, arguments, &Library::reinstateType);
}

int approveType(const QStringList& arguments)
{
    CommandLine line(u"types approve"_qs, u"Signs a type off as it is now."_qs);
    addTypeOption(line);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return changeType(
        line,
        [&](Library& library, const TypeRecord& type) {
            return library.approveType(type.id, line.text(u"operator"_qs), line.text(u"reason"_qs));
        },
        Permission::ApproveTypes);
}

int restoreVersion(const QStringList& arguments)
{
    CommandLine line(u"types rollback"_qs,
                     u"Puts types and squeezes back to an earlier version, as a new version: what was done "
                     "since stays on record and can be restored in turn."_qs);
    line.option(u"version"_qs, u"N"_qs, u"The version to go back to; \"types versions\" lists them."_qs);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"version"_qs, u"reason"_qs}))
        return *exit;
    const int version = line.integer(u"version"_qs, 0, 2'000'000'000);
    if (const auto exit = line.finish())
        return *exit;
    return change(
        line, [&](Library& library) { return library.restoreVersion(version, note(line)).map(ignoreValue); });
}

} // namespace gripscope::cli
