// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/library_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/library.h"
#include "core/library/records/inspection_record.h"
#include "core/library/spill/inspection_spill.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct TakenBack {
    std::vector<qint64> numbers; ///< of those that are stored now
    std::vector<Error> refused;  ///< these stay in the file
    bool damaged = false;        ///< more was in it that nobody can read
};

/// One that is stored already keeps its number: they are known by their keys.
Expected<qint64> store(Library& library, const NewInspection& inspection)
{
    return library.withKnownBatch(inspection)
        .and_then([&](const NewInspection& known) { return library.addInspection(known); })
        .map([](const InspectionRecord& stored) { return stored.number; });
}

Expected<TakenBack> takeAllBack(const QString& file, const QString& kept)
{
    ASSIGN_OR_RETURN(const auto library, Library::open(file));
    ASSIGN_OR_RETURN(const auto birth, library->birth());
    ASSIGN_OR_RETURN(const auto inspections, KeptInspections::open(kept, birth));
    TakenBack taken;
    taken.damaged = inspections->damaged();
    for (const SpilledInspection& one : inspections->waiting()) {
        const Expected<qint64> number = store(*library, one.inspection);
        if (!number) {
            taken.refused.push_back(number.error());
            continue;
        }
        inspections->remove(one.place);
        taken.numbers.push_back(*number);
    }
    return taken;
}

QJsonObject toJson(const TakenBack& taken)
{
    QJsonArray numbers, refused;
    for (const qint64 number : taken.numbers)
        numbers.append(number);
    for (const Error& error : taken.refused)
        refused.append(errorDocument(error));
    return {{u"inspections"_s, numbers}, {u"refused"_s, refused}, {u"damaged"_s, taken.damaged}};
}

void printText(const TakenBack& taken, const QString& kept)
{
    for (const qint64 number : taken.numbers)
        print(u"inspection %1"_s.arg(number));
    for (const Error& error : taken.refused)
        message(error.describe());
    if (taken.damaged)
        message(u"Some of %1 cannot be read; the file stays."_s.arg(kept));
}

} // namespace

int takeBack(const QStringList& arguments)
{
    CommandLine line(
        u"library take-back"_s,
        u"Stores the inspections of FILE, which a program kept aside because the library did not take them. "
        "What is stored already is not stored again. The file goes once nothing in it is left. "
        "Exit code 6: something in it is."_s,
        u"FILE"_s);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    if (line.files().size() != 1)
        line.reject(u"Name one FILE."_s);
    const QString kept = line.files().value(0);
    if (const auto exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_s);
    const auto taken =
        namedLibraryFile(line).and_then([&](const QString& file) { return takeAllBack(file, kept); });
    if (!taken)
        return fail(taken.error(), json);
    if (json)
        printJson(toJson(*taken));
    else
        printText(*taken, kept);
    const bool all = taken->refused.empty() && !taken->damaged;
    return static_cast<int>(all ? Exit::Done : Exit::Differs);
}

} // namespace gripscope::cli
