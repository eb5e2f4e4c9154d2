// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/outside_change.h"

#include "app/cli/library/authorization.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/audit/audit_trail.h"

#include <QFileInfo>

#include <cstdio>
#include <memory>
#include <unistd.h>
#include <vector>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// The one that is meant, and the user's own besides: naming another file is to be no way round the people in
/// it. Those that are there.
Expected<QStringList> concernedLibraries(const CommandLine& line)
{
    ASSIGN_OR_RETURN(const QString named, namedLibraryFile(line));
    QStringList files{named};
    const QString own = Library::defaultFile();
    if (QFileInfo(own).canonicalFilePath() != QFileInfo(named).canonicalFilePath())
        files.append(own);
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

} // namespace

void addOutsideChangeOptions(CommandLine& line)
{
    addLibraryOption(line);
    line.option(u"reason"_s, u"TEXT"_s, u"Why; kept in the library's audit trail."_s);
    line.option(u"operator"_s, u"NAME"_s, u"Who; kept in the library's audit trail."_s);
}

Expected<void> tellOutsideChange(const CommandLine& line, const QString& action, const QString& subject,
                                 const QJsonObject& details)
{
    ASSIGN_OR_RETURN(const QStringList files, concernedLibraries(line));
    std::vector<std::unique_ptr<Library>> libraries;
    for (const QString& file : files) {
        ASSIGN_OR_RETURN(std::unique_ptr<Library> library, Library::open(file));
        ASSIGN_OR_RETURN(const Acting acting,
                         authorization(*library, line.text(u"operator"_s), Permission::ChangeSettings));
        library->actAs(acting);
        libraries.push_back(std::move(library));
    }
    for (const std::unique_ptr<Library>& library : libraries)
        RETURN_IF_ERROR(library->auditTrail().record(Permission::ChangeSettings, action, subject, details,
                                                     line.text(u"reason"_s)));
    return {};
}

bool confirmed(const QString& question)
{
    if (isatty(STDIN_FILENO) == 0)
        return true;
    message(u"%1 [y/N]"_s.arg(question));
    char answer[8] = {};
    return std::fgets(answer, sizeof answer, stdin) != nullptr && (answer[0] == 'y' || answer[0] == 'Y');
}

} // namespace gripscope::cli
