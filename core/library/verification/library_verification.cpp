// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/verification/library_verification.h"

#include "core/base/words.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/migrations/migration.h"
#include "core/library/migrations/schema_check.h"
#include "core/library/sql/statement.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/tally_table.h"
#include "core/library/verification/library_checks.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString verifying()
{
    return Words::tr("be verified");
}

/// What SQLite itself finds: pages, indexes, constraints, keys that point nowhere. A server looks after its
/// own (pg_amcheck), and holds every row to its keys.
void checkFile(Database& database, LibraryVerification& found)
{
    if (database.isOnServer())
        return;
    Statement integrity(database, verifying(), u"PRAGMA integrity_check(1000)"_s);
    const auto checked = integrity.forEach([&](Statement& row) {
        const QString said = row.takeText();
        if (said != "ok"_L1)
            found.differs({}, {}, said.simplified());
    });
    if (!checked)
        found.differs({}, {}, checked.error().describe());
    Statement keys(database, verifying(), u"PRAGMA foreign_key_check"_s);
    const auto followed = keys.forEach([&](Statement& row) {
        const QString table = row.takeText();
        const QString number = row.takeText();
        found.differs(table, Words::tr("row %1").arg(number),
                      Words::tr("points to a row of %1 that is not there").arg(row.takeText()));
    });
    if (!followed)
        found.differs({}, {}, followed.error().describe());
}

/// Whether the tables are this program's, so that their rows can be looked at.
Expected<bool> checkSchema(Database& database, LibraryVerification& found)
{
    ASSIGN_OR_RETURN(const auto differences, schemaDifferences(database));
    bool readable = true;
    for (const SchemaDifference& difference : differences) {
        found.differs(database.isOnServer() ? u"pg_catalog"_s : u"sqlite_master"_s, difference.name,
                      u"%1 %2"_s.arg(difference.type, inWords(difference.what)));
        readable = readable && difference.type == "index"_L1;
    }
    return readable;
}

void checkMigrations(Database& database, LibraryVerification& found)
{
    std::size_t next = 0;
    const std::vector<Migration>& steps = migrations();
    Statement query(database, verifying(),
                    u"SELECT version, checksum FROM schema_migrations ORDER BY version"_s);
    const auto done = query.forEach([&](Statement& row) {
        const qint64 version = row.takeInteger();
        const bool known =
            next < steps.size() && steps[next].version == version && steps[next].checksum() == row.takeText();
        if (!known)
            found.differs(u"schema_migrations"_s, QString::number(version),
                          Words::tr("is no step of this program"));
        ++next;
    });
    if (!done)
        found.differs(u"schema_migrations"_s, {}, done.error().describe());
}

void checkAudit(Database& database, const LibraryWitness& witness, LibraryVerification& found)
{
    AuditChainCheck check(witness.audit);
    const QString restored = QString::fromUtf16(audit_action::libraryRestored);
    const auto done = audit_table::forEach(database, [&](const AuditEntry& entry) {
        check.take(entry);
        if (entry.action == restored)
            found.restores.push_back({entry.utc, entry.person, entry.reason, entry.subject});
    });
    if (!done)
        return found.differs(u"audit_entries"_s, {}, done.error().describe());
    const AuditVerification trail = check.finish();
    if (!trail.whole())
        found.differs(u"audit_entries"_s, QString::number(trail.at), faultInWords(trail));
}

/// What is derived is made anew and compared: a tally that says less would hide inspections from the
/// counters.
void checkTallies(Database& database, LibraryVerification& found)
{
    const Expected<std::optional<qint64>> wrong = tally_table::wrongUpTo(database);
    if (!wrong)
        found.differs(u"inspection_tallies"_s, {}, wrong.error().describe());
    else if (*wrong)
        found.differs(u"inspection_tallies"_s, QString::number(**wrong),
                      Words::tr("is not what counting the inspections up to this number finds"));
}

Expected<void> refuseOtherVersions(Database& database, const QString& file)
{
    ASSIGN_OR_RETURN(const int version, schemaVersion(database));
    const int newest = migrations().back().version;
    if (version > newest)
        return failure(ErrorCode::StorageNewer, {file, QString::number(version), QString::number(newest)});
    if (version < newest)
        return failure(
            ErrorCode::StorageOpen,
            {file, Words::tr("it is of version %1 of the library, and what is verified is of version %2. "
                             "Open it with the program once, which brings it up to date; keep a copy "
                             "of it as it is")
                       .arg(version)
                       .arg(newest)});
    return {};
}

Expected<LibraryVerification> verifyOnce(const QString& file, LibraryWitness witness, bool recomputed,
                                         bool& changedMeanwhile)
{
    ASSIGN_OR_RETURN(const auto database, Database::openToRead(file));
    RETURN_IF_ERROR(
        database->execute(database->dialect().beginReading(), verifying())); // one state from here on
    RETURN_IF_ERROR(refuseOtherVersions(*database, file));
    LibraryVerification found;
    ASSIGN_OR_RETURN(const bool readable, checkSchema(*database, found));
    checkFile(*database, found);
    if (readable) {
        settleRestore(witness, ledger_table::hashesOf(*database));
        checkMigrations(*database, found);
        checkLedger(*database, witness, found);
        checkMerged(*database, found);
        checkAudit(*database, witness, found);
        checkTallies(*database, found);
    }
    if (readable && recomputed)
        recompute(*database, found);
    changedMeanwhile = database->wasWrittenMeanwhile();
    return found;
}

} // namespace

Expected<LibraryVerification> verifyLibrary(const QString& file, bool recomputed)
{
    constexpr int attempts = 3;
    for (int attempt = 1;; ++attempt) {
        bool changedMeanwhile = false;
        // Its knowledge before the library: what another process adds in between is only more.
        LibraryWitness witness = readWitness(file);
        ASSIGN_OR_RETURN(LibraryVerification found,
                         verifyOnce(file, std::move(witness), recomputed, changedMeanwhile));
        if (!changedMeanwhile || attempt == attempts)
            return found;
    }
}

Expected<LibraryVerification> verifyLibraryCopy(const QString& file, const LibraryWitness& witness)
{
    bool changedMeanwhile = false; // nobody else knows of it
    return verifyOnce(file, witness, false, changedMeanwhile);
}

} // namespace gripscope
