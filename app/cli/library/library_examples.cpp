// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/library_examples.h"

#include "app/cli/library/authorization.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/session/enroll/simulated_examples.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

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

} // namespace

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

} // namespace gripscope::cli
