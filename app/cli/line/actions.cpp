// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/actions.h"

#include "app/cli/line/command_line.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

int runAction(const QString& command, const QString& purpose, const std::vector<Command>& actions,
              const QStringList& arguments)
{
    QStringList names, lines;
    for (const Command& action : actions) {
        names << action.name;
        lines << u"%1: %2"_qs.arg(action.name, action.summary);
        if (!arguments.isEmpty() && arguments.first() == action.name)
            return action.run(arguments.mid(1));
    }
    CommandLine line(command,
                     u"%1 %2. \"%3 ACTION --help\" tells an action's options."_qs.arg(
                         purpose, lines.join(u"; "_qs), command),
                     u"ACTION"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    line.reject(u"the name of an action was expected first: %1."_qs.arg(names.join(u", "_qs)));
    return line.finish().value_or(2);
}

} // namespace gripscope::cli
