// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pending.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/spill/spilled_inspection.h"

#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

class SpillFile;

/// The inspections that a library has not stored yet, in a file that outlives this program. Each program that
/// inspects into a library has a file of its own; what one left behind that ended meanwhile goes to the next
/// one that opens. The file is bound to the library by its place and by the first link of its ledger.
class InspectionSpill {
public:
    static constexpr int mostPrograms = 16; ///< that inspect into one library at once, on this computer
    /// Beside the witness of the library, for the program with this number (from 1 on).
    [[nodiscard]] static QString file(const QString& libraryFile, int program);

    InspectionSpill();
    ~InspectionSpill(); ///< what was asked for is done
    InspectionSpill(const InspectionSpill&) = delete;
    InspectionSpill& operator=(const InspectionSpill&) = delete;

    struct Opened {
        std::vector<SpilledInspection> waiting; ///< in the order in which they were put in
        std::optional<Error> lost;              ///< what is not among them, and where it is kept
    };
    /// Sets all room aside, and says what earlier programs left. `birth` is Library::birth(). May be asked
    /// again after a failure, and takes a while. FileUnwritable: there is no room on the disk, or 16 programs
    /// have theirs.
    [[nodiscard]] Expected<Opened> open(const QString& libraryFile, const std::optional<ChainEnd>& birth);

    /// On a thread of its own, which only writes; the answer is its place. Usage: no library would take it.
    /// FileUnwritable: it is not kept.
    [[nodiscard]] Pending<Expected<qint64>> add(const NewInspection& inspection);
    /// It is stored. From any thread.
    void remove(qint64 place);
    /// One from before that the library does not take, in a file of its own (KeptInspections), whose name is
    /// returned. Waits.
    [[nodiscard]] static Expected<QString> keepAside(const QString& libraryFile,
                                                     const std::optional<ChainEnd>& birth,
                                                     const NewInspection& inspection);
    [[nodiscard]] bool isOpen() const;
    /// There is room for one more as large as any squeeze is. Never waits.
    [[nodiscard]] bool hasRoom() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

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
