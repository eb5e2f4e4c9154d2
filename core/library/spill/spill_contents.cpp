// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/library_witness.h"
#include "core/library/spill/spill_file.h"
#include "core/library/spill/spilled_inspection.h"

namespace gripscope {

QByteArray spillOwner(const std::optional<ChainEnd>& birth)
{
    return birth ? birth->chain.toUtf8() + ' ' + birth->hash.toHex() : QByteArray();
}

bool isSpillOwner(const QByteArray& named, const QByteArray& owner)
{
    return named.isEmpty() || named == owner;
}

std::vector<SpilledInspection> unpackedOf(const SpillFile::Contents& contents, bool& damaged)
{
    std::vector<SpilledInspection> found;
    qint64 memory = mostOfOneFile;
    for (const SpillFile::Block& block : contents.waiting) {
        Expected<NewInspection> inspection = unpackInspection(block.bytes, memory);
        damaged = damaged || !inspection;
        if (inspection)
            found.push_back({*std::move(inspection), block.place});
    }
    return found;
}

} // namespace gripscope
