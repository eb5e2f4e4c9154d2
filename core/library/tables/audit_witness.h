// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/audit_chain.h"

namespace gripscope {

class Database;

/// The second place: a small file of this user on this computer that knows how far the audit trail of a
/// library went, by the place of the library's file. It shows what the library's own file cannot: that
/// entries are missing at the end, or that the whole chain was made anew. Not seen is a change by somebody
/// who can write both, and on another computer what that one has never opened for a change.

[[nodiscard]] QString witnessFile(const QString& libraryFile);
/// Nothing when this computer does not know the library.
[[nodiscard]] std::optional<AuditHead> readWitness(const QString& libraryFile);

/// After a commit: the new end of the trail, unless what was known does not fit it: that stays, as evidence.
/// Failing to write it fails nothing: the library is what counts.
void tellWitness(Database& database);

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
