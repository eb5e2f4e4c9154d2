// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/library/raw_database.h"

namespace gripscope::test {

/// Inspections 1 to `count` by SQL, since storing them one by one with their recordings would take minutes: a
/// minute apart from 1 January 2024, every tenth unknown, every other by "Bob", the third of three grippers
/// used for every third, the source a file name with its number, m = 0.04 + number / 1e7, k = number.
/// Expected is A; every seventh is called B.
inline void addManyInspections(const QString& file, int count)
{
    using namespace Qt::StringLiterals;
    RawDatabase raw(file);
    // Each by its own functions; "%1" is a letter before the number of nine digits.
    const QString key = onServer() ? u"'%1' || LPAD(i::text, 9, '0')"_s : u"printf('%1%09d', i)"_s;
    raw.run(u"BEGIN"_s);
    const QString numbers =
        u"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) "_s.arg(count);
    const QString time = onServer()
                             ? u"TO_CHAR(TO_TIMESTAMP(1704067200 + 60 * i) AT TIME ZONE 'UTC', "
                               "'YYYY-MM-DD\"T\"HH24:MI:SS.MS') || 'Z'"_s
                             : u"strftime('%Y-%m-%dT%H:%M:%f', 1704067200 + 60 * i, 'unixepoch') || 'Z'"_s;
    const QString number = onServer() ? u"i::float8"_s : u"i"_s;
    raw.run(
        u"INSERT INTO grasps (id, station, recorded_utc, operator_name, source, force_unit, position_unit, device_name, device_serial) "_s +
        numbers + u"SELECT "_s + key.arg(u"g"_s) + u", '', "_s + time +
        u", CASE WHEN i % 2 = 0 THEN 'Ada' ELSE 'Bob' END, 'file ' || i, 'N', 'm', 'Gripper', '000' || (i % 3) FROM n"_s);
    raw.run(
        u"INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, m, b, k, var_m, cov_mb, cov_mk, var_b, cov_bk, var_k, simulation_fit_percent, iterations) "_s +
        numbers +
        u"SELECT %1, '', '', %2, 0, 'oe', 'converged', '', '0.1', 0.04 + %3 / 1e7, 43, i, 1e-8, 0, 0, 0.01, 0, 100, 95, 1 FROM n"_s
            .arg(key.arg(u"e"_s), key.arg(u"g"_s), number));
    raw.run(u"INSERT INTO inspections (id, station, inspected_utc, number, grasp_id, expected_type, verdict, "
            "type_name, nearest, posterior, distance, gate, samples_used, false_reject, wrong_type, seconds, "
            "operator_name, posteriors, reasons, batch_id, validity) "_s +
            numbers + u"SELECT "_s + key.arg(u"i"_s) + u", '', "_s + time + u", i, "_s + key.arg(u"g"_s) +
            u", 'A', CASE WHEN i % 10 = 0 THEN 'unknown' ELSE 'type' END, "
            "CASE WHEN i % 10 = 0 THEN '' WHEN i % 7 = 0 THEN 'B' ELSE 'A' END, 'A', 1 - i / 1e6, 1, 14, "
            "500, 0.01, "
            "0.001, 1, CASE WHEN i % 2 = 0 THEN 'Ada' ELSE 'Bob' END, '{}', '[]', NULL, 'valid' FROM n"_s);
    raw.run(u"COMMIT"_s);
}

} // namespace gripscope::test
