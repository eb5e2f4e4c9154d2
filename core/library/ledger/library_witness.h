// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The second place: a small file of this user on this computer that knows how far the ledger and the audit
/// trail of a library went, by the place of the library's file. It shows what the library's own file cannot:
/// that the end is missing (an older copy was put back), or that all of it was made anew. Not seen is a
/// change by somebody who can write both, and on another computer what that one has never changed.
struct LibraryWitness {
    std::optional<AuditHead> audit;
    std::map<QString, ChainEnd> chains; ///< by name
    [[nodiscard]] bool empty() const { return !audit && chains.empty(); }
};

[[nodiscard]] QString witnessFile(const QString& libraryFile);
/// Empty when this computer does not know the library.
[[nodiscard]] LibraryWitness readWitness(const QString& libraryFile);

/// After a commit. `fits` says whether what is known so far is in the library: where it is not, it stays, as
/// evidence, and where another process knows of more already, too. One process at a time. Failing to write
/// it fails nothing: the library is what counts.
void tellWitness(const QString& libraryFile, const LibraryWitness& news,
                 const std::function<bool(const LibraryWitness&)>& fits);

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
