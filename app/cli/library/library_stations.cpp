// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"
#include "app/cli/library/existing_library.h"
#include "app/cli/library/library_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/exchange/library_exchange.h"
#include "core/library/merge/library_merge.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

QJsonObject toJson(const PlantConflict::Side& side)
{
    return {{u"value"_s, side.value},
            {u"station"_s, side.stamp.station},
            {u"person"_s, side.stamp.person},
            {u"utc"_s, side.stamp.utc}};
}

QJsonArray toJson(const std::vector<PlantConflict>& conflicts)
{
    QJsonArray array;
    for (const PlantConflict& conflict : conflicts) {
        QJsonArray onRecord;
        for (const PlantConflict::Side& side : conflict.onRecord)
            onRecord.append(toJson(side));
        array.append(QJsonObject{{u"kind"_s, toString(conflict.kind)},
                                 {u"type"_s, conflict.type},
                                 {u"in_force"_s, toJson(conflict.inForce)},
                                 {u"on_record"_s, onRecord},
                                 {u"message"_s, inWords(conflict)}});
    }
    return array;
}

QJsonObject toJson(const MergeReport& report)
{
    QJsonObject taken;
    for (const auto& [table, rows] : report.taken)
        taken.insert(table, rows);
    QJsonObject document{{u"file"_s, report.file},
                         {u"rows"_s, report.rows()},
                         {u"taken"_s, taken},
                         {u"already_there"_s, report.alreadyThere},
                         {u"for_the_record"_s, report.forTheRecord},
                         {u"conflicts"_s, toJson(report.conflicts)}};
    document.insert(u"version"_s, report.version > 0 ? QJsonValue(report.version) : QJsonValue::Null);
    return document;
}

void printText(const MergeReport& report)
{
    print(inWords(report));
    for (const auto& [table, rows] : report.taken)
        print(u"  %1: %2"_s.arg(QString(table).replace(u'_', u' ')).arg(rows));
    for (const PlantConflict& conflict : report.conflicts)
        print(inWords(conflict));
}

Expected<MergeReport> mergeFile(const CommandLine& line, const QString& file)
{
    ASSIGN_OR_RETURN(const QString name, namedLibraryFile(line));
    ASSIGN_OR_RETURN(const auto library, Library::open(name));
    ASSIGN_OR_RETURN(const Acting acting,
                     authorization(*library, line.text(u"operator"_s), Permission::ChangeTypes));
    library->actAs(acting);
    return library->mergeLibrary(file, note(line));
}

struct Standing {
    std::vector<StationStanding> stations;
    std::vector<PlantConflict> conflicts;
};

Expected<Standing> standing(const CommandLine& line)
{
    Standing found;
    ASSIGN_OR_RETURN(const QString file, libraryFile(line));
    ASSIGN_OR_RETURN(const auto library, openExistingLibrary(file));
    if (line.isSet(u"seen"_s)) {
        ASSIGN_OR_RETURN(const Acting acting,
                         authorization(*library, line.text(u"operator"_s), Permission::ChangeTypes));
        library->actAs(acting);
        ASSIGN_OR_RETURN(const auto conflicts, library->conflicts());
        RETURN_IF_ERROR(library->noteConflictsSeen(conflicts, note(line)));
    }
    ASSIGN_OR_RETURN(found.stations, library->stations());
    ASSIGN_OR_RETURN(found.conflicts, library->conflicts());
    return found;
}

/// All steps together.
struct Exchanged {
    QString server;
    qint64 links = 0, rows = 0, taken = 0, version = 0;
    std::vector<PlantConflict> conflicts;
};

Expected<Exchanged> exchange(const CommandLine& line)
{
    Exchanged all;
    ASSIGN_OR_RETURN(const QString file, libraryFile(line));
    ASSIGN_OR_RETURN(all.server, Library::placeFrom(line.text(u"server"_s)));
    if (Library::isOnServer(file) || !Library::isOnServer(all.server))
        return failure(ErrorCode::Usage,
                       {u"Bring a station's library, a file, in step with one on a server: library sync "
                        "--library FILE --server postgresql://USER@HOST/NAME."_s});
    ASSIGN_OR_RETURN(const auto station, openExistingLibrary(file));
    ASSIGN_OR_RETURN(const auto server, Library::open(all.server));
    for (ExchangeStep step; !step.inStep;) {
        ASSIGN_OR_RETURN(step, station->exchangeWith(*server, step.marks, linksOfStep));
        all.links += step.delivered.links;
        all.rows += step.delivered.rows;
        all.taken += step.fetched.rows;
        all.version = step.fetched.version > 0 ? step.fetched.version : all.version;
        if (step.conflicts)
            all.conflicts = *step.conflicts;
    }
    return all;
}

QString inWords(const Exchanged& all)
{
    if (all.links == 0 && all.taken == 0)
        return u"In step with %1 already."_s.arg(all.server);
    return u"In step with %1: %2 transactions with %3 rows were brought there, %4 rows of types and "
           "calibrations were taken from there."_s.arg(all.server)
               .arg(all.links)
               .arg(all.rows)
               .arg(all.taken);
}

} // namespace

int syncWithServer(const QStringList& arguments)
{
    CommandLine line(
        u"library sync"_s,
        u"Brings the library of a station, a file, in step with the library of its plant on a "
        "server: all that the station has written goes there, and what all stations have in common "
        "(types, their enrolled squeezes, calibrations, limits, people) comes from there. Again "
        "takes nothing twice."_s);
    line.option(u"server"_s, u"ADDRESS"_s, u"The plant's library: postgresql://USER@HOST:PORT/NAME."_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (line.text(u"server"_s).isEmpty())
        line.reject(u"Name the plant's library: --server postgresql://USER@HOST/NAME."_s);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto all = exchange(line);
    if (!all)
        return fail(all.error(), json);
    if (json) {
        printJson({{u"server"_s, all->server},
                   {u"transactions"_s, all->links},
                   {u"rows"_s, all->rows},
                   {u"taken"_s, all->taken},
                   {u"version"_s, all->version > 0 ? QJsonValue(all->version) : QJsonValue::Null},
                   {u"conflicts"_s, toJson(all->conflicts)}});
        return static_cast<int>(Exit::Done);
    }
    print(inWords(*all));
    for (const PlantConflict& conflict : all->conflicts)
        print(gripscope::inWords(conflict));
    return static_cast<int>(Exit::Done);
}

int mergeStations(const QStringList& arguments)
{
    CommandLine line(u"library merge"_s,
                     u"Brings all that the library FILE of another station has and this one has not into "
                     u"this one. FILE is "
                     "verified first and only read. Merging it again takes nothing twice. What both stations "
                     "decided while "
                     "apart is told: the later is in force, the other on record."_s,
                     u"FILE"_s);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (line.files().size() != 1)
        line.reject(u"Name one FILE, the library of the other station."_s);
    const QString file = line.files().value(0);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto report = mergeFile(line, file);
    if (!report)
        return fail(report.error(), json);
    if (json)
        printJson(toJson(*report));
    else
        printText(*report);
    return static_cast<int>(Exit::Done);
}

int stationStatus(const QStringList& arguments)
{
    CommandLine line(u"library status"_s,
                     u"Says which stations are in a library, and what they decided while apart that no "
                     "supervisor has seen."_s);
    line.flag(u"seen"_s, u"Say that you have seen it: it is no longer told."_s);
    addNoteOptions(line);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto found = standing(line);
    if (!found)
        return fail(found.error(), json);
    QJsonArray stations;
    for (const StationStanding& one : found->stations) {
        stations.append(QJsonObject{{u"station"_s, one.station},
                                    {u"inspections"_s, one.inspections},
                                    {u"newest"_s, one.newestUtc},
                                    {u"here"_s, one.isHere}});
        if (!json)
            print(u"%1: %2 inspections%3%4"_s.arg(one.station)
                      .arg(one.inspections)
                      .arg(one.newestUtc.isEmpty() ? QString() : u", the newest of "_s + one.newestUtc,
                           one.isHere ? u" (this station)"_s : QString()));
    }
    if (json)
        printJson({{u"stations"_s, stations}, {u"conflicts"_s, toJson(found->conflicts)}});
    else
        for (const PlantConflict& conflict : found->conflicts)
            print(inWords(conflict));
    return static_cast<int>(Exit::Done);
}

} // namespace gripscope::cli
