// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/synced_names.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <unistd.h>

namespace gripscope {

void syncNames(const QString& file)
{
    const QByteArray path = QFile::encodeName(QFileInfo(file).absolutePath());
    const int folder = ::open(path.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return;
    static_cast<void>(fsync(folder));
    ::close(folder);
}

} // namespace gripscope
