// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/library/recent_libraries.h"

#include "core/library/library.h"
#include "ui/settings/values/settings.h"

#include <QFileInfo>

namespace gripscope {

namespace {
constexpr int mostKept = 8;
} // namespace

QStringList recentLibraries(const Settings& settings)
{
    return settings.recentLibraries().mid(0, mostKept);
}

void noteLibrary(Settings& settings, const QString& file)
{
    QStringList files = recentLibraries(settings);
    const QString name = Library::isOnServer(file) ? file : QFileInfo(file).absoluteFilePath();
    files.removeAll(name);
    files.prepend(name);
    settings.setRecentLibraries(files.mid(0, mostKept));
}

} // namespace gripscope
