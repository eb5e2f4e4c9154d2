// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_residuals.h"

#include "core/identification/residual_tests.h"
#include "core/identification/tall_qr.h"

#include <Eigen/QR>

#include <cmath>

namespace gripscope {

namespace {
constexpr double roundingShare = 1e-9;
}

OutputErrorResiduals testOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                     const ScaledNuisance& nuisance)
{
    const Eigen::Index nuisances = problem.nuisanceCount();
    const Eigen::Index model = nuisances + 3;
    constexpr auto extra = static_cast<Eigen::Index>(inputLags.size());
    const std::ptrdiff_t first = problem.firstRow();
    std::vector<double> residuals;
    residuals.reserve(static_cast<std::size_t>(problem.rows()));
    Eigen::MatrixXd sensitivities(problem.rows(), model);
    TallQr qr(model + extra + 1);
    double power = 0;
    double errorPower = 0;
    forEachLinearizedRow(problem, theta, nuisance, [&](std::ptrdiff_t t, const Eigen::RowVectorXd& linear) {
        const double e = linear(model);
        const double y = problem.position[static_cast<std::size_t>(t)];
        power += y * y;
        errorPower += e * e;
        residuals.push_back(e);
        sensitivities.row(t - first) = linear.head(model);
        const std::ptrdiff_t at = std::max<std::ptrdiff_t>(t + problem.lag.samples, 0);
        auto row = qr.nextRow();
        row.head(model) = linear.head(model);
        row.segment<extra>(model) = laggedInputs(problem.force, static_cast<std::size_t>(at));
        row(model + extra) = e;
    });
    OutputErrorResiduals out;
    if (!(errorPower > roundingShare * roundingShare * power))
        return out;
    const Eigen::MatrixXd triangle = qr.triangle();
    out.whitenessP = ljungBoxP(residuals, 0);
    out.inputIndependenceP = extraColumnsP(triangle, extra, static_cast<double>(problem.rows()));
    Eigen::MatrixXd own = sensitivities.rightCols(3);
    if (nuisances > 0) {
        const Eigen::MatrixXd explained =
            triangle.topLeftCorner(nuisances, nuisances)
                .colPivHouseholderQr()
                .solve(Eigen::MatrixXd(triangle.block(0, nuisances, nuisances, 3)));
        own -= sensitivities.leftCols(nuisances) * explained;
    }
    out.errorInflation = errorInflation(own, residuals);
    return out;
}

} // namespace gripscope
