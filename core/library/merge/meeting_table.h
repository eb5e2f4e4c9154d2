// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/ledger/library_witness.h"

#include <QJsonObject>
#include <QSet>

#include <map>
#include <optional>

namespace gripscope {

class Database;

/// Another library was merged into this one.
struct Meeting {
    QString library, other; ///< libraryId() of this and of the other
    qint64 version = 0;     ///< of this one; what is changed after it was changed knowing the others
    /// By library the newest version of which changes are known. Kept of it is what no earlier meeting of
    /// this library knew: with many stations, all of it each time would be most of a library.
    std::map<QString, qint64> seen;
    QJsonObject heads; ///< by library and chain how far its ledger goes: "links hash"; empty: of a server
    qint64 taken = 0;
    QString operatorName;
    void addHead(const QString& ofLibrary, const ChainEnd& end);
};
/// Meeting::seen as it is stored.
[[nodiscard]] std::map<QString, qint64> seenFromText(const QString& json);
/// With another library, without what is seen and heads.
[[nodiscard]] Expected<Meeting> meetingOf(const QString& other, Database& target, qint64 taken,
                                          const QString& operatorName);
/// As it is now, within the transaction that merges.
[[nodiscard]] Expected<Meeting> meetingWith(Database& source, Database& target, qint64 taken,
                                            const QString& operatorName);

namespace meeting_table {

[[nodiscard]] Expected<void> insert(Database& database, const Meeting& meeting);
[[nodiscard]] Expected<bool> isAnyThere(Database& database);
/// libraryId() of the server whose types are taken here; nothing where none are. Such a meeting holds no
/// heads, as no ledger came along.
[[nodiscard]] Expected<std::optional<QString>> serverInStep(Database& database);
[[nodiscard]] Expected<void> insertSeen(Database& database, const QString& conflict,
                                        const QString& operatorName);
[[nodiscard]] Expected<QSet<QString>> seenConflicts(Database& database); ///< PlantConflict::id()

} // namespace meeting_table
} // namespace gripscope
