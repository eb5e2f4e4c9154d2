// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error_rows.h"

#include "core/identification/discretization.h"

#include <cmath>
#include <utility>

namespace gripscope {

namespace {

constexpr double roundingShare = 1e-9;

/// The position as it is modelled where none was measured.
std::vector<double> modelledPosition(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                     const ScaledNuisance& nuisance)
{
    std::vector<double> force = problem.force;
    for (std::size_t i = 0; i < problem.lost.size(); ++i)
        force[problem.lost[i]] = nuisance.lostForces[i];
    const double lag = static_cast<double>(problem.lag.samples) + problem.lag.rest;
    return simulate(scaledParameters(theta), force,
                    {1, problem.hold, lag, nuisance.x0, nuisance.v0, nuisance.offset});
}

} // namespace

MassDampingStiffness scaledParameters(const Eigen::Vector3d& theta)
{
    return {std::exp(theta(0)), std::exp(theta(1)), std::exp(theta(2))};
}

OutputErrorRows::OutputErrorRows(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                 const ScaledNuisance& nuisance)
    : m_problem(problem), m_theta(theta),
      m_sensitivities(Eigen::MatrixXd::Zero(problem.nuisanceCount() + 3, problem.rows())),
      m_residual(Eigen::RowVectorXd::Zero(problem.rows())), m_modelled(m_residual)
{
    const Eigen::Index own = m_sensitivities.rows();
    const std::ptrdiff_t first = problem.firstRow();
    double square = 0;
    forEachLinearizedRow(problem, theta, nuisance, [&](std::ptrdiff_t t, const Eigen::RowVectorXd& row) {
        const double position = problem.position[static_cast<std::size_t>(t)];
        m_sensitivities.col(t - first) = row.head(own).transpose();
        m_residual(t - first) = row(own);
        m_modelled(t - first) = position - row(own);
        square += position * position;
    });
    m_size = std::sqrt(square);
    if (problem.lost.empty())
        return;
    const std::vector<double> modelled = modelledPosition(problem, theta, nuisance);
    for (std::ptrdiff_t t = first; t < problem.endRow(); ++t)
        m_modelled(t - first) = modelled[static_cast<std::size_t>(t)];
    takeOutLost(nuisance);
}

void OutputErrorRows::takeOutLost(const ScaledNuisance& nuisance)
{
    const Eigen::Index own = m_sensitivities.rows();
    Eigen::MatrixXd series(own + 1, m_residual.size());
    series << m_sensitivities, m_residual;
    series = withoutLostForces(m_problem, m_theta, nuisance.lostForces, series);
    m_sensitivities = series.topRows(own);
    m_residual = series.row(own);
}

Eigen::MatrixXd OutputErrorRows::rowsOf(Eigen::MatrixXd series) const
{
    if (m_problem.lost.empty())
        return series;
    // The priors of the lost forces say nothing of other regressors: their forces are the expected ones.
    return withoutLostForces(m_problem, m_theta, unknownNuisance(m_problem).lostForces, series);
}

bool OutputErrorRows::isRounding() const
{
    return !(m_residual.norm() > roundingShare * m_size) || !m_sensitivities.allFinite();
}

} // namespace gripscope
