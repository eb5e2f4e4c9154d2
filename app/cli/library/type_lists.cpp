// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of `types` that list.
#include "app/cli/library/type_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/output.h"
#include "core/base/json_value.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Most versions told at once unless asked for otherwise.
constexpr int versionsAPage = 50;

QJsonObject squeezeJson(const GraspRecord& grasp, int number)
{
    QJsonValue parameters;
    if (grasp.parameters)
        parameters = QJsonObject{
            {u"m"_qs, grasp.parameters->m}, {u"b"_qs, grasp.parameters->b}, {u"k"_qs, grasp.parameters->k}};
    return {{u"number"_qs, number},           {u"key"_qs, grasp.id},
            {u"accepted"_qs, grasp.accepted}, {u"part"_qs, grasp.part},
            {u"source"_qs, grasp.source},     {u"recorded"_qs, grasp.recorded.toString(Qt::ISODateWithMs)},
            {u"parameters"_qs, parameters}};
}

QString squeezeText(const GraspRecord& grasp, int number)
{
    QString text = u"%1  %2"_qs.arg(number, 3).arg(grasp.id);
    if (grasp.parameters)
        text += u"  m %1  b %2  k %3"_qs.arg(grasp.parameters->m, 0, 'g', 4)
                    .arg(grasp.parameters->b, 0, 'g', 4)
                    .arg(grasp.parameters->k, 0, 'g', 4);
    if (!grasp.part.isEmpty())
        text += u"  part %1"_qs.arg(grasp.part);
    return grasp.accepted ? text : text + u"  dropped"_qs;
}

void tell(const LibraryState& state, const CommandLine& line)
{
    QJsonArray types;
    for (const TypeState& type : state.types) {
        types.append(QJsonObject{{u"name"_qs, type.name},
                                 {u"status"_qs, toString(type.status)},
                                 {u"squeezes"_qs, type.squeezes},
                                 {u"code"_qs, type.code},
                                 {u"limits"_qs, jsonText(toText(type.limits))},
                                 {u"key"_qs, type.typeId}});
        if (!line.isSet(u"json"_qs))
            print(u"%1: %2, %3 squeezes"_qs.arg(type.name, toString(type.status),
                                                QString::number(type.squeezes)));
    }
    if (line.isSet(u"json"_qs))
        printJson({{u"version"_qs, state.version}, {u"types"_qs, types}});
    else
        print(u"Version %1."_qs.arg(state.version));
}

void tell(const TypeRecord& type, const std::vector<GraspRecord>& grasps, const CommandLine& line)
{
    QJsonArray squeezes;
    int number = 0;
    for (const GraspRecord& grasp : grasps) {
        squeezes.append(squeezeJson(grasp, ++number));
        if (!line.isSet(u"json"_qs))
            print(squeezeText(grasp, number));
    }
    if (line.isSet(u"json"_qs))
        printJson({{u"type"_qs, type.name}, {u"squeezes"_qs, squeezes}});
}

void tell(const std::vector<LibraryChange>& changes, const CommandLine& line)
{
    QJsonArray versions;
    for (const LibraryChange& change : changes) {
        const QString time = change.changed.toString(Qt::ISODateWithMs);
        versions.append(QJsonObject{{u"version"_qs, change.version},
                                    {u"kind"_qs, toString(change.kind)},
                                    {u"change"_qs, inWords(change)},
                                    {u"operator"_qs, change.operatorName},
                                    {u"reason"_qs, change.reason},
                                    {u"changed"_qs, time}});
        if (!line.isSet(u"json"_qs))
            print(QStringList{QString::number(change.version), time, inWords(change), change.operatorName,
                              change.reason}
                      .join(u"  "_qs));
    }
    if (line.isSet(u"json"_qs))
        printJson({{u"versions"_qs, versions}});
}

} // namespace

int listTypes(const QStringList& arguments)
{
    CommandLine line(u"types list"_qs, u"The types of a library, retired ones too."_qs);
    line.option(u"version"_qs, u"N"_qs, u"As they were at this version."_qs);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    const bool now = !line.isSet(u"version"_qs);
    const qint64 asked = now ? 0 : line.integer(u"version"_qs, 0, 2'000'000'000);
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](const Library& library) -> Expected<void> {
        ASSIGN_OR_RETURN(const auto version, now ? library.version() : Expected<qint64>(asked));
        return library.stateAt(version).map([&](const LibraryState& state) { tell(state, line); });
    });
}

int listSqueezes(const QStringList& arguments)
{
    CommandLine line(u"types squeezes"_qs, u"The squeezes of a type, in order of recording."_qs);
    addTypeOption(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs}))
        return *exit;
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](const Library& library) -> Expected<void> {
        ASSIGN_OR_RETURN(const auto type, requireNamed(library, line.text(u"type"_qs)));
        return library.grasps(type.id).map(
            [&](const std::vector<GraspRecord>& grasps) { tell(type, grasps, line); });
    });
}

int listVersions(const QStringList& arguments)
{
    CommandLine line(u"types versions"_qs, u"Every change of the types of a library, newest first."_qs);
    line.option(u"limit"_qs, u"N"_qs, u"As many at most."_qs, QString::number(versionsAPage));
    line.option(u"offset"_qs, u"N"_qs, u"So many newer ones are left out."_qs, u"0"_qs);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    const int limit = line.integer(u"limit"_qs, 1, 1'000'000);
    const int offset = line.integer(u"offset"_qs, 0, 2'000'000'000);
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](const Library& library) {
        return library.changes(limit, offset).map([&](const std::vector<LibraryChange>& changes) {
            tell(changes, line);
        });
    });
}

} // namespace gripscope::cli
