// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/grasp_table.h"

#include "core/base/words.h"
#include "core/calibration/calibration_facts.h"
#include "core/library/records/type_squeeze.h"
#include "core/library/sql/rows.h"
#include "core/library/tables/determined_table.h"
#include "core/library/tables/estimate_tables.h"
#include "core/library/tables/type_tables.h"

namespace gripscope::grasp_table {

using namespace Qt::StringLiterals;

namespace {

QString readingSqueezes()
{
    return Words::tr("read the squeezes");
}

/// Where a squeeze belongs now, what its type is called, and its recommended estimate.
const auto from = u"FROM grasps g "_s + typeJoins() +
                  u"LEFT JOIN estimates e ON e.grasp_id = g.id AND e.rank = 0 "
                  "LEFT JOIN determined_quantities d ON d.grasp_id = g.id "_s;

const auto selectSqueezes =
    u"SELECT g.id, COALESCE(p.type_id, g.type_id), s.name, g.type_id, g.part, g.source, g.operator_name, "
    u"g.recorded_utc, g.force_unit, g.position_unit, "
    "(SELECT COUNT(*) FROM recordings r WHERE r.grasp_id = g.id), COALESCE(p.accepted, 1), "
    "e.estimator, e.m, e.b, e.k, e.var_m, e.cov_mb, e.cov_mk, e.var_b, e.cov_bk, e.var_k, "
    "e.simulation_fit_percent, "_s +
    determined_table::columns + from;

std::optional<Eigen::Matrix3d> takeCovariance(Statement& row)
{
    Eigen::Matrix3d covariance;
    bool complete = true;
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
            const auto value = row.takeOptionalReal();
            complete = complete && value;
            covariance(i, j) = covariance(j, i) = value.value_or(0);
        }
    }
    return complete ? std::optional(covariance) : std::nullopt;
}

GraspRecord takeGrasp(Statement& row)
{
    GraspRecord grasp;
    grasp.id = row.takeText();
    grasp.typeId = row.takeText();
    grasp.typeName = row.takeText();
    grasp.firstTypeId = row.takeText();
    grasp.part = row.takeText();
    grasp.source = row.takeText();
    grasp.operatorName = row.takeText();
    grasp.recorded = row.takeUtc();
    grasp.forceUnit = row.takeText();
    grasp.positionUnit = row.takeText();
    grasp.hasRecording = row.takeInteger() > 0;
    grasp.accepted = row.takeInteger() != 0;
    grasp.estimator = estimatorFromString(row.takeText()).value_or(Estimator::OutputError);
    grasp.parameters = estimate_table::takeParameters(row);
    grasp.covariance = takeCovariance(row);
    grasp.simulationFitPercent = row.takeOptionalReal();
    grasp.determined = determined_table::take(row);
    return grasp;
}

} // namespace

QString typeJoins()
{
    return u"LEFT JOIN placements p ON g.type_id IS NOT NULL AND p.grasp_id = g.id AND p.version = "
           u"(SELECT MAX(q.version) FROM placements q WHERE q.grasp_id = g.id) "
           "LEFT JOIN type_states s ON s.type_id = COALESCE(p.type_id, g.type_id) AND s.version = "
           "(SELECT MAX(w.version) FROM type_states w WHERE w.type_id = COALESCE(p.type_id, g.type_id)) "_s;
}

Expected<void> insert(Database& database, const RowStamp& stamp, const NewGrasp& grasp, qint64 version)
{
    const auto noted = [&grasp](const QString& key) {
        return grasp.recording ? grasp.recording->provenance.value(key) : QString();
    };
    Statement row(
        database, Words::tr("store the squeeze"),
        u"INSERT INTO grasps (id, station, recorded_utc, type_id, operator_name, source, force_unit, "
        "position_unit, part, library_version, device_name, device_serial, firmware, force_calibration, "
        "force_calibration_id, position_calibration, position_calibration_id, utc_offset_s) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bindOrNull(grasp.typeId);
    row.bind(grasp.operatorName)
        .bind(grasp.source)
        .bind(grasp.forceUnit)
        .bind(grasp.positionUnit)
        .bind(grasp.part)
        .bind(version)
        .bind(noted(u"device"_s))
        .bind(noted(u"serial"_s))
        .bind(noted(u"firmware"_s));
    for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position}) {
        const auto note =
            grasp.recording ? calibrationNote(grasp.recording->provenance, channel) : std::nullopt;
        row.bindOptional(note ? std::optional(note->words) : std::nullopt).bind(note ? note->id : QString());
    }
    const qint64 offsetNow_s = QDateTime::currentDateTime().offsetFromUtc();
    row.bindOptional(grasp.recorded.isValid() ? grasp.utcOffset_s : std::optional(offsetNow_s));
    return row.run();
}

Expected<std::vector<GraspRecord>> ofType(Database& database, const QString& typeId)
{
    Statement query(database, readingSqueezes(),
                    selectSqueezes +
                        u"WHERE (g.type_id = ? OR g.id IN (SELECT r.grasp_id FROM placements r WHERE "
                        "r.type_id = ?)) AND COALESCE(p.type_id, g.type_id) = ? "
                        "ORDER BY g.recorded_utc, g.id"_s);
    return allRows(query.bind(typeId).bind(typeId).bind(typeId), takeGrasp);
}

Expected<std::optional<GraspRecord>> find(Database& database, const QString& id)
{
    Statement query(database, readingSqueezes(), selectSqueezes + u"WHERE g.id = ?"_s);
    return firstRow(query.bind(id), takeGrasp);
}

Expected<std::vector<TypeSqueeze>> enrolled(Database& database, Of which)
{
    ASSIGN_OR_RETURN(const auto places, type_table::places(database));
    // A hundred thousand of them are read before the first inspection: no column that is not needed.
    Statement query(
        database, readingSqueezes(),
        u"SELECT COALESCE(p.type_id, g.type_id), s.name, g.type_id, g.part, g.force_unit, g.position_unit, "
        u"e.m, e.b, e.k, e.var_m, e.cov_mb, e.cov_mk, e.var_b, e.cov_bk, e.var_k, "_s +
            determined_table::columns + from +
            u"WHERE g.type_id IS NOT NULL AND (e.m IS NOT NULL OR d.id IS NOT NULL) AND COALESCE(p.accepted, 1) = 1 AND "_s +
            (which == Of::ApprovedTypes ? u"s.status = 'approved'"_s
                                        : u"s.status IN ('enrolled', 'approved')"_s) +
            u" ORDER BY s.name, g.recorded_utc, g.id"_s);
    std::vector<TypeSqueeze> squeezes;
    GraspRecord grasp;
    auto done = query.forEach([&](Statement& row) {
        grasp.typeId = row.takeText();
        grasp.typeName = row.takeText();
        grasp.firstTypeId = row.takeText();
        grasp.part = row.takeText();
        grasp.forceUnit = row.takeText();
        grasp.positionUnit = row.takeText();
        grasp.parameters = estimate_table::takeParameters(row);
        grasp.covariance = takeCovariance(row);
        grasp.determined = determined_table::take(row);
        if (auto squeeze = typeSqueeze(grasp)) {
            squeeze->place = places.value(grasp.typeId, -1);
            squeezes.push_back(std::move(*squeeze));
        }
    });
    if (!done)
        return tl::unexpected(done.error());
    return squeezes;
}

} // namespace gripscope::grasp_table
