// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/spill/inspection_spill.h"
#include "core/library/spill/spill_file.h"

#include <QFileInfo>

namespace gripscope {

KeptInspections::KeptInspections(std::unique_ptr<SpillFile> file) : m_file(std::move(file)) {}
KeptInspections::~KeptInspections() = default;

Expected<std::unique_ptr<KeptInspections>> KeptInspections::open(const QString& file,
                                                                 const std::optional<ChainEnd>& birth)
{
    if (!QFileInfo::exists(file))
        return failure(ErrorCode::NotFound, {Words::say("file %1").arg(file)});
    ASSIGN_OR_RETURN(auto opened, SpillFile::open(file, SpillFile::Missing::Leave));
    if (!opened)
        return failure(ErrorCode::Usage, {Words::say("Another program has %1.").arg(file)});
    ASSIGN_OR_RETURN(const SpillFile::Contents contents, opened->read());
    std::unique_ptr<KeptInspections> kept(new KeptInspections(std::move(opened)));
    kept->m_damaged = contents.damaged;
    if (!isSpillOwner(contents.owner, spillOwner(birth)))
        return failure(ErrorCode::Usage,
                       {Words::say("The inspections in %1 were made for another library. Name "
                                   "that one.")
                            .arg(file)});
    kept->m_waiting = unpackedOf(contents, kept->m_damaged);
    if (kept->m_waiting.empty())
        return failure(ErrorCode::StorageCorrupt, {file, Words::say("no inspection in it can be read")});
    if (!kept->m_damaged)
        RETURN_IF_ERROR(kept->m_file->prepare(contents.owner, contents));
    return kept;
}

void KeptInspections::remove(qint64 place)
{
    if (!m_damaged)
        static_cast<void>(m_file->remove(place)); // one that stays is stored again by its key, which is once
}

} // namespace gripscope
