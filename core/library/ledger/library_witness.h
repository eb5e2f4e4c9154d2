// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/people/audit_chain.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <map>
#include <optional>

namespace gripscope {

/// How far the chain of a station goes (ledger_link.h).
struct ChainEnd {
    QString chain;
    qint64 links = 0;
    QByteArray hash;
    friend bool operator==(const ChainEnd&, const ChainEnd&) = default;
};

/// A backup that is about to take the place of the library: known beforehand, so that whatever happens
/// between, the library is one of the two that the second place knows.
struct AnnouncedRestore {
    ChainEnd told;                      ///< the link that tells of it, in the backup only
    std::map<QString, ChainEnd> chains; ///< as the backup ends, with that link
    std::optional<AuditHead> audit;
    friend bool operator==(const AnnouncedRestore&, const AnnouncedRestore&) = default;
};

/// The second place: a small file of this user on this computer that knows how far the ledger and the audit
/// trail of a library went, by the place of the library's file. It shows what the library's own file cannot:
/// that the end is missing (an older copy was put back), or that all of it was made anew. Not seen is a
/// change by somebody who can write both, and on another computer what that one has never changed.
struct LibraryWitness {
    std::optional<AuditHead> audit;
    std::map<QString, ChainEnd> chains; ///< by name
    std::optional<AnnouncedRestore> announced;
    [[nodiscard]] bool empty() const { return !audit && chains.empty(); }
};

[[nodiscard]] QString witnessFile(const QString& libraryFile);
/// Empty when this computer does not know the library.
[[nodiscard]] LibraryWitness readWitness(const QString& libraryFile);

/// The hash of a link as the library has it; empty when there is none.
using LinkHash = std::function<QByteArray(const QString& chain, qint64 number)>;
/// Where the announced restore has taken place, the library ends as announced, and nothing is announced any
/// more; where it has not (yet), all stays.
void settleRestore(LibraryWitness& witness, const LinkHash& hashOf);

/// After a commit. `fits` says whether what is known so far is in the library, and may settle it before:
/// where it is not, it stays, as evidence, and where another process knows of more already, too. One process
/// at a time. Failing to write it fails nothing: the library is what counts.
void tellWitness(const QString& libraryFile, const LibraryWitness& news,
                 const std::function<bool(LibraryWitness&)>& fits);

/// The library is going to be kept at `keptAs`, and what is announced to take its place. What is known of it
/// goes along. FileUnwritable: the second place cannot be written; nothing is to be done then.
[[nodiscard]] Expected<void> announceRestore(const QString& libraryFile, const QString& keptAs,
                                             const AnnouncedRestore& restore);

/// A library that goes away with its folder: nothing of it is to stay in the second place. Declared before
/// what opens the library.
class PassingLibrary {
public:
    explicit PassingLibrary(QString libraryFile) : m_file(std::move(libraryFile)) {}
    ~PassingLibrary();
    PassingLibrary(const PassingLibrary&) = delete;
    PassingLibrary& operator=(const PassingLibrary&) = delete;
    [[nodiscard]] const QString& file() const { return m_file; }

private:
    QString m_file;
};

} // namespace gripscope
