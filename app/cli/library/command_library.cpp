// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"
#include "app/cli/library/library_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/actions.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/verification/library_verification.h"
#include "core/session/enroll/simulated_examples.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject toJson(const LibraryVerification& found)
{
    QJsonArray differences;
    const auto add = [&](const LibraryDifference& difference) {
        differences.append(QJsonObject{
            {u"table"_s, difference.table}, {u"row"_s, difference.row}, {u"what"_s, difference.what}});
    };
    for (const LibraryDifference& difference : found.differences)
        add(difference);
    if (found.furtherDifferences > 0)
        add({{}, {}, u"and %1 more"_s.arg(found.furtherDifferences)});
    QJsonObject document{{u"whole"_s, found.whole()},
                         {u"rows"_s, found.rows},
                         {u"witness"_s, toString(found.witness)},
                         {u"differences"_s, differences}};
    QJsonArray restores;
    for (const RestoredBackup& one : found.restores)
        restores.append(QJsonObject{{u"utc"_s, one.utc},
                                    {u"person"_s, one.person},
                                    {u"backup"_s, one.backup},
                                    {u"reason"_s, one.reason}});
    if (!restores.isEmpty()) // a library that never was put back reads as ever
        document.insert(u"restores"_s, restores);
    QJsonArray merged;
    for (const MergedChain& one : found.merged)
        merged.append(
            QJsonObject{{u"library"_s, one.library}, {u"chain"_s, one.name}, {u"links"_s, one.links}});
    if (!merged.isEmpty()) {
        document.insert(u"merged"_s, merged);
        document.insert(u"merged_rows"_s, found.mergedRows);
    }
    return document;
}

void printText(const LibraryVerification& found)
{
    for (const LibraryDifference& difference : found.differences)
        print(inWords(difference));
    if (found.furtherDifferences > 0)
        print(u"and %1 more"_s.arg(found.furtherDifferences));
    for (const LedgerChain& chain : found.chains)
        print(u"%1: %2 links%3%4"_s.arg(chain.name)
                  .arg(chain.links)
                  .arg(chain.hasSignatures ? u", signed"_s : u", not all signed"_s,
                       chain.witnessed ? u", witnessed here"_s : QString()));
    for (const MergedChain& chain : found.merged)
        print(u"%1: %2 links%3, of another library"_s.arg(chain.name)
                  .arg(chain.links)
                  .arg(chain.hasSignatures ? u", signed"_s : u", not all signed"_s));
    print(inWords(found));
}

Exit verificationExit(const LibraryVerification& found)
{
    if (!found.whole())
        return Exit::Differs;
    return found.witness == WitnessState::Absent ? Exit::NotWitnessed : Exit::Done;
}

int verifyAll(const QStringList& arguments)
{
    CommandLine line(
        u"library verify"_s,
        u"Reads all of a library and says whether every row is as it was written. Writes nothing. "
        "Exit code 0: whole; 7: whole, but this computer does not know it, so that its end may be "
        "missing; 6: something differs; 5: it cannot be read."_s);
    line.flag(u"recompute"_s, u"Unpack every recording and identify it again, too; takes a while."_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto found = libraryFile(line).and_then(
        [&](const QString& file) { return verifyLibrary(file, line.isSet(u"recompute"_s)); });
    if (!found)
        return fail(found.error(), json);
    if (json)
        printJson(toJson(*found));
    else
        printText(*found);
    return static_cast<int>(verificationExit(*found));
}

Expected<void> load(Library& library, bool simulated)
{
    ASSIGN_OR_RETURN(const Acting acting, authorization(library, {}, Permission::ApproveTypes));
    library.actAs(acting);
    if (!simulated)
        return library.loadExampleTypes();
    message(u"Squeezing simulated plastics, foams and fruit..."_s);
    return library.loadExampleTypes(simulatedExamples());
}

Expected<void> tell(const Library& library, bool json)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    QJsonArray names;
    for (const TypeRecord& type : types)
        names.append(type.name);
    if (json)
        printJson({{u"types"_s, names}});
    else
        for (const TypeRecord& type : types)
            print(u"%1: %2 squeezes"_s.arg(type.name).arg(type.squeezes));
    return {};
}

/// `examples`: adds types to look at.
int addExamples(const QStringList& arguments)
{
    CommandLine line(
        u"library examples"_s,
        u"Adds the four cans of the paper as types, or with --simulated made-up plastics, foams and "
        "fruit, which a virtual gripper holds as object=tomato and the like. Types that are there "
        "already stay as they are."_s);
    line.flag(u"simulated"_s, u"Plastics, foams and fruit; takes some seconds."_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto library = libraryFile(line).and_then([](const QString& file) { return Library::open(file); });
    if (!library)
        return fail(library.error(), json);
    const Expected<void> done =
        load(**library, line.isSet(u"simulated"_s)).and_then([&] { return tell(**library, json); });
    return done ? 0 : fail(done.error(), json);
}

} // namespace

int runLibrary(const QStringList& arguments)
{
    return runAction(
        u"library"_s, u"Looks after a library as a whole."_s,
        {{u"verify"_s, u"says whether every row is as it was written"_s, verifyAll},
         {u"backup"_s, u"copies a library that may be in use, and verifies the copy"_s, backUp},
         {u"restore"_s, u"puts a backup in the place of a library, which is kept"_s, restore},
         {u"merge"_s, u"brings in what the library of another station has"_s, mergeStations},
         {u"sync"_s, u"brings it in step with the library of its plant on a server"_s, syncWithServer},
         {u"status"_s, u"says which stations are in it, and what they decided apart"_s, stationStatus},
         {u"take-back"_s, u"stores inspections that were kept aside"_s, takeBack},
         {u"examples"_s, u"adds types to look at"_s, addExamples}},
        arguments);
}

} // namespace gripscope::cli
