// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/ledger/library_witness.h"
#include "core/library/spill/spilled_inspection.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

class SpillFile;

/// A file that was kept aside (InspectionSpill), on its way back into its library.
class KeptInspections {
public:
    /// `birth` is Library::birth(). NotFound. FileUnreadable. FileUnwritable: it is no plain file, or cannot
    /// be opened. Usage: it is another library's, or another program has it; StorageCorrupt: none in it can
    /// be read.
    [[nodiscard]] static Expected<std::unique_ptr<KeptInspections>>
    open(const QString& file, const std::optional<ChainEnd>& birth);
    ~KeptInspections(); ///< the file goes once nothing in it is left to be stored
    KeptInspections(const KeptInspections&) = delete;
    KeptInspections& operator=(const KeptInspections&) = delete;

    [[nodiscard]] const std::vector<SpilledInspection>& waiting() const { return m_waiting; }
    /// Some of the file can be read by nobody: it stays as it is.
    [[nodiscard]] bool damaged() const { return m_damaged; }
    /// It is stored.
    void remove(qint64 place);

private:
    explicit KeptInspections(std::unique_ptr<SpillFile> file);
    std::unique_ptr<SpillFile> m_file;
    std::vector<SpilledInspection> m_waiting;
    bool m_damaged = false;
};

} // namespace gripscope
