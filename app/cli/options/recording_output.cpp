// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/options/recording_output.h"

#include <QFile>
#include <QFileInfo>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

void addForceOption(CommandLine& line)
{
    line.flag(u"force"_s, u"Replaces a file that is there also where it is no recording of Gripscope."_s);
}

Expected<void> mayReplace(const QString& file, bool force)
{
    const QFileInfo there(file);
    if (force || !there.isFile() || there.size() == 0)
        return {};
    QFile before(file);
    if (before.open(QIODevice::ReadOnly) && before.peek(64).startsWith("# gripscope-recording:"))
        return {};
    return failure(ErrorCode::FileUnwritable,
                   {file, u"it is there already and is no recording of Gripscope; name another file, or give "
                          "--force to replace it"_s});
}

} // namespace gripscope::cli
