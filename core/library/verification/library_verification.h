// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <vector>

namespace gripscope {

struct LibraryWitness;

/// Something that is not as it was written.
struct LibraryDifference {
    QString table; ///< empty where it concerns the file
    QString row;   ///< its key; "CHAIN/NUMBER" of a link; empty where it concerns the table
    QString what;  ///< in words
};

/// What the second place (library_witness.h) says.
enum class WitnessState {
    Matched, ///< it knows the end of every chain that it knows at all
    Behind,  ///< chains go on where its knowledge ends, or end before; the latter is a difference
    Absent,  ///< it does not know this library
};
[[nodiscard]] QString toString(WitnessState state); ///< "matched", "behind", "absent"

/// A backup that took the library's place, as its audit trail tells.
struct RestoredBackup {
    QString utc, person, reason, backup;
};

/// A station's chain in the ledger.
struct LedgerChain {
    QString name;
    qint64 links = 0;
    bool hasSignatures = true; ///< on every link
    bool witnessed = false;
};

/// A chain in the ledger of a library that was merged into this one.
struct MergedChain {
    QString library, name;
    qint64 links = 0;
    bool hasSignatures = true;
};

/// "people 0190… was changed"
[[nodiscard]] QString inWords(const LibraryDifference& difference);

struct LibraryVerification {
    /// Of those after them only the number is kept.
    static constexpr std::size_t mostDifferences = 10'000;

    qint64 rows = 0;       ///< compared with what the ledger says of them
    qint64 foundRows = 0;  ///< of these, what was there before the ledger: as they were found then
    qint64 mergedRows = 0; ///< compared with what the ledgers of other stations say of them
    std::vector<LibraryDifference> differences;
    qint64 furtherDifferences = 0;
    WitnessState witness = WitnessState::Absent;
    std::vector<LedgerChain> chains;
    std::vector<MergedChain> merged;      ///< of other stations
    std::vector<RestoredBackup> restores; ///< in their order

    [[nodiscard]] bool whole() const { return differences.empty(); }
    void differs(const QString& table, const QString& row, const QString& what);
};
/// What was found, what it means, what to do next.
[[nodiscard]] QString inWords(const LibraryVerification& verification);

/// Reads all of a library that this program could open, of its own version of the schema, and compares it
/// with the ledger: nothing is written, a library in use is read as it stands at that moment. A table that
/// cannot be read is a difference. `recomputed`: what follows from something else is worked out again, too
/// (recompute()). StorageOpen, StorageCorrupt where the file cannot be read at all,
/// StorageNewer, and StorageOpen for a library from before the ledger, which has to be opened once.
[[nodiscard]] Expected<LibraryVerification> verifyLibrary(const QString& file, bool recomputed = false);
/// The same of a copy, by what the second place knew of its library.
[[nodiscard]] Expected<LibraryVerification> verifyLibraryCopy(const QString& file,
                                                              const LibraryWitness& witness);

} // namespace gripscope
