// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/sql/database.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace gripscope {

/// One numbered step of the schema. Once released it is never edited: what comes later is a further step.
struct Migration {
    int version = 0; ///< 1, 2, 3... without a hole
    QString name;
    QStringList statements; ///< for every database, spelled by SqlDialect::ofMigration()
    /// In the same transaction, after the statements and the entry in schema_migrations: from the ledger on,
    /// what puts the new rows into it.
    std::function<Expected<void>(Database&)> afterwards = {};
    [[nodiscard]] QString checksum() const; ///< SHA-256 over the statements
};

/// All steps this program knows.
[[nodiscard]] const std::vector<Migration>& migrations();

/// The statements of a script: comment lines dropped, cut at each semicolon that ends a line.
[[nodiscard]] QStringList statementsOf(const QString& script);

/// The statement that makes schema_migrations, before all else.
[[nodiscard]] QString migrationTable();

/// 0 for an empty file. StorageOpen when the tables are not those of a library.
[[nodiscard]] Expected<int> schemaVersion(Database& database);

/// Brings the database to the last of `steps`, each step in a transaction of its own together with its entry
/// in schema_migrations. StorageNewer (nothing changed) when it is further already, StorageOpen when a step
/// was applied with other statements than this program's.
[[nodiscard]] Expected<void> migrate(Database& database, const std::vector<Migration>& steps = migrations());

/// The schema as numbered scripts, one file each, never edited after a release (a checksum in every library
/// sees it).
extern const char* const migrationScript1;
extern const char* const migrationScript2;
extern const char* const migrationScript3;
extern const char* const migrationScript4;
extern const char* const migrationScript5;
extern const char* const migrationScript6;
extern const char* const migrationScript7;
extern const char* const migrationScript8;
extern const char* const migrationScript9;
extern const char* const migrationScript10;
extern const char* const migrationScript11;
extern const char* const migrationScript12;
extern const char* const migrationScript13;
extern const char* const migrationScript14;

/// Of step 14: see its script. Each is a version of the library.
[[nodiscard]] Expected<void> approveFoundTypes(Database& database);
extern const char* const migrationScript15;
extern const char* const migrationScript16;
extern const char* const migrationScript17;
extern const char* const migrationScript18;
extern const char* const migrationScript19;
extern const char* const migrationScript20;
extern const char* const migrationScript21;
extern const char* const migrationScript22;
extern const char* const migrationScript23;
extern const char* const partLimitsScript;
extern const char* const studiesScript;
extern const char* const processChartsScript;
extern const char* const adjustmentsScript;
extern const char* const stationsScript;
extern const char* const plantChangesScript;

} // namespace gripscope
