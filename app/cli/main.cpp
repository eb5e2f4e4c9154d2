// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "devices/transport/crash_stop.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <new>

using namespace gripscope::cli;
using namespace Qt::StringLiterals;

namespace {

QString overview()
{
    QString text =
        u"gripscope-cli finds mass, damping and stiffness of a squeezed object, and which type it is.\n\n"
        "Usage: gripscope-cli COMMAND [options]\n\nCommands:\n"_qs;
    for (const Command& command : commands())
        text += u"  %1%2\n"_qs.arg(command.name, -17).arg(command.summary);
    return text +
           u"\ngripscope-cli COMMAND --help lists the options of a command.\n"
           "Exit: 0 done; 2 usage; 3 some input bad; 4 device; 5 storage; 6 a measurement is invalid or a "
           "verdict is not a type."_qs;
}

int unknownCommand(const QString& typed)
{
    QStringList names;
    for (const Command& command : commands())
        names << command.name;
    const std::optional<QString> meant = nearest(typed, names);
    message(u"gripscope-cli: there is no command \"%1\". %2"_qs.arg(
        typed, meant ? u"Did you mean \"%1\"?"_qs.arg(*meant) : u"gripscope-cli --help lists them all."_qs));
    return static_cast<int>(Exit::Usage);
}

int run(const QStringList& arguments)
{
    if (arguments.isEmpty()) {
        message(overview());
        return static_cast<int>(Exit::Usage);
    }
    const QString first = arguments.first();
    if (first == u"--help"_qs || first == u"-h"_qs || first == u"help"_qs) {
        print(overview());
        return 0;
    }
    if (first == u"--version"_qs) {
        print(u"gripscope-cli %1"_qs.arg(QCoreApplication::applicationVersion()));
        return 0;
    }
    const auto command = std::find_if(commands().begin(), commands().end(),
                                      [&](const Command& candidate) { return candidate.name == first; });
    return command == commands().end() ? unknownCommand(first) : command->run(arguments.mid(1));
}

} // namespace

int main(int argc, char** argv)
{
    gripscope::CrashStop::installHandler();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(u"gripscope"_qs);
    QCoreApplication::setApplicationVersion(QStringLiteral(GRIPSCOPE_VERSION));
    QLocale::setDefault(QLocale::c());
    try {
        return run(QCoreApplication::arguments().mid(1));
    } catch (const std::bad_alloc&) {
        // Everything read has its limits; a machine may still have less. What was being done is undone by
        // now.
        message(
            u"gripscope-cli: There is not enough memory for this. Nothing of it was kept; take smaller or "
            "fewer files, or close other programs."_qs);
        return static_cast<int>(Exit::Storage);
    }
}
