// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/file_identity.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace gripscope {

namespace {

struct FilesInUse {
    std::mutex mutex;
    std::vector<FileIdentity> files; ///< one of many times as often
};

FilesInUse& filesInUse()
{
    static FilesInUse files;
    return files;
}

} // namespace

FileInUse::FileInUse(const QString& name)
{
    noteNew(name);
}

void FileInUse::noteNew(const QString& name)
{
    const std::lock_guard lock(filesInUse().mutex);
    if (m_identity)
        return;
    m_identity = FileIdentity::of(name);
    if (m_identity)
        filesInUse().files.push_back(*m_identity);
}

FileInUse::~FileInUse()
{
    if (!m_identity)
        return;
    const std::lock_guard lock(filesInUse().mutex);
    std::vector<FileIdentity>& files = filesInUse().files;
    if (const auto mine = std::find(files.begin(), files.end(), *m_identity); mine != files.end())
        files.erase(mine);
}

void FileInUse::unlessInUse(const QString& name, const std::function<void()>& look)
{
    const std::lock_guard lock(filesInUse().mutex);
    const std::vector<FileIdentity>& files = filesInUse().files;
    const std::optional<FileIdentity> identity = FileIdentity::of(name);
    if (!identity || std::find(files.begin(), files.end(), *identity) == files.end())
        look();
}

} // namespace gripscope
