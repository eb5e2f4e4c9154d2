// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/estimate_table.h"

#include "core/words.h"

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

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const QString& graspId, int rank,
                      const Estimate& estimate)
{
    Statement row(database, Words::tr("store the estimate"), insertSql);
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc).bind(graspId).bind(rank);
    row.bind(toString(estimate.estimator)).bind(toString(estimate.status));
    row.bind(QString::fromStdString(estimate.message)).bind(QStringLiteral(GRIPSCOPE_VERSION));
    bindParameters(row, estimate);
    row.bind(estimate.fit.simulationPercent).bind(estimate.fit.predictionPercent);
    row.bind(estimate.residuals.sse).bind(estimate.residuals.degreesOfFreedom);
    row.bind(estimate.residuals.whitenessP).bind(estimate.residuals.inputIndependenceP);
    return row.bind(estimate.iterations).run();
}

} // namespace gripscope::estimate_table
