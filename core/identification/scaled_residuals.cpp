// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/scaled_residuals.h"

#include "core/identification/fit.h"
#include "core/identification/residual_tests.h"
#include "core/identification/tall_qr.h"

#include <Eigen/QR>

#include <limits>

namespace gripscope {

namespace {

/// Residuals smaller than this share of the positions are rounding, which no test speaks about.
constexpr double roundingShare = 1e-9;

double squaredSum(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

void testResiduals(const ScaledRecord& record, const Eigen::MatrixXd& columns,
                   const std::vector<double>& residuals, ResidualSummary& summary)
{
    const Eigen::Index model = columns.cols();
    constexpr auto extra = static_cast<Eigen::Index>(inputLags.size());
    TallQr qr(model + extra + 1);
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
        const std::ptrdiff_t at = std::max<std::ptrdiff_t>(record.firstRow() + i + record.lag.samples, 0);
        auto row = qr.nextRow();
        row.head(model) = columns.row(i);
        row.segment<extra>(model) = laggedInputs(record.force, static_cast<std::size_t>(at));
        row(model + extra) = residuals[static_cast<std::size_t>(i)];
    }
    const Eigen::MatrixXd triangle = qr.triangle();
    summary.whitenessP = ljungBoxP(residuals, 0);
    summary.inputIndependenceP = extraColumnsP(triangle, extra, static_cast<double>(columns.rows()));
    const Eigen::Index nuisances = record.nuisanceCount();
    const Eigen::Index others = model - nuisances;
    Eigen::MatrixXd own = columns.rightCols(others);
    if (nuisances > 0) {
        const Eigen::MatrixXd explained =
            Eigen::MatrixXd(triangle.topLeftCorner(nuisances, nuisances))
                .colPivHouseholderQr()
                .solve(Eigen::MatrixXd(triangle.block(0, nuisances, nuisances, others)));
        own -= columns.leftCols(nuisances) * explained;
    }
    summary.errorInflation = errorInflation(own, residuals);
}

} // namespace

void describeResiduals(const ScaledRecord& record, const std::vector<double>& position,
                       const Eigen::MatrixXd& columns, const std::vector<double>& residuals,
                       Estimate& estimate)
{
    estimate.residual.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i)
        estimate.residual[i] = position[i] - estimate.simulated[i];
    const auto first = static_cast<std::size_t>(record.firstRow());
    const auto rows = static_cast<std::size_t>(record.rows());
    const std::span<const double> simulated(estimate.simulated);
    estimate.fit.simulationPercent =
        fitPercent(std::span(position).subspan(first, rows), simulated.subspan(first, rows));
    estimate.fit.predictionPercent = estimate.fit.simulationPercent;
    for (const double e : std::span<const double>(estimate.residual).subspan(first, rows))
        estimate.residuals.sse += e * e;
    estimate.residuals.sse = std::min(estimate.residuals.sse, std::numeric_limits<double>::max());
    if (squaredSum(residuals) > roundingShare * roundingShare * squaredSum(record.position))
        testResiduals(record, columns, residuals, estimate.residuals);
}

} // namespace gripscope
