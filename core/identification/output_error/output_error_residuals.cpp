// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_noise.h"
#include "core/identification/noise/residual_tests.h"
#include "core/identification/output_error/output_error_search.h"
#include "core/math/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

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

std::span<const double> spanOf(const Eigen::RowVectorXd& row)
{
    return {row.data(), static_cast<std::size_t>(row.size())};
}

/// How (ln M, ln B, ln K) come from the coordinates in the basis; nothing when one of them adds nothing to
/// the others.
std::optional<Eigen::MatrixXd> gainsOf(const OrthonormalRows& rows, Eigen::Index parameters)
{
    const Eigen::Index rank = rows.factor.rows();
    if (rank < 3 || rows.kept[static_cast<std::size_t>(rank - 3)] != parameters - 3)
        return std::nullopt;
    Eigen::MatrixXd gains = Eigen::MatrixXd::Identity(rank, rank);
    rows.factor.transpose().triangularView<Eigen::Upper>().solveInPlace(gains);
    gains = gains.bottomRows(3).eval();
    return gains.allFinite() ? std::optional(std::move(gains)) : std::nullopt;
}

/// Answers of the object to x^2 and x^3, x the modelled position from its mean: what a spring that is not
/// straight adds to the position, to first order.
Eigen::MatrixXd springRows(const Eigen::Vector3d& theta, const OutputErrorRows& data)
{
    Eigen::RowVectorXd x = data.modelled();
    x.array() -= x.mean();
    const double largest = x.cwiseAbs().maxCoeff();
    if (largest > 0)
        x /= largest;
    Eigen::MatrixXd rows(2, x.size());
    std::vector<double> force(static_cast<std::size_t>(x.size()));
    Eigen::RowVectorXd power = x;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        power.array() *= x.array();
        std::copy(power.begin(), power.end(), force.begin());
        const std::vector<double> answer =
            simulate(scaledParameters(theta), force, {1, ForceHold::First, 0, 0, 0, 0});
        rows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(answer.data(), x.size());
    }
    return rows;
}

/// A start or an offset that was taken for none though the position has it: the residuals then hold its free
/// response, which is no noise.
bool lacksNuisance(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                   const OutputErrorRows& data, const Eigen::MatrixXd& model)
{
    constexpr double certain = 0.001;
    const Eigen::Index missing = (problem.freeInitialState ? 0 : 2) + (problem.freeOffset ? 0 : 1);
    if (missing == 0)
        return false;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Ones(missing, problem.rows());
    if (!problem.freeInitialState) {
        const std::vector<double> rest(static_cast<std::size_t>(rows.cols()), 0.0);
        for (Eigen::Index i = 0; i < 2; ++i) {
            const double x0 = i == 0 ? 1 : 0;
            const std::vector<double> answer =
                simulate(scaledParameters(theta), rest, {1, problem.hold, 0, x0, 1 - x0, 0});
            rows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(answer.data(), rows.cols());
        }
    }
    const OrthonormalRows extra = orthonormalize(data.rowsOf(std::move(rows)), model);
    const auto test = testExplained(data.residual(), model, extra.basis);
    return test && test->p < certain;
}

/// The change of ln M, ln B, ln K when the extra regressors are fitted too.
Eigen::Vector3d shiftBy(const OrthonormalRows& extra, const Eigen::RowVectorXd& residual,
                        const Eigen::MatrixXd& gains)
{
    const Eigen::VectorXd coordinates = extra.basis * residual.transpose();
    const Eigen::VectorXd amounts =
        extra.factor.transpose().triangularView<Eigen::Upper>().solve(coordinates);
    return -gains * (extra.against.transpose() * amounts);
}

/// The tests of input, feedback and spring on rows whose noise is white.
class RegressionTests {
public:
    /// `model`: the basis of the sensitivities, for noise that is white already.
    RegressionTests(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                    const OutputErrorRows& data, OrthonormalRows model, const AutoregressiveNoise& noise,
                    const Eigen::Matrix3d& covariance)
        : m_problem(problem), m_data(data), m_noise(noise), m_theta(theta), m_covariance(covariance),
          m_residual(data.residual()), m_model(std::move(model))
    {
        if (isWhite())
            return;
        m_residual = whitened(Eigen::MatrixXd(m_residual), noise);
        m_model = orthonormalize(whitened(data.sensitivities(), noise), {});
    }
    void run(int fittedNumbers, ResidualSummary& summary) const
    {
        summary.innovationWhitenessP = summary.whitenessP;
        if (fittedNumbers > 0 && m_model.basis.rows() >= 3) {
            const Eigen::RowVectorXd left =
                m_residual - (m_residual * m_model.basis.transpose()) * m_model.basis;
            summary.innovationWhitenessP = ljungBoxP(spanOf(left), fittedNumbers, m_model.basis);
            const Eigen::MatrixXd own = m_model.basis.bottomRows(3).transpose();
            summary.innovationInflation = errorInflation(own, spanOf(left));
        }
        testInput(summary);
        testSpring(summary);
    }

private:
    [[nodiscard]] bool isWhite() const { return m_noise.coefficients.empty(); }
    /// What other regressors, given at every sample, add to the model.
    [[nodiscard]] OrthonormalRows news(Eigen::MatrixXd series) const
    {
        Eigen::MatrixXd rows = m_data.rowsOf(std::move(series));
        if (!isWhite())
            rows = whitened(rows, m_noise);
        return orthonormalize(rows, m_model.basis);
    }
    /// Past input beside the model, future input beside both.
    void testInput(ResidualSummary& summary) const
    {
        constexpr auto lags = static_cast<Eigen::Index>(inputLags.size());
        const std::ptrdiff_t first = m_problem.firstRow() + m_problem.lag.samples;
        Eigen::MatrixXd inputs(inputLags.size() + inputLeads.size(), m_problem.rows());
        inputs << pastInputs(m_problem.force, first, m_problem.rows()),
            futureInputs(m_problem.force, first, m_problem.rows());
        const OrthonormalRows added = news(std::move(inputs));
        const auto past =
            std::count_if(added.kept.begin(), added.kept.end(), [](Eigen::Index row) { return row < lags; });
        const double power = m_residual.squaredNorm();
        const Eigen::VectorXd fitted = m_model.basis * m_residual.transpose();
        const Eigen::VectorXd explained = added.basis * m_residual.transpose();
        if (const auto test = testExplained(power, m_residual.size(), fitted, explained.head(past))) {
            summary.inputIndependenceP = test->p;
            summary.inputMisfit = std::sqrt(test->f);
        }
        Eigen::VectorXd both(fitted.size() + past);
        both << fitted, explained.head(past);
        const Eigen::Index future = explained.size() - past;
        if (const auto test = testExplained(power, m_residual.size(), both, explained.tail(future))) {
            summary.feedbackP = test->p;
            summary.feedbackMisfit = std::sqrt(test->f);
        }
    }
    void testSpring(ResidualSummary& summary) const
    {
        const std::optional<Eigen::MatrixXd> gains = gainsOf(m_model, m_data.sensitivities().rows());
        const OrthonormalRows spring = news(springRows(m_theta, m_data));
        const auto test = testExplained(m_residual, m_model.basis, spring.basis);
        if (!gains || !test)
            return;
        const Eigen::Vector3d shift = shiftBy(spring, m_residual, *gains).cwiseAbs();
        const double largest = shift.maxCoeff();
        const Eigen::Vector3d errors = m_covariance.diagonal().cwiseSqrt();
        const double inErrors = shift.cwiseQuotient(errors).maxCoeff();
        if (!std::isfinite(largest) || !std::isfinite(inErrors))
            return;
        summary.linearityP = test->p;
        summary.linearityShift = largest;
        summary.linearityShiftInErrors = inErrors;
    }

    const OutputErrorProblem& m_problem;
    const OutputErrorRows& m_data;
    AutoregressiveNoise m_noise;
    Eigen::Vector3d m_theta;
    Eigen::Matrix3d m_covariance;
    Eigen::RowVectorXd m_residual;
    OrthonormalRows m_model;
};

AutoregressiveNoise inChannelUnits(const OutputErrorProblem& problem, AutoregressiveNoise noise)
{
    noise.innovationDeviation *= problem.positionScale;
    if (noise.forceDeviation)
        *noise.forceDeviation *= problem.forceScale;
    return noise;
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

OutputErrorResiduals testOutputError(const OutputErrorProblem& problem, const Eigen::Vector3d& theta,
                                     const ScaledNuisance& nuisance, ResidualDepth depth)
{
    OutputErrorResiduals out;
    const OutputErrorRows data(problem, theta, nuisance);
    OrthonormalRows model = orthonormalize(data.sensitivities(), {});
    const std::optional<Eigen::MatrixXd> gains = gainsOf(model, data.sensitivities().rows());
    const auto free = static_cast<double>(data.residual().size() - model.basis.rows());
    if (data.isRounding() || !gains || free < 1)
        return out;
    const std::span<const double> residual = spanOf(data.residual());
    out.summary.whitenessP = ljungBoxP(residual, 0, model.basis);
    const double variance = data.residual().squaredNorm() / free;
    const Eigen::Matrix3d white = variance * (*gains * gains->transpose());
    const bool incomplete = lacksNuisance(problem, theta, data, model.basis);
    std::optional<ResidualNoise> found;
    if (!incomplete) {
        found = findResidualNoise(residual, model.basis, *gains,
                                  forceResponse(scaledParameters(theta), 1, problem.hold),
                                  out.summary.whitenessP);
        out.summary.errorInflation = 1;
    }
    if (found) {
        out.noise = inChannelUnits(problem, found->noise);
        out.logCovariance = found->covariance;
        out.summary.errorInflation =
            std::sqrt(found->covariance.diagonal().cwiseQuotient(white.diagonal()).maxCoeff());
    }
    if (depth != ResidualDepth::Tests)
        return out;
    const RegressionTests tests(problem, theta, data, std::move(model),
                                found ? found->noise : AutoregressiveNoise(),
                                found ? found->covariance : white);
    tests.run(found ? found->fittedNumbers : 0, out.summary);
    return out;
}

} // namespace gripscope
