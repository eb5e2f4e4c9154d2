// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/library/library.h"
#include "devices/self_check/self_check.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// What is broken, in the terms of all commands.
Exit exitForBroken(const QString& id)
{
    if (id == "permissions"_L1)
        return Exit::Device;
    if (id == "integrity"_L1 || id == "chain"_L1)
        return Exit::Differs;
    return Exit::Storage; // of what is stored, where, with which key and at which time
}

void printCheckLine(const CheckLine& line)
{
    print(u"%1%2%3"_s.arg(toString(line.outcome), -8).arg(line.name, -21).arg(line.found));
    if (!line.advice.isEmpty())
        print(u"%1%2"_s.arg(QString(), 29).arg(line.advice));
}

} // namespace

int runSelfCheck(const QStringList& arguments)
{
    CommandLine line(u"self-check"_s,
                     u"Looks at all that this computer needs to measure: library, key, disk, calibrations, "
                     "clock, permissions, versions. Changes nothing. Exit code 0: nothing is broken; 4: a "
                     "gripper may not be opened; 5: library, disk, key or clock; 6: the library is not as it "
                     "was written."_s);
    line.option(u"library"_s, u"DB"_s,
                u"File with the types and squeezes (without it: the user's own library)."_s);
    line.flag(u"quick"_s, u"Does not read all of the library, which takes a while when it is large."_s);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    SelfCheckSubject subject;
    subject.libraryFile = line.isSet(u"library"_s) ? line.text(u"library"_s) : Library::defaultFile();
    subject.verified = !line.isSet(u"quick"_s);
    ExitCode exit;
    QJsonArray document;
    bool broken = false;
    for (const CheckLine& one : selfCheck(subject)) {
        if (one.outcome == CheckOutcome::Broken) {
            exit.add(exitForBroken(one.id));
            broken = true;
        }
        if (line.isSet(u"json"_s))
            document.append(QJsonObject{{u"id"_s, one.id},
                                        {u"name"_s, one.name},
                                        {u"outcome"_s, toString(one.outcome)},
                                        {u"found"_s, one.found},
                                        {u"advice"_s, one.advice}});
        else
            printCheckLine(one);
    }
    if (line.isSet(u"json"_s))
        printJson({{u"broken"_s, broken}, {u"lines"_s, document}});
    return exit.value();
}

} // namespace gripscope::cli
