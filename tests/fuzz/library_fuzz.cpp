// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/library_witness.h"
#include "core/library/migrations/migration.h"
#include "core/library/migrations/schema_check.h"
#include "core/library/sql/database.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/calibration_tables.h"
#include "core/library/tables/change_table.h"
#include "core/library/tables/document_table.h"
#include "core/library/tables/packed_recording.h"
#include "core/library/tables/person_table.h"
#include "core/library/tables/recording_table.h"
#include "core/library/tables/type_state_table.h"
#include "core/library/verification/library_checks.h"
#include "core/library/verification/library_verification.h"
#include "core/signal/recording/recording_limits.h"
#include "tests/fuzz/fuzzing.h"

#include <algorithm>

// Whole library files. A good one is made once; an input is a list of changes to its bytes (three bytes of
// place, one of what comes there), so that small inputs reach all of a large file.

using namespace gripscope;
using namespace gripscope::fuzz;
using namespace Qt::StringLiterals;

namespace {

Recording aRecording()
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    for (int i = 0; i < 50; ++i) {
        recording.time_s.push_back(0.001 * i);
        recording.force.push_back(i % 7);
        recording.position.push_back(1e-6 * i);
    }
    recording.provenance = {{u"device"_s, u"virtual"_s}};
    return recording;
}

void fill(Database& database)
{
    const auto run = [&](const QString& sql) { require(database.execute(sql, u"fill"_s).has_value()); };
    run(u"INSERT INTO types VALUES ('t', 's', '2026-01-01T00:00:00.000Z', 'A')"_s);
    run(u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, recipe_version) "
        "VALUES ('u', 's', '2026-01-01T00:00:00.000Z', 't', 0, 'A', 'approved', 1)"_s);
    run(u"INSERT INTO grasps (id, station, recorded_utc, type_id, operator_name, source, force_unit, "
        u"position_unit) "
        "VALUES ('g', 's', '2026-01-01T00:00:00.000Z', 't', 'Ada', 'virtual:', 'N', 'm')"_s);
    run(u"INSERT INTO documents VALUES ('d', 's', '2026-01-01T00:00:00.000Z', 'g', '{\"recommended\":\"oe\"}', NULL)"_s);
    run(u"INSERT INTO library_changes VALUES ('c', 's', '2026-01-01T00:00:00.000Z', 1, 'squeeze', 'A', '', 1, 'Ada', '')"_s);
    run(u"INSERT INTO people VALUES ('p', 's', '2026-01-01T00:00:00.000Z', 'q', 1, 'Ada', 'supervisor', 1, 'x', 1)"_s);
    run(u"INSERT INTO audit_entries VALUES (1, 's', '2026-01-01T00:00:00.000Z', 'Ada', 'supervisor', 'a', "
        u"'b', 'c', '{}', "
        "'', 'h')"_s);
    run(u"INSERT INTO calibrations (id, station, created_utc, gripper_serial, gripper_name, channel, unit, "
        u"reference_name, "
        u"reference_certificate, reference_uncertainty, reference_relative_uncertainty, degree, points, "
        u"taken_utc, "
        u"due_date, operator_name, note, serial) VALUES ('k', 's', '2026-01-01T00:00:00.000Z', 'GS-1', 'n', "
        u"'force', 'N', "
        u"'r', 'c', 0.1, 0, "
        "1, '0 0' || char(10) || '1 1', '2026-01-01T00:00:00.000Z', '2027-01-01', 'Ada', '', 1)"_s);
    require(recording_table::insert(database, RowStamp::now(), u"g"_s, aRecording()).has_value());
}

const QByteArray& goodLibrary()
{
    static const QByteArray bytes = [] {
        const FuzzFile file(u"good.db"_s);
        {
            auto database = Database::open(file.path());
            require(database && (*database)->execute(u"PRAGMA page_size=512"_s, u"fill"_s));
            require(migrate(**database).has_value());
            fill(**database);
            require((*database)->execute(u"PRAGMA journal_mode=DELETE"_s, u"fill"_s).has_value());
        }
        QFile in(file.path());
        require(in.open(QIODevice::ReadOnly));
        return in.readAll();
    }();
    return bytes;
}

QByteArray changed(QByteArray bytes, const std::uint8_t* data, std::size_t size)
{
    for (std::size_t i = 0; i + 4 <= size; i += 4) {
        const std::size_t place = data[i] | std::size_t(data[i + 1]) << 8 | std::size_t(data[i + 2]) << 16;
        bytes[static_cast<qsizetype>(place % static_cast<std::size_t>(bytes.size()))] =
            static_cast<char>(data[i + 3]);
    }
    if (size % 4 == 3) // and cut off
        bytes.truncate((data[size - 2] | data[size - 1] << 8) * 8);
    return bytes;
}

void readAll(Database& database)
{
    if (const auto version = schemaVersion(database); !version || !migrate(database))
        return;
    if (const auto recording = recording_table::read(database, u"g"_s))
        require(!outOfRange(*recording));
    static_cast<void>(document_table::read(database, u"g"_s));
    static_cast<void>(change_table::page(database, 100, 0));
    static_cast<void>(change_table::newestVersion(database));
    static_cast<void>(type_state_table::at(database, 5));
    static_cast<void>(person_table::all(database));
    static_cast<void>(calibration_table::inForce(database, u"GS-1"_s));
    static_cast<void>(reference_table::read(database, u"GS-1"_s));
    static_cast<void>(audit_table::forEach(database, [](const AuditEntry&) {}));
    if (const auto differences = schemaDifferences(database); differences && differences->empty()) {
        LibraryVerification found;
        checkLedger(database, {}, found);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const FuzzFile file(u"x.db"_s);
    for (const QString& beside : {u"-wal"_s, u"-shm"_s, u"-journal"_s})
        QFile::remove(file.path() + beside);
    file.write(changed(goodLibrary(), data, size));
    if (const auto database = Database::open(file.path()))
        readAll(**database);
    return 0;
}
