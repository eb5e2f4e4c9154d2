// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/tables/estimate_tables.h"

#include "core/base/words.h"
#include "core/library/sql/rows.h"

#include <cmath>

namespace gripscope::estimate_table {

using namespace Qt::StringLiterals;

namespace {

const auto insertSql =
    u"INSERT INTO estimates (id, station, created_utc, grasp_id, rank, estimator, status, message, program, "
    "m, b, k, var_m, cov_mb, cov_mk, var_b, cov_bk, var_k, x0, v0, position_offset, a1, a2, b1, b2, "
    "constant, "
    "simulation_fit_percent, prediction_fit_percent, sse, degrees_of_freedom, whiteness_p, "
    "input_independence_p, "
    "iterations) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
    "?, ?, "
    "?, ?, ?)"_s;

void bindParameters(Statement& row, const Estimate& estimate)
{
    using Real = std::optional<double>;
    const auto& p = estimate.parameters;
    row.bind(p ? Real(p->m) : Real()).bind(p ? Real(p->b) : Real()).bind(p ? Real(p->k) : Real());
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            row.bind(estimate.covariance ? Real((*estimate.covariance)(i, j)) : Real());
    row.bind(estimate.nuisance.x0).bind(estimate.nuisance.v0).bind(estimate.nuisance.offset);
    const auto& c = estimate.coefficients;
    row.bind(c ? Real(c->a1) : Real()).bind(c ? Real(c->a2) : Real()).bind(c ? Real(c->b1) : Real());
    row.bind(c ? c->b2 : Real()).bind(c ? c->constant : Real());
}

StoredEstimate takeEstimate(Statement& row)
{
    StoredEstimate stored;
    stored.rank = int(row.takeInteger());
    stored.estimator = row.takeText();
    stored.status = row.takeText();
    stored.program = row.takeText();
    stored.stored = row.takeUtc();
    stored.parameters = takeParameters(row);
    stored.standardErrors = takeStandardErrors(row);
    stored.simulationFitPercent = row.takeOptionalReal();
    const bool later = !row.takeText().isEmpty();
    Reidentification how;
    how.hold = forceHoldFromString(row.takeText());
    how.initialState = row.takeText() == u"rest" ? InitialState::Rest : InitialState::Free;
    how.freeOffset = row.takeInteger() != 0;
    how.operatorName = row.takeText();
    if (later)
        stored.again = how;
    return stored;
}

} // namespace

std::optional<MassDampingStiffness> takeParameters(Statement& row)
{
    const auto m = row.takeOptionalReal();
    const auto b = row.takeOptionalReal();
    const auto k = row.takeOptionalReal();
    if (!m || !b || !k)
        return {};
    return MassDampingStiffness{*m, *b, *k};
}

std::optional<Eigen::Vector3d> takeStandardErrors(Statement& row)
{
    const auto m = row.takeOptionalReal();
    const auto b = row.takeOptionalReal();
    const auto k = row.takeOptionalReal();
    if (!m || !b || !k || *m < 0 || *b < 0 || *k < 0)
        return {};
    return Eigen::Vector3d(std::sqrt(*m), std::sqrt(*b), std::sqrt(*k));
}

QString programOf(const NewGrasp& grasp)
{
    return grasp.program.isEmpty() ? QStringLiteral(GRIPSCOPE_VERSION) : grasp.program;
}

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId, int rank,
                      const Estimate& estimate, const QString& program)
{
    Statement row(database, Words::tr("store the estimate"), insertSql);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(rank);
    row.bind(toString(estimate.estimator)).bind(toString(estimate.status));
    row.bind(estimate.message.english()).bind(program);
    bindParameters(row, estimate);
    row.bind(estimate.fit.simulationPercent).bind(estimate.fit.predictionPercent);
    row.bind(estimate.residuals.sse).bind(estimate.residuals.degreesOfFreedom);
    row.bind(estimate.residuals.whitenessP).bind(estimate.residuals.inputIndependenceP);
    return row.bind(estimate.iterations).run();
}

Expected<int> nextRank(Database& database, const QString& graspId)
{
    int rank = 1;
    Statement query(database, Words::tr("store the estimate"),
                    u"SELECT COALESCE(MAX(rank), 0) + 1 FROM estimates WHERE grasp_id = ?"_s);
    auto done = query.bind(graspId).forEach([&](Statement& row) { rank = int(row.takeInteger()); });
    if (!done)
        return tl::unexpected(done.error());
    return rank;
}

Expected<std::vector<StoredEstimate>> ofGrasp(Database& database, const QString& graspId)
{
    Statement query(
        database, Words::tr("read the estimates"),
        u"SELECT e.rank, e.estimator, e.status, e.program, e.created_utc, e.m, e.b, e.k, e.var_m, "
        "e.var_b, e.var_k, e.simulation_fit_percent, r.id, r.force_hold, r.initial_state, "
        "r.free_offset, r.operator_name FROM estimates e LEFT JOIN reidentifications r ON "
        "r.estimate_id = e.id WHERE e.grasp_id = ? ORDER BY e.rank"_s);
    return allRows(query.bind(graspId), takeEstimate);
}

} // namespace gripscope::estimate_table

namespace gripscope::reidentification_table {

using namespace Qt::StringLiterals;

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId,
                      const QString& estimateId, const Reidentification& how)
{
    Statement row(
        database, Words::tr("store the estimate"),
        u"INSERT INTO reidentifications (id, station, created_utc, estimate_id, grasp_id, force_hold, "
        "initial_state, free_offset, operator_name) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(estimateId).bind(graspId);
    row.bind(how.hold ? toString(*how.hold) : QString())
        .bind(how.initialState == InitialState::Free ? u"free"_s : u"rest"_s);
    return row.bind(how.freeOffset ? 1 : 0).bind(how.operatorName).run();
}

} // namespace gripscope::reidentification_table
