// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/file_identity.h"

#include <QFile>

#include <sys/stat.h>

namespace gripscope {

std::optional<FileIdentity> FileIdentity::of(const QString& name)
{
    struct stat found {};
    if (stat(QFile::encodeName(name).constData(), &found) != 0)
        return {};
    return FileIdentity{found.st_dev, found.st_ino};
}

} // namespace gripscope
